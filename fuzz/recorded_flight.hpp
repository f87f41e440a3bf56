// SPDX-License-Identifier: MIT
#pragma once
#include "debrief/recorded.hpp"
#include "fuzz/named_flight.hpp"

namespace eyrie::fuzz {

/// The flight as a recorded run, named by further texts where it was not yet.
[[nodiscard]] inline debrief::Recorded recorded(Texts& texts) {
  debrief::Recorded r;
  r.scenario = std::make_shared<scenario::Scenario>(flight().scenario());
  r.run.seed = r.scenario->spec.seed;
  r.run.trail = flight().trail();
  r.run.scenario = texts.next();
  r.run.build = texts.next();
  r.run.outcome = texts.next();
  return r;
}

/// Without the numbers of siblings of one name, `root/a[1]`.
[[nodiscard]] inline std::string without_numbers(std::string_view path) {
  std::string text;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::size_t end = path.find_first_not_of("0123456789", i + 1);
    if (path[i] == '[' && end != path.npos && end > i + 1 && path[end] == ']')
      i = end;
    else
      text += path[i];
  }
  return text;
}

}  // namespace eyrie::fuzz
