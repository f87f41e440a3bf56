// SPDX-License-Identifier: MIT
/// \file  Any text as a condition in words: it is refused with a message that a terminal can show,
/// or it holds or does not, and its negation the other way round.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "core/diagnostics.hpp"
#include "core/text.hpp"
#include "fuzz/demand.hpp"
#include "ubf/expression.hpp"

namespace {

struct State {
  double range = 9 * 1852.0, altitude = 3000;
  int count = 2;
  bool alarm = true;
};
constexpr std::string_view kPhases[] = {"home", "fetch", "carry"};

}  // namespace

template <>
struct eyrie::ubf::StateFields<State> : eyrie::ubf::FieldsOf<State> {
  static std::span<const StateField<State>> all() {
    static const StateField<State> kFields[] = {
        number("range", "m", "to the target", [](const State& s) { return s.range; }),
        number("altitude", "m", "above the ground", [](const State& s) { return s.altitude; }),
        number("count", {}, "of things", [](const State& s) { return double(s.count); }),
        number("unknown", "rad", "never known", [](const State&) { return kNoValue; }),
        flag("alarm", "is there one", [](const State& s) { return s.alarm ? 1.0 : 0.0; }),
        {{.name = "phase",
          .kind = FieldKind::choice,
          .unit = {},
          .help = "of the work",
          .choices = kPhases},
         [](const State&) { return 1.0; }}};
    return kFields;
  }
};

namespace {

using namespace eyrie;
using fuzz::demand;

/// Whether it holds, or nothing if it was refused.
std::optional<bool> read(const std::string& text) {
  const auto infos = ubf::state_field_infos<State>();
  ubf::FieldNames names;
  Diagnostics diagnostics;
  const auto program =
      ubf::parse_expression(Value::scalar(text, {"t.yaml", 1, 1}), infos, names, diagnostics);
  demand(program.has_value() == diagnostics.ok());
  for (const Diagnostic& one : diagnostics.sorted())
    demand(!one.message.empty() && one.text().size() < 5000 && printable(one.text()) == one.text());
  if (!program)
    return std::nullopt;
  return ubf::Expression<State>(*program).holds({});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  static_cast<void>(ubf::looks_like_expression(text));
  if (const auto holds = read(text))
    if (const auto negated = read("not (" + text + ")"))  // or nested too deep now
      demand(*negated != *holds);
  return 0;
}
