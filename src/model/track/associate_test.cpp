// SPDX-License-Identifier: MIT
#include "model/track/associate.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace eyrie::model::track {
namespace {

Prediction track_at(double x, double y) {
  return {.position = {x, y, 0}, .along = {100 * 100}, .across = {100 * 100}};
}
Contact contact_at(double x, double y) {
  Contact c;
  c.position = {x, y, 0};
  c.line = {1, 0, 0};
  c.sigma_along = c.sigma_across = 100;
  return c;
}
const Tracker kGates{.gate = 4, .max_gate = 5000};

TEST(Associate, TakesTheNearestPairFirst) {
  // the contact at 140 is nearer to the first track, but another contact is nearer still
  const std::vector tracks{track_at(0, 0), track_at(300, 0)};
  const std::vector contacts{contact_at(140, 0), contact_at(10, 0)};
  const auto track_of = associate(kGates, tracks, contacts);
  EXPECT_EQ(track_of[0], 1);
  EXPECT_EQ(track_of[1], 0);
}

TEST(Associate, LeavesOutWhatIsOutsideTheGates) {
  const std::vector tracks{track_at(0, 0)};
  // the standard deviation of the difference is 141 m
  EXPECT_EQ(associate(kGates, tracks, std::vector{contact_at(560, 0)})[0], 0);
  EXPECT_EQ(associate(kGates, tracks, std::vector{contact_at(570, 0)})[0], kNoTrack);
  // across the line max_gate is the end; along it the error of the contact comes on top
  const Tracker narrow{.gate = 4, .max_gate = 100};
  EXPECT_EQ(associate(narrow, tracks, std::vector{contact_at(490, 0)})[0], 0);
  EXPECT_EQ(associate(narrow, tracks, std::vector{contact_at(510, 0)})[0], kNoTrack);
}

TEST(Associate, GivesATieToTheOlderTrackAndTheEarlierContact) {
  const std::vector tracks{track_at(0, 0), track_at(200, 0)};
  const auto between = associate(kGates, tracks, std::vector{contact_at(100, 0)});
  EXPECT_EQ(between[0], 0);
  const auto twice = associate(kGates, std::vector{track_at(0, 0)},
                               std::vector{contact_at(0, 50), contact_at(0, -50)});
  EXPECT_EQ(twice[0], 0);
  EXPECT_EQ(twice[1], kNoTrack);
}

RC_GTEST_PROP(Associate, UsesEachTrackOnceAndDoesNotDependOnTheOrderOfContacts, ()) {
  const auto place = [] { return double(*rc::gen::inRange(-1500, 1500)); };
  std::vector<Prediction> tracks;
  for (int i = *rc::gen::inRange(0, int(kMaxTracks) + 1); i > 0; --i)
    tracks.push_back(track_at(place(), place()));
  std::vector<Contact> contacts;
  for (int i = *rc::gen::inRange(0, int(kMaxContacts) + 1); i > 0; --i)
    contacts.push_back(contact_at(place() + 0.001 * i, place()));

  const auto track_of = associate(kGates, tracks, contacts);
  std::vector<int> uses(tracks.size());
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (track_of[c] != kNoTrack)
      RC_ASSERT(++uses[track_of[c]] == 1);

  std::vector<std::size_t> order(contacts.size());
  std::iota(order.begin(), order.end(), 0u);
  std::reverse(order.begin(), order.end());
  std::vector<Contact> reversed;
  for (const std::size_t c : order)
    reversed.push_back(contacts[c]);
  const auto again = associate(kGates, tracks, reversed);
  for (std::size_t c = 0; c < order.size(); ++c) {
    // equal distances aside, which random places do not have
    RC_ASSERT(again[c] == track_of[order[c]]);
  }
}

}  // namespace
}  // namespace eyrie::model::track
