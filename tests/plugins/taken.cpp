// SPDX-License-Identifier: MIT
/// \file  A plug-in whose names are taken, or none.
#include "scenario/plugin.hpp"

namespace pilot = eyrie::pilot;

struct Named : pilot::Condition {
  static constexpr std::string_view help = "never holds";
  bool holds(const pilot::Tick&) const override { return false; }
};
struct Pursue final : Named {
  static constexpr std::string_view type_name = "pursue";
};
struct Tree final : Named {
  static constexpr std::string_view type_name = "tree";
};
struct Fresh final : Named {
  static constexpr std::string_view type_name = "fresh";
};

EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) {
  registrar.add<Pursue>();
  registrar.add<Fresh>();
  registrar.add<Fresh>();
  registrar.add<Tree>();
  registrar.add_model("airframes", "f16c", "");
  registrar.add_model("airframe", "mine", "");
  registrar.add_model("radars", "../mine", "");
  registrar.add_model("radars", "mine", "");
  registrar.add_model("radars", "mine", "");
})
