// Godot opens libraries so that they see their own symbols first (RTLD_DEEPBIND); a sanitizer's must come before
// theirs. Preloaded, this takes that flag from all calls. And libraries stay, so that leaks that are found at the end
// have names.

#include <dlfcn.h>

extern "C" void *dlopen(const char *path, int flags) noexcept {
	using Open = void *(*)(const char *, int);
	static const Open next = reinterpret_cast<Open>(dlsym(RTLD_NEXT, "dlopen"));
	return next(path, (flags & ~RTLD_DEEPBIND) | RTLD_NODELETE);
}
