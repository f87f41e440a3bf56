// SPDX-License-Identifier: MIT
#include "sim/trail.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace eyrie::sim {

namespace {

std::uint32_t steps_in_a_second(double dt) {
  return static_cast<std::uint32_t>(std::clamp(std::nearbyint(1 / dt), 1.0, 1e9));
}

}  // namespace

std::optional<HashTrail> trail_of(std::string spans, std::uint32_t steps_per_second) {
  TrailUnpacker span(spans, steps_per_second);
  bool any = false;
  while (span.next())
    any = true;
  if (!any || !span.ok())
    return std::nullopt;
  return HashTrail{steps_per_second, std::move(spans), span.mark().step, span.mark().hash};
}

HashTrail without_digests(const HashTrail& trail) {
  TrailUnpacker span(trail.spans, trail.steps_per_second);
  TrailPacker packer(trail.steps_per_second);
  std::uint64_t step = 0;
  while (span.next()) {
    for (++step; step <= span.mark().step; ++step)
      if (span.has_fold(step))
        packer.fold(span.fold(step));
    step = span.mark().step;
    packer.mark({.step = step, .hash = span.mark().hash});
  }
  return {trail.steps_per_second, packer.take(), trail.last_step, trail.last_hash};
}

void TrailRecorder::begin(const World& world, double dt) {
  steps_per_second_ = steps_in_a_second(dt);
  packer_ = TrailPacker(steps_per_second_);
  mark(world, world.hash());
}

void TrailRecorder::observe(const World& world, const StepInfo&, std::span<const Event>) {
  const bool folds = packer_.is_fold(world.step());
  const bool marks = is_mark(world.step(), steps_per_second_);
  if (!folds && !marks)
    return;
  const std::uint64_t hash = world.hash();
  if (folds)
    packer_.fold(fold(hash));
  if (marks)
    mark(world, hash);
}

void TrailRecorder::finish(const World& world) {
  if (mark_.step != world.step())
    mark(world, world.hash());
}

void TrailRecorder::mark(const World& world, std::uint64_t hash) {
  mark_.step = world.step();
  mark_.hash = hash;
  digest(world, mark_.digest);
  packer_.mark(mark_);
}

TrailChecker::TrailChecker(const HashTrail& expected)
    : expected_(expected), span_(expected.spans, expected.steps_per_second) {
  more_ = span_.next();
}

void TrailChecker::begin(const World& world, double dt) {
  if (!more_ || world.step() != span_.mark().step)
    depart(world.step(), fmt::format("the replay begins at step {}, the recording at {}",
                                     world.step(), span_.mark().step));
  else if (steps_in_a_second(dt) != expected_.steps_per_second)
    depart(world.step(), fmt::format("the replay makes {} steps per second, the recording {}",
                                     steps_in_a_second(dt), expected_.steps_per_second));
  else
    return check_mark(world, world.hash());
  over_ = true;
}

void TrailChecker::observe(const World& world, const StepInfo&, std::span<const Event>) {
  if (done())
    return;
  if (more_)
    check(world);
  else if (!departure_)
    depart(world.step(),
           fmt::format("the recording ends at step {}, the replay goes on", expected_.last_step));
}

void TrailChecker::finish(const World& world) {
  over_ = true;
  if (!departure_ && more_)
    depart(world.step(), fmt::format("the replay ends at step {}, the recording goes on to {}",
                                     world.step(), expected_.last_step));
}

void TrailChecker::check(const World& world) {
  const bool marks = world.step() == span_.mark().step;
  const bool folds = !departure_ && span_.has_fold(world.step());
  if (!folds && !marks)
    return;
  const std::uint64_t hash = world.hash();
  if (folds && !marks) {
    if (span_.fold(world.step()) == fold(hash))
      last_good_ = world.step();
    else
      depart(world.step(), {});
  }
  if (marks)
    check_mark(world, hash);
}

void TrailChecker::check_mark(const World& world, std::uint64_t hash) {
  if (span_.mark().hash == hash) {
    last_good_ = world.step();
    over_ = departure_.has_value();  // only a fold was wrong
  } else {
    if (!departure_)
      depart(world.step(), {});
    if (!span_.mark().digest.fields.empty())
      departure_->where = compare(world.schema(), span_.mark().digest, digest(world));
    if (departure_->where)
      departure_->reason += "; " + departure_->where->text();
    over_ = departure_->where || span_.mark().digest.fields.empty();
  }
  more_ = span_.next();
}

void TrailChecker::depart(std::uint64_t step, std::string reason) {
  if (reason.empty())
    reason = !last_good_ ? "the worlds differ from the start"
             : step - *last_good_ == 1
                 ? fmt::format("the worlds part at step {}", step)
                 : fmt::format("the worlds part between steps {} and {}", *last_good_, step);
  departure_ = Departure{
      .step = step, .last_good = last_good_, .where = std::nullopt, .reason = std::move(reason)};
}

}  // namespace eyrie::sim
