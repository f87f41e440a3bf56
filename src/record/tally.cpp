// SPDX-License-Identifier: MIT
#include "record/tally.hpp"

#include "record/names.hpp"

namespace eyrie::record {
using model::EventKind;

Tally::Tally(const scenario::Scenario& scenario) : scenario_(scenario) {
  players_.resize(scenario.roster.players.size());
  for (const auto& flight : scenario.roster.flights)
    leads_.push_back(flight.members.front());
}

void Tally::begin(const sim::World&, double) {}

void Tally::enter(PlayerId who, double time) {
  const auto& player = scenario_.roster.players[who.value - 1];
  const std::string& now = players_[who.value - 1].phase;
  if (leads_[player.flight] == who && !now.empty() && phase(player.flight) != now)
    phases_.push_back({player.flight, now, time});
}

void Tally::observe(const sim::World&, const sim::StepInfo& info,
                    std::span<const sim::Event> events) {
  const double time = info.time() + info.dt;
  const auto player = [&](PlayerId id) -> OfPlayer* {
    return scenario_.roster.find(id) ? &players_[id.value - 1] : nullptr;
  };
  for (const sim::Event& e : events) {
    OfPlayer* const who = player(e.who);
    switch (kind_of(e)) {
      case EventKind::launch:
        if (OfPlayer* shooter = player(PlayerId{e.detail}))
          ++shooter->shots;
        break;
      case EventKind::gun_burst:
        if (who)
          ++who->shots;
        break;
      case EventKind::kill:
        if (who)
          ++who->kills;
        if (OfPlayer* victim = player(e.whom); victim && !victim->lost) {
          victim->lost = true;
          victim->end_time = time;
        }
        break;
      case EventKind::loss:
      case EventKind::crash:
        if (who && !who->lost) {
          who->lost = true;
          who->end_time = time;
        }
        break;
      case EventKind::home:
        if (who) {
          who->home = true;
          who->end_time = time;
        }
        break;
      case EventKind::bingo:
        if (who)
          who->bingo = true;
        break;
      case EventKind::winchester:
        if (who)
          who->winchester = true;
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
