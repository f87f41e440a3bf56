// SPDX-License-Identifier: MIT
#pragma once
/// \file  operator new that fails once, or at which a signal comes.
#include <cstdint>

namespace eyrie::test {

/// Allocations of this process so far.
[[nodiscard]] std::uint64_t allocations();
/// From now on, at the `n`-th one: no memory, or that `signal`. 0: never.
void at_allocation(std::uint64_t n, int signal);

}  // namespace eyrie::test
