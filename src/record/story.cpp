// SPDX-License-Identifier: MIT
#include "record/story.hpp"

#include <utility>

#include "core/units.hpp"
#include "model/track.hpp"
#include "model/weapon/missile.hpp"

namespace eyrie::record {
using model::EventKind;

namespace {

std::string miles(float meters) {
  return format_range(static_cast<double>(meters));
}
std::string close_range(float meters) {
  return format_quantity(static_cast<double>(meters), Dimension::length);
}

Tone tone_of(model::Side side) {
  return side == model::Side::blue  ? Tone::blue
         : side == model::Side::red ? Tone::red
                                    : Tone::plain;
}

/// What one says of a defend event, by its phase.
std::string defense(float phase) {
  constexpr std::array kWords{"defending: turns into the missile and climbs",
                              "defending: breaks, nose low",
                              "defending: notches",
                              "defending: runs",
                              "defending: last-ditch break",
                              "out"};
  const auto i = static_cast<std::size_t>(std::max(phase, 1.0F)) - 1;
  return kWords[std::min(i, kWords.size() - 1)];
}

}  // namespace

std::string clock_text(double time) {
  const auto tenths = static_cast<long>(std::floor(time * 10 + 0.5));
  return fmt::format("{:02}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

Story::Story(const scenario::Scenario& scenario, Tell tell)
    : scenario_(scenario), tell_(std::move(tell)), missiles_(scenario) {
  for (const auto& flight : scenario.roster.flights)
    leads_.push_back(flight.members.front());
  phases_.resize(leads_.size());
}

void Story::observe(const sim::World&, const sim::StepInfo& info,
                    std::span<const sim::Event> events) {
  time_ = info.time_after();
  for (const sim::Event& e : events) {
    decided_ = info.time();
    tell(e);
  }
}

std::string Story::name(PlayerId id) const {
  if (const auto* m = missiles_.find(id))
    return fmt::format("{}'s {}", scenario_.roster.name(m->shooter), m->label);
  return id ? scenario_.roster.name(id) : "someone";
}

/// That of a kill.
std::string Story::weapon(const sim::Event& e) const {
  const auto* missile = missiles_.find(PlayerId{e.detail});
  return missile ? missile->label : "gun";
}

void Story::say(PlayerId who, std::string text, Tone tone, PlayerId decider) {
  const auto* player = scenario_.roster.find(who);
  if (tone == Tone::plain && player)
    tone = tone_of(player->side);
  tell_({time_, tone, kind_, who, name(who), std::move(text), decider ? decider : who, decided_});
}

bool Story::first_in_flight(std::uint16_t what, PlayerId who, PlayerId whom) {
  const auto* player = scenario_.roster.find(who);
  return player && told_.insert({what, player->flight, whom}).second;
}

void Story::shot(const sim::Event& e) {
  const PlayerId shooter{e.detail};
  const auto store = static_cast<std::size_t>(e.values[1]);
  const auto& shelf = scenario_.library->missiles;
  const bool active =
      store < shelf.size() && shelf[store].seeker.kind == model::weapon::SeekerKind::radar;
  // of another program it is not known when that was decided
  if (const auto at = released_.find({shooter, e.values[1]}); at != released_.end())
    decided_ = at->second;
  say(shooter, fmt::format("{} on {}, {} ({})", active ? "fox 3" : "fox 2", name(e.whom),
                           miles(e.values[0]), store_label(scenario_, e.values[1])));
}

void Story::ended(const sim::Event& e) {
  const auto* m = missiles_.find(e.who);
  if (!m)
    return;
  const Missiles::Missile& missile = *m;
  if (kind_of(e) == EventKind::timeout)
    say(missile.shooter,
        fmt::format(
            "{} at {} is trashed: {}", missile.label, name(missile.target),
            enum_name(static_cast<model::weapon::MissileEnd>(static_cast<int>(e.values[0])))));
  else if (e.values[1] <= e.values[2])  // the draw was above the kill probability
    say(missile.shooter, fmt::format("{} bursts {} from {}: no kill, Pk {:.2f}", missile.label,
                                     close_range(e.values[0]), name(e.whom), e.values[1]));
}

void Story::tell(const sim::Event& e) {
  const auto* player = scenario_.roster.find(e.who);
  kind_ = kind_of(e);
  missiles_.note(e);
  switch (kind_) {
    case EventKind::contact:
      if (!same_side(scenario_.roster, e.who, e.whom) &&
          first_in_flight(e.kind.value, e.who, e.whom))
        say(e.who, fmt::format("contact, {}", miles(e.values[0])));
      break;
    case EventKind::identified:
      if (static_cast<model::Identity>(static_cast<int>(e.values[0])) == model::Identity::hostile &&
          first_in_flight(e.kind.value, e.who, e.whom))
        say(e.who, fmt::format("{} is hostile, {}", name(e.whom), miles(e.values[1])));
      break;
    case EventKind::commit:
      say(e.who, fmt::format("commit on {}, {}", name(e.whom), miles(e.values[0])));
      break;
    case EventKind::release:
      released_[{e.who, e.values[0]}] = decided_;
      break;
    case EventKind::launch:
      shot(e);
      break;
    case EventKind::seeker_active:
      if (const auto* m = missiles_.find(e.who))
        say(m->shooter, fmt::format("pitbull on {}", name(m->target)));
      break;
    case EventKind::gun_burst:
      say(e.who,
          fmt::format(
              "guns{}: {} rounds, {} hits",
              e.whom ? fmt::format(" on {}, {}", name(e.whom), close_range(e.values[1])) : "",
              e.values[0], e.values[2]));
      break;
    case EventKind::defend:
      say(e.who, defense(e.values[0]));
      break;
    case EventKind::decoyed:
      if (const auto* m = missiles_.find(e.who))
        say(e.whom, fmt::format("{} of {} goes for {}", m->label, name(m->shooter),
                                e.values[0] < 1.5F ? "chaff" : "a flare"));
      break;
    case EventKind::detonation:
    case EventKind::timeout:
      ended(e);
      break;
    case EventKind::kill:
      say(e.who, fmt::format("splash {} ({})", name(e.whom), weapon(e)), Tone::kill, e.whom);
      break;
    case EventKind::crash:
      if (player)
        say(e.who, e.whom ? fmt::format("collides with {}", name(e.whom)) : "hits the ground",
            Tone::kill);
      break;
    case EventKind::loss:
      if (player)
        say(e.who, "is lost", Tone::kill);
      break;
    case EventKind::scatter:
      say(e.who, e.whom ? fmt::format("scatters: {} at {}", name(e.whom), miles(e.values[0]))
                        : "scatters");
      break;
    case EventKind::fuel_out:
      say(e.who, "is out of fuel");
      break;
    case EventKind::bingo:
      say(e.who, "bingo");
      break;
    case EventKind::winchester:
      say(e.who, "winchester");
      break;
    case EventKind::home:
      say(e.who, "is home");
      break;
    case EventKind::lead_change:
      if (player) {
        leads_[player->flight] = e.who;
        say(e.who,
            fmt::format("takes the lead of {}", scenario_.roster.flights[player->flight].name));
      }
      break;
    case EventKind::phase:
      if (player && leads_[player->flight] == e.who && is_outermost(scenario_, e)) {
        const std::string now = phase_name(scenario_, e);
        if (phases_[player->flight] != now)
          say(e.who,
              fmt::format("{} flight: {}", scenario_.roster.flights[player->flight].name, now),
              Tone::phase);
        phases_[player->flight] = now;
      }
      break;
    case EventKind::order:
      say(e.who, order_sentence(scenario_, e));
      break;
    default:
      break;
  }
}

Tally::Tally(const scenario::Scenario& scenario) : scenario_(scenario) {
  players_.resize(scenario.roster.players.size());
  for (const auto& flight : scenario.roster.flights)
    leads_.push_back(flight.members.front());
}

void Tally::enter(PlayerId who, double time) {
  const auto& player = scenario_.roster.players[who.value - 1];
  const std::string& now = players_[who.value - 1].phase;
  if (leads_[player.flight] == who && !now.empty() && phase(player.flight) != now)
    phases_.push_back({player.flight, now, time});
}

void Tally::observe(const sim::World&, const sim::StepInfo& info,
                    std::span<const sim::Event> events) {
  const double time = info.time_after();
  const auto player = [&](PlayerId id) -> OfPlayer* {
    return scenario_.roster.find(id) ? &players_[id.value - 1] : nullptr;
  };
  for (const sim::Event& e : events) {
    OfPlayer* const who = player(e.who);
    const auto fate = fate_of(e);
    if (OfPlayer* const gone = fate ? player(fate->who) : nullptr) {
      const bool home = fate->end == "home";
      if (home || !gone->lost)
        gone->end_time = time;
      (home ? gone->home : gone->lost) = true;
    }
    switch (kind_of(e)) {
      case EventKind::launch:
        if (OfPlayer* shooter = player(PlayerId{e.detail}))
          ++shooter->shots;
        break;
      case EventKind::hit:  // of a burst that may have no end: with the kill the run is over
        if (who && e.detail == 0 && hitting_.insert(e.who).second)
          ++who->shots;
        break;
      case EventKind::gun_burst:
        if (who && hitting_.erase(e.who) == 0)
          ++who->shots;
        break;
      case EventKind::kill:
        if (who && !same_side(scenario_.roster, e.who, e.whom))
          ++who->kills;
        break;
      case EventKind::phase:
        if (who && is_outermost(scenario_, e)) {
          who->phase = phase_name(scenario_, e);
          enter(e.who, time);
        }
        break;
      case EventKind::lead_change:
        if (who) {
          leads_[scenario_.roster.players[e.who.value - 1].flight] = e.who;
          enter(e.who, time);
        }
        break;
      default:
        break;
    }
  }
}

Tally::OfSide Tally::side(model::Side side) const {
  OfSide sum;
  for (std::size_t i = 0; i < players_.size(); ++i) {
    if (scenario_.roster.players[i].side != side)
      continue;
    sum.players += scenario_.fleets[scenario_.roster.players[i].fleet]->words.comes_home;
    sum.losses += players_[i].lost;
    sum.shots += players_[i].shots;
    sum.kills += players_[i].kills;
    sum.home += players_[i].home;
  }
  return sum;
}

std::string_view Tally::phase(std::uint16_t flight) const {
  for (auto p = phases_.rbegin(); p != phases_.rend(); ++p)
    if (p->flight == flight)
      return p->phase;
  return {};
}

}  // namespace eyrie::record
