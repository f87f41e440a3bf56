// SPDX-License-Identifier: MIT
/// \file  A plug-in whose nodes and parameters have names that mean something else, or nothing.
#include "scenario/plugin.hpp"

namespace pilot = eyrie::pilot;

struct Named : pilot::Condition {
  static constexpr std::string_view help = "never holds";
  bool holds(const pilot::Tick&) const override { return false; }
};
struct Nameless final : Named {
  static constexpr std::string_view type_name = "";
};
struct Path final : Named {
  static constexpr std::string_view type_name = "a/b[0]";
};
struct Flag final : Named {
  static constexpr std::string_view type_name = "leads";
};
struct Number final : Named {
  static constexpr std::string_view type_name = "range";
};

struct Sentence final : Named {
  static constexpr std::string_view type_name = "range < 10 nmi";
};
struct Not final : Named {
  static constexpr std::string_view type_name = "not";
};
struct Unmade final : Named {
  static constexpr std::string_view type_name = "unmade";
  Unmade() { throw std::runtime_error("no licence"); }
};
struct Unfit final : Named {
  static constexpr std::string_view type_name = "unfit";
  static constexpr auto params() {
    return std::tuple{
        eyrie::param("below", &Unfit::below, "m", eyrie::range(0, 100), "its default is above")};
  }
  double below = 200;
};

/// Two parameters of one name, one with that of the label.
struct Twice final : Named {
  static constexpr std::string_view type_name = "twice";
  static constexpr auto params() {
    return std::tuple{eyrie::param("than", &Twice::than, "m", eyrie::positive(), "how high"),
                      eyrie::param("than", &Twice::for_long, "s", eyrie::positive(), "how long"),
                      eyrie::param("name", &Twice::order, eyrie::range(0, 9), "which")};
  }
  double than = 1, for_long = 1, order = 1;
};

EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) {
  registrar.add<Nameless>();
  registrar.add<Path>();
  registrar.add<Flag>();
  registrar.add<Number>();
  registrar.add<Twice>();
  registrar.add<Sentence>();
  registrar.add<Not>();
  registrar.add<Unmade>();
  registrar.add<Unfit>();
})
