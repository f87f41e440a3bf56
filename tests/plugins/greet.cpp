// SPDX-License-Identifier: MIT
/// \file  The behavior of README.md as a plug-in.
#include "scenario/plugin.hpp"
namespace pilot = eyrie::pilot;

/// Rocks its wings at whoever is near.
class Greet final : public pilot::Behavior {
 public:
  static constexpr std::string_view type_name = "greet";
  static constexpr std::string_view help = "turns a little towards the nearest aircraft";
  static constexpr auto params() {
    return std::tuple{
        eyrie::param("within", &Greet::within_, "m", eyrie::range(0, 50e3), "greets nobody beyond"),
        eyrie::param("vote", &Greet::vote_, eyrie::range(0, 1000), "how strongly")};
  }
  pilot::Status tick(const pilot::Tick& t, pilot::Proposal& out) const override {
    for (const pilot::Seen& seen : t.state.tracks_seen())
      if (seen.range < within_) {
        out.action.heading = eyrie::wrap_tau(pilot::bearing_of(seen.ned));
        out.vote = vote_;
        return pilot::Status::running;
      }
    return pilot::Status::failure;
  }

 private:
  double within_ = eyrie::si(5, "nmi");
  float vote_ = 15;
};
EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) { registrar.add<Greet>(); })
