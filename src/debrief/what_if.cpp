// SPDX-License-Identifier: MIT
#include "debrief/what_if.hpp"

#include <algorithm>
#include <sstream>

#include "record/story.hpp"
#include "sim/snapshot.hpp"

namespace eyrie::debrief {
namespace {

/// Asks the trees of two fleets about the same states; the second keeps a memory of its own.
class Twice {
 public:
  Twice(const scenario::Fleet& flown, const scenario::Fleet& other, WhatIf& result)
      : flown_(flown), other_(other), result_(result) {}

  void look(const team::AnyMoment& m) {
    if (m.tree != tree_) {
      tree_ = m.tree;
      slab_ = m.memory_for(*other_.agents);
    }
    team::Comparison found = m.compare(*other_.agents, reinterpret_cast<std::byte*>(slab_.data()));
    ++result_.decisions;
    result_.steps.push_back(m.info.step);
    result_.leaders.push_back(found.other);
    const bool same = found.fields.empty();
    if (!same) {
      ++result_.different;
      if (!result_.first)
        result_.first = {m.info.step, m.info.time(), flown_.trees[tree_].label(found.flown),
                         other_.trees[tree_].label(found.other), std::move(found.fields)};
      if (in_a_row_)
        result_.spans.back().second = m.info.time();
      else
        result_.spans.emplace_back(m.info.time(), m.info.time());
    }
    in_a_row_ = !same;
  }

 private:
  const scenario::Fleet& flown_;
  const scenario::Fleet& other_;
  WhatIf& result_;
  std::uint16_t tree_ = team::kNoTree;
  std::vector<std::uint64_t> slab_;
  bool in_a_row_ = false;
};

}  // namespace

Outcome outcome_of(const scenario::Mission& mission, const record::Tally& tally) {
  return {std::string(scenario::outcome_name(mission.outcome())), mission.run().time(),
          tally.side(model::Side::blue), tally.side(model::Side::red)};
}

WhatIf what_if(const Recorded& recorded, const scenario::Scenario& other, PlayerId who,
               double from) {
  WhatIf result;
  const scenario::Scenario& flown = *recorded.scenario;
  const scenario::Fleet& fleet = flown.fleet_of(who);
  Twice twice(fleet, other.fleet_of(who), result);
  Reflight flight(recorded);
  while (flight.step())
    if (flight.time() >= from - 1e-9)
      fleet.agents->look_again(flight.before(), flight.after(), who, flight.orders(),
                               [&](const team::AnyMoment& m) { twice.look(m); });
  return result;
}

Outcome outcome_of(std::shared_ptr<const scenario::Scenario> scenario, std::uint64_t seed,
                   std::optional<double> until) {
  record::Tally tally(*scenario);
  scenario::Mission mission(scenario, seed, until);
  mission.run().attach(tally);
  mission.fly();
  return outcome_of(mission, tally);
}

Outcome outcome_of(const Recorded& recorded) {
  return Branch(recorded, recorded.scenario, past_at(recorded, recorded.last_step()),
                recorded.until())
      .fly();
}

std::optional<double> limit_of(const Recorded& recorded, const Outcome& flown) {
  const bool out_of_time = flown.outcome == scenario::outcome_name(scenario::Outcome::time);
  return out_of_time ? std::optional(recorded.until()) : std::nullopt;
}

Branch::Branch(const Recorded& recorded, std::shared_ptr<const scenario::Scenario> other,
               const Past& past, std::optional<double> until)
    : tally_(*recorded.scenario), before_(past.world) {
  for (const Happened& happened : past.events)
    tally_.observe(past.world, happened.info, happened.events);
  const double end = until.value_or(other->spec.until);
  mission_.emplace(std::move(other), past.world, end, tally_.side(model::Side::blue).home > 0);
  for (const sim::Order& order : recorded.run.orders)
    if (order.step >= before_.step())
      static_cast<void>(mission_->run().submit(order));
  mission_->run().attach(tally_);
}

std::unique_ptr<Branch> branch(const Recorded& recorded,
                               std::shared_ptr<const scenario::Scenario> other, const Past& past,
                               std::optional<double> until, std::string& problem) {
  std::stringstream bytes;
  EYRIE_DEMAND(sim::save(past.world, bytes), "a stream in memory does not fail");
  sim::Loaded loaded = sim::load(other->simulation->shared_schema(), bytes);
  if (!loaded.world) {
    problem = "the change gives another world than the one flown: " + loaded.error;
    return nullptr;
  }
  return std::make_unique<Branch>(recorded, std::move(other),
                                  Past{std::move(*loaded.world), past.events}, until);
}

bool Branch::step() {
  before_ = mission_->run().world();
  if (mission_->step())
    return true;
  mission_->run().finish();
  return false;
}

Outcome Branch::fly() {
  while (step()) {
  }
  return outcome();
}

}  // namespace eyrie::debrief
