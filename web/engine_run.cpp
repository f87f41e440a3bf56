// SPDX-License-Identifier: MIT
/// \file  The engine's answers about a run.
#include "core/hash.hpp"
#include "core/text.hpp"
#include "debrief/what_if.hpp"
#include "page/page.hpp"
#include "web/engine.hpp"

namespace eyrie::web {
namespace {

constexpr double kBetweenKept = 5;  // s

Moment moment(const sim::World& world, double dt) {
  return {world.step(), static_cast<double>(world.step()) * dt, hash_text(world.hash())};
}

sim::Order order_of(std::string_view text) {
  const auto bytes = from_base64(text);
  sim::Order order;
  if (!bytes || bytes->size() != sizeof order)
    throw BadRequest("an order is base64 of 48 bytes");
  std::memcpy(&order, bytes->data(), sizeof order);
  return order;
}

}  // namespace

const debrief::Recorded& Engine::run() const {
  if (!recorded_)
    throw BadRequest("there is no run: open one, or fly to the end");
  return *recorded_;
}

/// The run as page() flies it again, or advance() for the first time, with what is kept on the way.
struct Engine::Reflown {
  /// `is_live`: others are flying it.
  Reflown(const debrief::Recorded& recorded, bool is_live)
      : packer(page::make_packer(*recorded.scenario,
                                 is_live ? recorded.scenario->spec.until : recorded.until())),
        flight(is_live ? debrief::Reflight(recorded, recorded.scenario->world(recorded.run.seed))
                       : debrief::Reflight(recorded)),
        kept{flight.after()},
        between_kept(
            static_cast<std::uint64_t>(kBetweenKept / recorded.scenario->simulation->dt())) {
    flight.attach(*packer);
    if (is_live)
      flight.attach(trail.emplace());
  }

  /// False, once, at the end.
  bool step() {
    if (!flight.step()) {
      packer->finish(flight.after());
      return false;
    }
    packer->look(flight.before(), flight.after(), flight.orders());
    if (!flight.events().empty())
      events.push_back(flight.happened());
    if (flight.after().step() - kept.back().step() >= between_kept)
      kept.push_back(flight.after());
    return true;
  }

