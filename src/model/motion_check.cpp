// SPDX-License-Identifier: MIT
#include "model/motion_check.hpp"

#include "core/lanes.hpp"

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
  return std::fabs(b.value) <= b.most;
}
bool all_within(const std::array<Bounded, 12>& all) {
  using Two = math::Lanes<2>;
  auto within = Two(0) <= Two(0);
  for (std::size_t i = 0; i < all.size(); i += 2)
    within = within & (math::abs(Two(Two::Vector{all[i].value, all[i + 1].value})) <=
                       Two(Two::Vector{all[i].most, all[i + 1].most}));
  return math::holds(within, 0) && math::holds(within, 1);
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
  for (std::size_t row = chunk.begin; row < chunk.end; ++row)
    if (!all_within(bounded(motions[row]))) [[unlikely]]
      out.fail({.player = world.ids(table_)[row], .what = motion_problem(motions[row])});
}

}  // namespace eyrie::model
