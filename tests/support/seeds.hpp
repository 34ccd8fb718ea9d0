// How many of a test's random cases are tried.
#pragma once

#include <cstdint>

#if defined(__SANITIZE_ADDRESS__)
#define LCPUSH_TEST_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define LCPUSH_TEST_SANITIZED 1
#endif
#endif

namespace lcpush {

#ifdef LCPUSH_TEST_SANITIZED
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif

/// `all`, or a tenth of them under the sanitizers: what these look for, a few cases show, and each
/// takes them ten times as long.
constexpr std::uint64_t seeds(std::uint64_t all) { return is_sanitized ? all / 10 : all; }

} // namespace lcpush
