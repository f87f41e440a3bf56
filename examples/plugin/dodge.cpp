// SPDX-License-Identifier: MIT
#include "scenario/plugin.hpp"
namespace pilot = eyrie::pilot;

/// Turns its back on the first aircraft that is too near.
class Dodge final : public pilot::Behavior {
 public:
  static constexpr std::string_view type_name = "dodge", help = "turns its back on who is near";
  static constexpr auto params() {
    return std::tuple{eyrie::param("within", &Dodge::within_, "m", eyrie::positive(), "how near"),
                      eyrie::param("vote", &Dodge::vote_, eyrie::range(0, 1000), "how strongly")};
  }
  pilot::Status tick(const pilot::Tick& t, pilot::Proposal& out) const override {
    for (const pilot::Seen& other : t.state.tracks_seen())
      if (other.range < within_) {
        out.action.heading = eyrie::wrap_tau(pilot::bearing_of(other.ned) + eyrie::kPi);
        out.action.mode = eyrie::model::AutopilotMode::hold;
        out.vote = vote_;
        return pilot::Status::running;
      }
    return pilot::Status::failure;
  }

 private:
  double within_ = eyrie::si(5, "nmi");
  float vote_ = 20;
};
EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) { registrar.add<Dodge>(); })
