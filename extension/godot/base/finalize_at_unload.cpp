// Compilers add this code to every library of Linux, to run its destructors when it is unloaded. zig's linker omits it
// (ziglang/zig#17908). Without it the engine runs the destructors at its end, after the library is unloaded. A second
// run has no effect.

#if defined(__linux__) && !defined(__ANDROID__)

extern "C" void *__dso_handle;
extern "C" void __cxa_finalize(void *library);

__attribute__((destructor)) static void finalize_at_unload() {
	__cxa_finalize(&__dso_handle);
}

#endif
