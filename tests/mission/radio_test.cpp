// SPDX-License-Identifier: MIT
/// \file  Flights in which not everybody has a datalink.
#include <gtest/gtest.h>

#include "support/flight.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

/// eagle1 goes home at once and lands; `mute` have no datalink. Who counts a mate as lost circles.
std::shared_ptr<const scenario::Scenario> flight_home(const std::string& mute) {
  scenario::Source source = scenario::Source::disk(".");
  source.add("radio.yaml", R"(eyrie: 1
name: radio
reference: {latitude: 33 deg, longitude: -68 deg}
until: 10 min
ends: time
data: {aircraft: {mute: {base: f15c, datalink: null}}}
trees:
  on:
    sequencer:
      start: ingress
      trees:
        ingress: {winner_takes_all: [{follow_lead: {vote: 20}}, navigate]}
        lost: navigate
        egress: egress
      transitions:
        - {from: any, to: egress, when: bingo}
        - {from: ingress, to: lost, when: {losses: {at_least: 1}}}
blue:
  home: {north: 0 nmi, east: 0 nmi}
  flights:
    eagle:
      aircraft: f15c
      tree: on
      bingo: 2200 kg
      players: [eagle1: {fuel: 2210 kg}, eagle2, eagle3]
      start: {north: 0 nmi, east: 2 nmi, altitude: 6000 ft, heading: 90 deg, speed: 400 kt}
      route: [{north: 0 nmi, east: 200 nmi, altitude: 20000 ft}]
)");
  return scenario::load({.file = "radio.yaml", .sets = {mute}}, std::move(source));
}

TEST(Radio, TellsWhoHasLandedFromWhoIsLost) {
  for (const std::string mute :
       {"blue.flights.eagle.aircraft=f15c", "blue.flights.eagle.aircraft=mute",
        "blue.flights.eagle.players.eagle1.aircraft=mute"}) {
    Flight f(flight_home(mute));
    f.mission.fly();
    const auto home = f.log.first(EventKind::home, "eagle1");
    ASSERT_TRUE(home) << mute;
    for (const char* mate : {"eagle2", "eagle3"})
      EXPECT_EQ(f.log.phases(mate).size(), 1U) << mate << " counts him as lost: " << mute;
    const auto leads = f.log.of(EventKind::lead_change);
    ASSERT_EQ(leads.size(), 1U) << mute;
    EXPECT_GE(leads[0].time, home->time) << "as long as he flies he leads: " << mute;
  }
}

}  // namespace
}  // namespace eyrie::test
