// SPDX-License-Identifier: MIT
#include "sim/trail.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace eyrie::sim {

namespace {

std::uint32_t steps_per_second(double dt) {
  return static_cast<std::uint32_t>(std::clamp(std::nearbyint(1 / dt), 1.0, 1e9));
}

bool is_mark(std::uint64_t step, std::uint64_t first, std::uint32_t steps_per_mark) {
  return (step - first) % steps_per_mark == 0;
}

}  // namespace

void TrailRecorder::begin(const World& world, double dt) {
  trail_ = {
      .first_step = world.step(), .steps_per_mark = steps_per_second(dt), .folds = {}, .marks = {}};
  mark(world, world.hash());
}

void TrailRecorder::observe(const World& world, const StepInfo&, std::span<const Event>) {
  const bool marks = is_mark(world.step(), trail_.first_step, trail_.steps_per_mark);
  if (!marks && detail_ == TrailDetail::marks_only)
    return;
  const std::uint64_t hash = world.hash();
  if (detail_ == TrailDetail::every_step)
    trail_.folds.push_back(fold(hash));
  if (marks)
    mark(world, hash);
}

void TrailRecorder::finish(const World& world) {
  if (trail_.marks.empty() || trail_.marks.back().step != world.step())
    mark(world, world.hash());
}

void TrailRecorder::mark(const World& world, std::uint64_t hash) {
  trail_.marks.push_back({.step = world.step(), .hash = hash, .digest = digest(world)});
}

void TrailChecker::begin(const World& world, double dt) {
  if (world.step() != expected_.first_step)
    return depart(world.step(), fmt::format("the replay begins at step {}, the recording at {}",
                                            world.step(), expected_.first_step));
  if (steps_per_second(dt) != expected_.steps_per_mark)
    return depart(world.step(),
                  fmt::format("the replay makes {} steps per second, the recording {}",
                              steps_per_second(dt), expected_.steps_per_mark));
  check_mark(world);
}

void TrailChecker::observe(const World& world, const StepInfo& info, std::span<const Event>) {
  if (done())
    return;
  const std::uint64_t index = info.step - expected_.first_step;
  if (!departure_ && index < expected_.folds.size()) {
    if (expected_.folds[index] == fold(world.hash()))
      last_good_ = world.step();
    else
      depart(world.step(), fmt::format("the worlds part at step {}", world.step()));
  }
  check_mark(world);
  const bool over = expected_.marks.empty() || world.step() > expected_.marks.back().step;
  if (over && !departure_)
    depart(world.step(), fmt::format("the recording ends at step {}, the replay goes on",
                                     expected_.marks.empty() ? 0 : expected_.marks.back().step));
}

void TrailChecker::finish(const World& world) {
  finished_ = true;
  if (!departure_ && next_mark_ < expected_.marks.size())
    depart(world.step(), fmt::format("the replay ends at step {}, the recording goes on to {}",
                                     world.step(), expected_.marks.back().step));
}

void TrailChecker::check_mark(const World& world) {
  if (next_mark_ == expected_.marks.size() || expected_.marks[next_mark_].step != world.step())
    return;
  const HashTrail::Mark& mark = expected_.marks[next_mark_++];
  if (mark.hash == world.hash()) {
    last_good_ = world.step();
    return;
  }
  if (!departure_)
    depart(world.step(), last_good_ ? fmt::format("the worlds part between steps {} and {}",
                                                  *last_good_, world.step())
                                    : fmt::format("the worlds differ from the start"));
  departure_->where = compare(world.schema(), mark.digest, digest(world));
  if (departure_->where)
    departure_->reason += "; " + departure_->where->text();
}

void TrailChecker::depart(std::uint64_t step, std::string reason) {
  departure_ = Departure{
      .step = step, .last_good = last_good_, .where = std::nullopt, .reason = std::move(reason)};
}

}  // namespace eyrie::sim
