// SPDX-License-Identifier: MIT
#pragma once

/// \file Two of the three severities of failure (the third, the user's mistake in a file, is
/// ConfigError in core/diagnostics.hpp). Our own mistake ends the program at once; a caller that
/// misuses an interface gets an exception it can show. Expected absence is std::optional, not this.

namespace eyrie::detail {

/// Prints "file:line: words (condition)" to stderr and aborts.
[[noreturn]] void assertion_failed(const char* condition, const char* words, const char* file,
                                   int line) noexcept;
/// Throws std::logic_error with the same text.
[[noreturn]] void misuse(const char* condition, const char* words, const char* file, int line);

}  // namespace eyrie::detail

#if !defined(NDEBUG) || defined(EYRIE_SANITIZED)
#define EYRIE_ASSERT_ENABLED 1
#else
#define EYRIE_ASSERT_ENABLED 0
#endif

/// Our mistake, checked in debug and sanitizer builds only: may stand in a hot path. The condition
/// must have no effect; in other builds it is compiled but never evaluated.
#if EYRIE_ASSERT_ENABLED
#define EYRIE_ASSERT(condition) \
  (static_cast<bool>(condition) \
       ? void()                 \
       : ::eyrie::detail::assertion_failed(#condition, "assertion", __FILE__, __LINE__))
#else
#define EYRIE_ASSERT(condition) static_cast<void>(sizeof(static_cast<bool>(condition)))
#endif

/// Our mistake, checked in every build: for what must not go wrong silently and is not hot.
#define EYRIE_DEMAND(condition, words) \
  (static_cast<bool>(condition)        \
       ? void()                        \
       : ::eyrie::detail::assertion_failed(#condition, words, __FILE__, __LINE__))

/// The caller's mistake in using an interface: throws std::logic_error. Never inside a step.
#define EYRIE_THROW_UNLESS(condition, words) \
  (static_cast<bool>(condition) ? void()     \
                                : ::eyrie::detail::misuse(#condition, words, __FILE__, __LINE__))
