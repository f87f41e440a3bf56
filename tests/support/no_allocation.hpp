// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace eyrie {

/// Fails the running test if the heap was used while it lived: by this thread, or by any thread
/// with Scope::process. Every test executable links the counting operator new and delete behind it;
/// under the address and thread sanitizers, which have their own, it counts with their hooks.
/// Should a build defeat both, it says so on stderr and `counts()` is false.
///
///     NoAllocation guard;
///     simulation.step(world);
class NoAllocation {
 public:
  enum class Scope : std::uint8_t { thread, process };

  explicit NoAllocation(Scope scope = Scope::thread);
  ~NoAllocation();
  NoAllocation(const NoAllocation&) = delete;
  NoAllocation& operator=(const NoAllocation&) = delete;

  /// Allocations and frees since the guard was made.
  [[nodiscard]] std::uint64_t count() const;
  /// What was counted is known and right: do not fail.
  void dismiss() { armed_ = false; }
  /// Whether an allocation is seen in this build; tried out, not assumed.
  [[nodiscard]] static bool counts();

 private:
  Scope scope_;
  bool armed_ = true;
  std::uint64_t before_;
};

}  // namespace eyrie
