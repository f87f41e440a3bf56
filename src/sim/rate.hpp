// SPDX-License-Identifier: MIT
#pragma once
/// \file  Things that happen less often than the step, staggered so that players take turns.
#include <cstdint>
#include <string>

#include "core/assert.hpp"
#include "core/id.hpp"

namespace eyrie::sim {

/// True in one of every `period` steps, in another one for the next id, so that the work of a
/// period spreads over its steps. A player born late is first due at most period - 1 steps later.
/// `period` is in steps and at least 1 (period_steps() never gives 0).
[[nodiscard]] inline bool due(std::uint64_t step, PlayerId id, std::uint32_t period) {
  EYRIE_ASSERT(period != 0);
  return period <= 1 || (step + id.value) % period == 0;
}

/// The first step at or after `step` at which `id` is due.
[[nodiscard]] inline std::uint64_t next_due(std::uint64_t step, PlayerId id, std::uint32_t period) {
  EYRIE_ASSERT(period != 0);
  const std::uint64_t late = (step + id.value) % period;
  return late == 0 ? step : step + (period - late);
}

/// A period in whole steps, or why there is none.
struct Period {
  std::uint32_t steps = 0;
  std::string error;  ///< empty if `steps` is good
  explicit operator bool() const { return error.empty(); }
};

/// How many steps of `dt` seconds lie between two happenings at `rate` (Hz). Refuses, with a text
/// that names the nearest rates that fit, a rate that is not positive and finite, that is faster
/// than one per step, that the base rate 1/dt is no whole multiple of, or slower than one per hour.
[[nodiscard]] Period period_steps(double rate, double dt);

}  // namespace eyrie::sim
