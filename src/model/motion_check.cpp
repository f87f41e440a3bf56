// SPDX-License-Identifier: MIT
#include "model/motion_check.hpp"

namespace eyrie::model {
namespace {

struct Bounded {
  std::string_view name, unit;
  double value, most;
};

[[nodiscard]] std::array<Bounded, 12> bounded(const Kinematics& m) {
  constexpr double kFar = 1e8, kFast = 1e5, kTurned = 100;
  return {{{"position.x", " m", m.position.x, kFar},
           {"position.y", " m", m.position.y, kFar},
           {"position.z", " m", m.position.z, kFar},
           {"velocity.x", " m/s", m.velocity.x, kFast},
           {"velocity.y", " m/s", m.velocity.y, kFast},
           {"velocity.z", " m/s", m.velocity.z, kFast},
           {"altitude", " m", m.altitude, kFar},
           {"heading", " rad", m.heading, kTurned},
           {"pitch", " rad", m.pitch, kTurned},
           {"roll", " rad", m.roll, kTurned},
           {"speed", " m/s", m.speed, kFast},
           {"load_factor", " g", m.load_factor, 1e4}}};
}

bool within(const Bounded& b) {
  return b.value >= -b.most && b.value <= b.most;
}

}  // namespace

std::string motion_problem(const Kinematics& motion) {
  for (const Bounded& b : bounded(motion))
    if (!within(b))
      return fmt::format("kinematics.{} is {}{}", b.name, b.value, b.unit);
  return {};
}

void MotionCheck::move(sim::World& world, const sim::StepInfo&, sim::Chunk chunk,
                       sim::Outbox& out) const {
  const auto motions = std::as_const(world).rows(kinematics_);
  for (std::size_t row = chunk.begin; row < chunk.end; ++row) {
    // the bits of positive doubles are in the order of the doubles, NaN behind infinity
    std::uint64_t beyond = 0;
    for (const Bounded& b : bounded(motions[row]))
      beyond |= std::bit_cast<std::uint64_t>(b.most) -
                (std::bit_cast<std::uint64_t>(b.value) & ~(std::uint64_t{1} << 63));
    if (beyond >> 63 != 0) [[unlikely]]
      out.fail({.player = world.ids(table_)[row], .what = motion_problem(motions[row])});
  }
}

}  // namespace eyrie::model
