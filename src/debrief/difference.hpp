// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where two recorded runs part: in the world, in what agents ask for, and in events.
#include <optional>
#include <string>

#include "debrief/recorded.hpp"

namespace eyrie::debrief {

/// A place where the runs differ for the first time.
struct Parting {
  std::uint64_t step = 0;
  double time = 0;  ///< s
  std::string text;
};

struct RunDifference {
  std::optional<Parting> world, action, event;
  std::uint64_t steps = 0;  ///< that were compared
  [[nodiscard]] bool same() const { return !world && !action && !event; }
};

/// Flies both again, step by step, until all three have parted or one ends. `problem` says why two
/// runs cannot be compared: their worlds have other tables.
[[nodiscard]] std::optional<RunDifference> compare(const Recorded& left, const Recorded& right,
                                                   std::string& problem);

}  // namespace eyrie::debrief
