// SPDX-License-Identifier: MIT
/// \file  A plug-in whose texts a terminal would obey.
#include "scenario/plugin.hpp"

namespace pilot = eyrie::pilot;

class Odd final : public pilot::Behavior {
 public:
  static constexpr std::string_view type_name = "odd",
                                    help = "\x1b]0;help\a\x1b[2J of a behavior\r";
  static constexpr auto params() {
    return std::tuple{eyrie::param("course", &Odd::course_, "rad", eyrie::any(),
                                   "\xC2\x9B"
                                   "2J \xE2\x80\xAE of a parameter")};
  }
  pilot::Status tick(const pilot::Tick& t, pilot::Proposal&) const override {
    return fails(t, "\x1b[31mbecause,\n=1+1");
  }

 private:
  double course_ = 0;
};

EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) { registrar.add<Odd>(); })
