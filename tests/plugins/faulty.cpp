// SPDX-License-Identifier: MIT
/// \file  A plug-in that does in a decision what it must not, from a time on.
#include <cstdlib>
#include <exception>
#include <limits>
#include <stdexcept>

#include "scenario/plugin.hpp"

namespace pilot = eyrie::pilot;

/// Apart, so that no compiler sees where it ends.
[[gnu::noinline]] static void run_dry() {
  throw std::runtime_error("no fuel");
}

class Misbehave final : public pilot::Behavior {
 public:
  static constexpr std::string_view type_name = "misbehave", help = "does what it must not";
  static constexpr auto params() {
    return std::tuple{eyrie::param("how", &Misbehave::how_, eyrie::range(0, 99), "what"),
                      eyrie::param("from", &Misbehave::from_, "s", eyrie::range(0, 1e6), "when")};
  }
  pilot::Status tick(const pilot::Tick& t, pilot::Proposal& out) const override {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    out.action.mode = eyrie::model::AutopilotMode::hold;
    out.action.heading = 1.0;
    out.vote = 30;
    if (t.time < from_)
      return pilot::Status::running;
    switch (how_) {
      case 0:
        out.action.heading = kNan;
        break;
      case 1:
        out.action.heading = kInfinity;
        break;
      case 2:
        out.action.altitude = -kInfinity;
        break;
      case 3:
        out.action.speed = 1e300;
        break;
      case 4:
        out.action.load_factor = -1e9;
        break;
      case 5:
        out.action.follow = pilot::Follow{.velocity = {0, kNan, 0}};
        break;
      case 6:
        out.action.mode = static_cast<eyrie::model::AutopilotMode>(99);
        break;
      case 7:
        out.action.call = static_cast<pilot::Call>(55);
        break;
      case 10:
        out.vote = std::numeric_limits<float>::quiet_NaN();
        break;
      case 11:
        out.vote = -1;
        break;
      case 12:
        out.vote = std::numeric_limits<float>::infinity();
        break;
      case 13:
        return static_cast<pilot::Status>(7);
      case 20:
        throw std::runtime_error("no fuel");
      case 21:
        throw 42;
      case 30:
        std::exit(0);
      case 31:
        std::quick_exit(0);
      case 32:
        std::terminate();
      case 33:
        []() noexcept { run_dry(); }();
        break;
      default:
        break;
    }
    return pilot::Status::running;
  }

 private:
  std::uint32_t how_ = 0;
  double from_ = 1;
};

/// Otherwise every time that it is asked.
class Once final : public pilot::Behavior {
 public:
  static constexpr std::string_view type_name = "once", help = "throws at its 30th tick only";
  pilot::Status tick(const pilot::Tick&, pilot::Proposal& out) const override {
    static int ticks = 0;
    if (++ticks == 30)
      throw std::runtime_error("thirty");
    out.action.heading = 0.001 * ticks;
    out.vote = 30;
    return pilot::Status::running;
  }
};

bool registered = false;

class Unborn final : public pilot::Behavior {
 public:
  static constexpr std::string_view type_name = "unborn", help = "cannot be made";
  Unborn() {
    if (registered)
      throw std::runtime_error("no licence found");
  }
  pilot::Status tick(const pilot::Tick&, pilot::Proposal&) const override {
    return pilot::Status::failure;
  }
};

EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) {
  registered = false;  // a campaign loads its scenario more than once
  registrar.add<Misbehave>();
  registrar.add<Once>();
  registrar.add<Unborn>();
  registered = true;
})
