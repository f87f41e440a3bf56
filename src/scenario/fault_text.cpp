// SPDX-License-Identifier: MIT
#include "scenario/fault_text.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "scenario/end_guard.hpp"
#include "scenario/plugin_file.hpp"
#include "team/moment.hpp"

namespace eyrie::scenario {

std::string fault_text(const sim::Fault& fault, const Roster& roster, double dt) {
  std::string who = fault.agent;
  if (const std::string plugin = plugin_at(fault.node); !plugin.empty())
    who += fmt::format(", from {},", shell_word(std::filesystem::path(plugin).filename().string()));
  const std::string name = fault.player ? roster.name(fault.player) + " at " : "";
  return fmt::format("{}{:.2f} s (step {}): {}{}{}", name, static_cast<double>(fault.step) * dt,
                     fault.step, who, who.empty() ? "" : " ", fault.what);
}

sim::Fault fault_of_end(const std::string& done) {
  const team::Underway* now = team::underway();
  if (!now)
    return {.what = done};
  return {.player = now->player,
          .what = fmt::format("{} in a decision of tree '{}'", done, now->tree),
          .step = now->step};
}

}  // namespace eyrie::scenario
