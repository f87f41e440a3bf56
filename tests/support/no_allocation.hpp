// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace eyrie {

/// Fails the running test if anything was allocated or freed on the heap while it lived: by this
/// thread, or by any thread with Scope::process. Every test executable links the counting
/// operator new and delete behind it (and malloc hooks under a sanitizer, where operator new is
/// taken).
class NoAllocation {
 public:
  enum class Scope : std::uint8_t { thread, process };

  explicit NoAllocation(Scope scope = Scope::thread);
  ~NoAllocation();
  NoAllocation(const NoAllocation&) = delete;
  NoAllocation& operator=(const NoAllocation&) = delete;

  /// Allocations and frees so far.
  [[nodiscard]] std::uint64_t count() const;
  /// Says that what was counted is known: the guard will not fail.
  void dismiss() { armed_ = false; }
  /// Whether this build can count at all; if not, the guard says so and checks nothing.
  [[nodiscard]] static bool counts();

 private:
  Scope scope_;
  bool armed_ = true;
  std::uint64_t before_;
};

}  // namespace eyrie
