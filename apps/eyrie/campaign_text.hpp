// SPDX-License-Identifier: MIT
#pragma once
/// \file  The results of a campaign on a terminal.
#include "campaign/compare.hpp"

namespace eyrie::app {

/// "14 s", "3 min", "2 h 05 min"
[[nodiscard]] std::string duration_text(double seconds);

/// A row per cell with every measure and its interval, and the first faults.
void print_cells(const campaign::Summary& summary);
/// So many of them, the surest first.
void print_comparisons(const campaign::Summary& summary,
                       const std::vector<campaign::Comparison>& comparisons, std::size_t most);
void print_effects(const campaign::Summary& summary, const std::vector<campaign::Effect>& effects,
                   const std::vector<campaign::Interaction>& interactions);

}  // namespace eyrie::app
