// What compilers put into every library of Linux to run its destructors when it is unloaded. zig's linker leaves it out
// (ziglang/zig#17908): the engine would run them at its end, when the library is gone. Running them twice does nothing.

#if defined(__linux__)

extern "C" void *__dso_handle;
extern "C" void __cxa_finalize(void *library);

__attribute__((destructor)) static void finalize_at_unload() {
	__cxa_finalize(&__dso_handle);
}

#endif
