// Opens the library that is named as Windows does for the engine, asks for its entry, and closes it again.

#include <cstdio>

#ifdef _WIN32
#include <windows.h>

int main(int count, char **words) {
	const HMODULE library = count == 3 ? LoadLibraryA(words[1]) : nullptr;
	if (!library) {
		std::printf("not opened: error %lu\n", count == 3 ? GetLastError() : 0ul);
		return 1;
	}
	const bool has_entry = GetProcAddress(library, words[2]) != nullptr;
	const bool is_closed = FreeLibrary(library) && !GetModuleHandleA(words[1]);
	std::printf("opened, %s, %s\n", has_entry ? "entry found" : "no entry", is_closed ? "closed" : "still open");
	return has_entry && is_closed ? 0 : 1;
}
#else
int main() {
	return 1;
}
#endif
