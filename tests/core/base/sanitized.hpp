#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define UNDERGROWTH_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define UNDERGROWTH_SANITIZED
#endif
#endif

namespace undergrowth {

/// Number of repetitions in a test: `plain`, or `sanitized` under a sanitizer. Sanitizers check each path of the code,
/// so further repetitions find nothing there and take ten times as long.
#ifdef UNDERGROWTH_SANITIZED
constexpr int repetitions(int /*plain*/, int sanitized) {
	return sanitized;
}
#else
constexpr int repetitions(int plain, int /*sanitized*/) {
	return plain;
}
#endif

} // namespace undergrowth
