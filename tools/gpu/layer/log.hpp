#pragma once

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <mutex>

/// The text file that UNDERGROWTH_GPU_LOG names. tools/gpu/log.py reads it; the measured script writes its own lines
/// between those of the layer.
namespace gpu {

class Log {
public:
	Log() {
		const char *path = std::getenv("UNDERGROWTH_GPU_LOG");
		file = path ? std::fopen(path, "a") : nullptr;
	}

	/// Writes a line at the end of the file. From any thread.
	void line(const char *format, ...) {
		if (!file) {
			return;
		}
		const std::lock_guard<std::mutex> guard(mutex);
		std::va_list arguments;
		va_start(arguments, format);
		std::vfprintf(file, format, arguments);
		va_end(arguments);
		std::fputc('\n', file);
		std::fflush(file);
	}

private:
	std::FILE *file;
	std::mutex mutex;
};

inline Log log;

} // namespace gpu
