// SPDX-License-Identifier: MIT
/// \file  A plug-in with behaviors for pilots and drivers, an arbiter and a model;
/// docs/howto/write-a-plugin.md shows its end.
#include "scenario/plugin.hpp"

namespace pilot = eyrie::pilot;
namespace ubf = eyrie::ubf;

class HoldCourse final : public pilot::Behavior {
 public:
  static constexpr std::string_view type_name = "hold_course", help = "flies straight on";
  static constexpr auto params() {
    return std::tuple{
        eyrie::param("course", &HoldCourse::course_, "rad", eyrie::any(), "true heading")};
  }
  pilot::Status tick(const pilot::Tick&, pilot::Proposal& out) const override {
    out.action.heading = course_;
    out.action.mode = eyrie::model::AutopilotMode::hold;
    out.vote = 30;
    return pilot::Status::running;
  }

 private:
  double course_ = 0;
};

/// Asks everybody and takes the last answer.
class LastWord final : public ubf::Arbiter<pilot::State, pilot::Action> {
 public:
  static constexpr std::string_view type_name = "last_word", help = "the proposal of the last";
  using Arbiter::Arbiter;

  pilot::Status tick(const pilot::Tick& t, pilot::Proposal& out) const override {
    pilot::Status status = pilot::Status::failure;
    pilot::Proposal next;
    for (const auto& child : children_) {
      const pilot::Status answer = ask(*child, t, next);
      if (answer == pilot::Status::failure)
        continue;
      out.copy(next);
      status = answer;
    }
    rescale(out);
    return status;
  }
};

/// For drivers: a plug-in may serve both platforms.
class Halt final : public eyrie::driver::Behavior {
 public:
  static constexpr std::string_view type_name = "halt", help = "stands";
  eyrie::driver::Status tick(const eyrie::driver::Tick&,
                             eyrie::driver::Proposal& out) const override {
    out.action.speed = 0;
    out.vote = 5;
    return eyrie::driver::Status::running;
  }
};

EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) {
  registrar.add<HoldCourse>();
  registrar.add<LastWord>();
  registrar.add<Halt>();
  registrar.add_model("aircraft", "f16_without_radar", "base: f16c\nradar: null\n");
})
