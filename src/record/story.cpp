// SPDX-License-Identifier: MIT
#include "record/story.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/units.hpp"
#include "model/track.hpp"
#include "model/weapon/missile.hpp"
#include "record/names.hpp"

namespace eyrie::record {
using model::EventKind;

namespace {

std::string miles(float meters) {
  return fmt::format("{:.1f} nmi", in_unit(static_cast<double>(meters), "nmi"));
}

Tone tone_of(model::Side side) {
  return side == model::Side::blue  ? Tone::blue
         : side == model::Side::red ? Tone::red
                                    : Tone::plain;
}

}  // namespace

std::string clock_text(double time) {
  const auto tenths = static_cast<long>(std::floor(time * 10 + 0.5));
  return fmt::format("{:02}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

Story::Story(const scenario::Scenario& scenario, Tell tell)
    : scenario_(scenario), tell_(std::move(tell)) {
  for (const auto& flight : scenario.roster.flights)
    leads_.push_back(flight.members.front());
  phases_.resize(leads_.size());
}

void Story::begin(const sim::World&, double) {}

void Story::observe(const sim::World&, const sim::StepInfo& info,
                    std::span<const sim::Event> events) {
  time_ = info.time() + info.dt;
  for (const sim::Event& e : events)
    tell(e);
}

std::string Story::name(PlayerId id) const {
  if (const auto m = missiles_.find(id); m != missiles_.end())
    return fmt::format("{}'s {}", scenario_.roster.name(m->second.shooter), m->second.label);
  return id ? scenario_.roster.name(id) : "someone";
}

bool Story::same_side(PlayerId a, PlayerId b) const {
  const auto *first = scenario_.roster.find(a), *second = scenario_.roster.find(b);
  return first && second && first->side == second->side;
}

void Story::say(PlayerId who, std::string text, Tone tone) {
  const auto* player = scenario_.roster.find(who);
  if (tone == Tone::plain && player)
    tone = tone_of(player->side);
  tell_({time_, tone, kind_, who, name(who), std::move(text)});
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
  missiles_[e.who] = {shooter, e.whom, store_label(scenario_, e.values[1])};
  say(shooter, fmt::format("{} on {}, {} ({})", active ? "fox 3" : "fox 2", name(e.whom),
                           miles(e.values[0]), store_label(scenario_, e.values[1])));
}

void Story::ended(const sim::Event& e) {
  const auto m = missiles_.find(e.who);
  if (m == missiles_.end())
    return;
  const Missile& missile = m->second;
  if (kind_of(e) == EventKind::timeout)
    say(missile.shooter,
        fmt::format(
            "{} at {} is trashed: {}", missile.label, name(missile.target),
            enum_name(static_cast<model::weapon::MissileEnd>(static_cast<int>(e.values[0])))));
  else if (e.values[1] <= e.values[2])  // the draw was above the kill probability
    say(missile.shooter,
        fmt::format("{} misses {} by {:.0f} m", missile.label, name(missile.target), e.values[0]));
}

void Story::tell(const sim::Event& e) {
  const auto* player = scenario_.roster.find(e.who);
  kind_ = kind_of(e);
  switch (kind_) {
    case EventKind::contact:
      if (!same_side(e.who, e.whom) && first_in_flight(e.kind.value, e.who, e.whom))
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
    case EventKind::launch:
      shot(e);
      break;
    case EventKind::seeker_active:
      if (const auto m = missiles_.find(e.who); m != missiles_.end())
        say(m->second.shooter, fmt::format("pitbull on {}", name(m->second.target)));
      break;
    case EventKind::gun_burst:
      say(e.who, e.whom ? fmt::format("guns on {}, {:.0f} m", name(e.whom), e.values[1]) : "guns");
      break;
    case EventKind::defend:
      say(e.who, e.values[0] < 1.5F ? "defending: turns into the missile and climbs"
                                    : "defending: breaks, nose low");
      break;
    case EventKind::detonation:
    case EventKind::timeout:
      ended(e);
      break;
    case EventKind::kill:
      say(e.who,
          fmt::format(
              "splash {}{}", name(e.whom),
              e.detail ? fmt::format(" ({})", missiles_[PlayerId{e.detail}].label) : " (gun)"),
          Tone::kill);
      break;
    case EventKind::crash:
      if (player)
        say(e.who, "hits the ground", Tone::kill);
      break;
    case EventKind::loss:
      if (player)
        say(e.who, "is lost", Tone::kill);
      break;
    case EventKind::scatter:
      say(e.who, e.whom ? fmt::format("scatters: {} at {:.1f} km", name(e.whom), e.values[0] / 1000)
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
      say(e.who, "gets an order from outside");
      break;
    default:
      break;
  }
}

}  // namespace eyrie::record