  std::unique_ptr<page::Packer> packer;
  debrief::Reflight flight;
  std::vector<sim::World> kept;  ///< by step
  std::vector<debrief::Happened> events;
  std::uint64_t between_kept;
  bool over = false;
  std::optional<sim::TrailRecorder> trail;  ///< if others are flying it
};

void Engine::tell(const sim::World& world, double dt) const {
  constexpr std::uint64_t kTell = 1024;
  if (progress_ && world.step() % kTell == 0)
    progress_(static_cast<double>(world.step()) * dt);
}

Moment Engine::page(const Until& until, std::string& packed) {
  const debrief::Recorded& recorded = run();
  const double dt = recorded.scenario->simulation->dt();
  if (reflown_ && reflown_->trail)
    throw BadRequest("what is followed is drawn by advance");
  if (!reflown_ || reflown_->over)
    reflown_ = std::make_shared<Reflown>(recorded, false);
  const sim::World& world = reflown_->flight.after();
  while (!until.until || static_cast<double>(world.step()) * dt < *until.until) {
    if (!reflown_->step()) {
      reflown_->over = true;
      break;
    }
    tell(world, dt);
  }
  packed = reflown_->packer->packed(page::facts_of(recorded));
  return moment(world, dt);
}

Followed Engine::follow(std::string_view run_file) {
  About about = open(run_file);
  about.until = recorded_->scenario->spec.until;
  sim::HashTrail& trail = recorded_->run.trail;
  const Moment flown{trail.last_step, recorded_->until(), hash_text(trail.last_hash)};
  trail.last_step = 0;
  reflown_ = std::make_shared<Reflown>(*recorded_, true);
  return {std::move(about), flown};
}

Advanced Engine::advance(const Advance& wanted, std::string& packed) {
  packed.clear();
  if (!reflown_ || !reflown_->trail)
    throw BadRequest("nothing is followed");
  for (const std::string& text : wanted.orders) {
    const sim::Order order = order_of(text);
    if (const std::string refused = reflown_->flight.submit(order); !refused.empty())
      throw BadRequest(refused);
    auto& orders = recorded_->run.orders;
    orders.insert(std::upper_bound(orders.begin(), orders.end(), order,
                                   [](const auto& a, const auto& b) { return a.step < b.step; }),
                  order);
  }
  const sim::World& world = reflown_->flight.after();
  const double dt = recorded_->scenario->simulation->dt();
  recorded_->run.trail.last_step = std::max(wanted.step, world.step());
  while (world.step() < wanted.step) {
    reflown_->step();
    tell(world, dt);
  }
  recorded_->run.outcome = wanted.outcome;
  Advanced advanced{moment(world, dt), true};
  advanced.agrees = wanted.hash.empty() || wanted.hash == advanced.moment.hash;
  recorded_->run.trail.last_hash = world.hash();
  if (wanted.draw)
    packed = reflown_->packer->take(page::facts_of(*recorded_));
  return advanced;
}

const debrief::Recorded& Engine::run_with_trail() {
  if (reflown_ && reflown_->trail)
    recorded_->run.trail = reflown_->trail->trail_to(reflown_->flight.after());
  return run();
}

Moment Engine::seek(const Step& step) {
  const debrief::Recorded& recorded = run();
  if (step.step > recorded.last_step())
    throw BadRequest(fmt::format("step: the run ends at {}", recorded.last_step()));
  here_ = past(step.step, false).world;
  return moment(*here_, recorded.scenario->simulation->dt());
}

debrief::Past Engine::past(std::uint64_t step, bool with_events) const {
  const debrief::Recorded& recorded = run();
  const bool reflown = reflown_ && reflown_->flight.after().step() >= step;
  if (with_events && !reflown)
    return debrief::past_at(recorded, step);
  // from the nearest world that is at hand
  const sim::World* from = here_->step() <= step ? &*here_ : nullptr;
  debrief::Past past{recorded.scenario->world(recorded.run.seed), {}};
  if (reflown) {
    const auto later = std::upper_bound(
        reflown_->kept.begin(), reflown_->kept.end(), step,
        [](std::uint64_t wanted, const sim::World& world) { return wanted < world.step(); });
    if (!from || (later - 1)->step() > from->step())
      from = &*(later - 1);
    for (const debrief::Happened& happened : reflown_->events)
      if (with_events && happened.info.step < step)
        past.events.push_back(happened);
  }
  debrief::Reflight flight(recorded, from ? *from : std::move(past.world));
  while (flight.after().step() < step && flight.step()) {
  }
  past.world = flight.after();
  return past;
}

PlayerId Engine::player(const std::string& name) const {
  const scenario::Roster& roster = run().scenario->roster;
  const auto found = roster.find(name);
  if (!found)
    throw BadRequest(roster.unknown(name));
  return *found;
}

std::shared_ptr<const scenario::Scenario> Engine::other(const Otherwise& otherwise) const {
  Diagnostics wrong;
  auto overrides =
      debrief::read_overrides(*run().scenario, player(otherwise.player), otherwise.sets, wrong);
  wrong.throw_if_any();
  auto changed = debrief::with_overrides(run(), overrides.sets, std::move(overrides.changes));
  if (changed->all_trees().size() != run().scenario->all_trees().size())
    throw BadRequest("the change adds or removes a tree; change one that is there");
  return changed;
}

Decided Engine::explain(const Decider& decider) const {
  const scenario::Scenario& scenario = *run().scenario;
  const PlayerId who = player(decider.player);
  debrief::Reflight flight(run(), *here_);
  if (!flight.step())
    return {};
  const auto decision =
      debrief::explain(scenario, flight.before(), flight.after(), who, flight.orders());
  return decision ? Decided{debrief::decision_json(*decision, scenario.roster)} : Decided{};
}

debrief::WhatIf Engine::what_if(const Otherwise& otherwise) {
  return debrief::what_if(run_with_trail(), *other(otherwise), player(otherwise.player), 0);
}

debrief::Outcome Engine::outcome(const Nothing&) const {
  return debrief::outcome_of(run(), past(run().last_step(), true));
}

debrief::Outcome Engine::branch(const Otherwise& otherwise, std::string& packed) const {
  const debrief::Recorded& recorded = run();
  const auto changed = other(otherwise);
  const debrief::Past before = past(here_->step(), true);
  std::string problem;
  const debrief::Outcome flown = outcome({});
  const bool goes_on =
      reflown_ && reflown_->trail && flown.outcome == enum_name(scenario::Outcome::running);
  const auto until = goes_on ? std::nullopt : debrief::limit_of(recorded, flown);
  const auto branch = debrief::branch(recorded, changed, before, until, problem);
  if (!branch)
    throw BadRequest(problem);
  const auto packer = page::make_packer(*changed, until.value_or(changed->spec.until));
  for (const debrief::Happened& happened : before.events)
    packer->remember(branch->after(), happened);
  branch->attach(*packer);
  while (branch->step()) {
    packer->look(branch->before(), branch->after(), branch->orders());
    tell(branch->after(), changed->simulation->dt());
  }
  debrief::Outcome outcome = branch->outcome();
  const sim::World& end = branch->after();
  packed = packer->packed({recorded.run.scenario, recorded.run.build, outcome.outcome,
                           recorded.run.seed, end.hash(), end.step()});
  return outcome;
}

}  // namespace eyrie::web
