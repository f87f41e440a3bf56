// SPDX-License-Identifier: MIT
/// \file  Any bytes as a quantity of every dimension: never a crash, never a number that is not
/// finite, never an error that a terminal would obey, and what is accepted reads back exactly.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/diagnostics.hpp"
#include "core/units.hpp"
#include "fuzz/demand.hpp"

namespace {

using namespace eyrie;
using fuzz::demand;

void check_error(const Parsed& parsed) {
  demand(parsed.value == 0);
  demand(!parsed.error.empty() && parsed.error.size() < 1000);
  for (const char c : parsed.error)
    demand(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
}

void check_value(double value, Dimension dimension) {
  demand(std::isfinite(value));
  const Parsed back = parse_quantity(exact_quantity(value, dimension), dimension);
  // below the normal range SI may itself not be readable: from_chars reports underflow
  const bool normal = value == 0 || std::fpclassify(value) == FP_NORMAL;
  demand(!normal || (back && back.value == value));
  demand(!format_quantity(value, dimension).empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (int d = 0; d <= static_cast<int>(Dimension::fuel_consumption); ++d) {
    const auto dimension = static_cast<Dimension>(d);
    const Parsed parsed = parse_quantity(text, dimension);
    if (parsed)
      check_value(parsed.value, dimension);
    else
      check_error(parsed);
  }
  constexpr std::array<std::string_view, 3> kNames{"danger_range", "vote", "mode"};
  const std::string hint = did_you_mean(text, kNames);
  demand(hint.empty() || std::any_of(kNames.begin(), kNames.end(), [&](std::string_view name) {
           return hint.find(name) != hint.npos;
         }));
  return 0;
}
