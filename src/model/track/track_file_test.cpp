// SPDX-License-Identifier: MIT
#include "model/track/track_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "core/draw.hpp"

namespace eyrie::model::track {
namespace {

constexpr Tracker kAging{.confirm_hits = 2, .coast_time = 12, .tentative_time = 6};

/// A track file, its owner at the origin, and what is told of it.
struct Desk {
  Tracker tracker = kAging;
  TrackFile file;
  TrackNewsList news;
  std::uint32_t tries = 3;

  TrackContext at(double time) { return {tracker, {}, time, tries, news}; }
  void see(double time, const std::vector<Contact>& contacts) { update(file, at(time), contacts); }
  int told(TrackNews::What what) const {
    int count = 0;
    for (const TrackNews& n : news.items())
      count += n.what == what;
    return count;
  }
};

Contact radar_contact(const Vec3& place, std::uint32_t truth = 9, double sigma = 50) {
  Contact c;
  c.position = place;
  c.line = normalized(place, {1, 0, 0});
  c.range = norm(place);
  c.sigma_along = c.sigma_across = sigma;
  c.sigma_speed = 3;
  c.truth = PlayerId{truth};
  return c;
}

TEST(TrackFile, ConfirmsATrackAfterSoManyHits) {
  Desk desk;
  desk.see(0, {radar_contact({40e3, 0, 0})});
  ASSERT_EQ(desk.file.count, 1u);
  EXPECT_EQ(desk.file.tracks[0].confirmed, 0);
  EXPECT_EQ(desk.told(TrackNews::What::confirmed), 0);
  desk.see(2, {radar_contact({40e3, 20, 0})});
  EXPECT_EQ(desk.file.tracks[0].confirmed, 1);
  desk.see(4, {radar_contact({40e3, 0, 0})});
  EXPECT_EQ(desk.told(TrackNews::What::confirmed), 1);
  EXPECT_EQ(desk.file.tracks[0].hits, 3);
  EXPECT_EQ(desk.file.tracks[0].first_time, 0);
}

TEST(TrackFile, NamesTracksInOrderOfAgeAndNeverTwice) {
  Desk desk;
  desk.see(0, {radar_contact({40e3, 0, 0}), radar_contact({20e3, 9e3, 0})});
  EXPECT_EQ(desk.file.tracks[0].id, TrackId{1});
  EXPECT_EQ(desk.file.tracks[1].id, TrackId{2});
  upkeep(desk.file, desk.at(7));
  EXPECT_EQ(desk.file.count, 0u);
  desk.see(8, {radar_contact({40e3, 0, 0})});
  EXPECT_EQ(desk.file.tracks[0].id, TrackId{3});
  EXPECT_EQ(find(desk.file, TrackId{1}), nullptr);
  EXPECT_EQ(find(desk.file, TrackId{}), nullptr);
  EXPECT_EQ(find(desk.file, TrackId{3}), &desk.file.tracks[0]);
}

TEST(TrackFile, StartsFromARowOfZeros) {
  Desk desk;
  std::memset(static_cast<void*>(&desk.file), 0, sizeof desk.file);
  desk.see(0, {radar_contact({40e3, 0, 0})});
  EXPECT_EQ(desk.file.tracks[0].id, TrackId{1});
}

TEST(TrackFile, DropsATentativeTrackSoonerThanAConfirmedOne) {
  Desk desk;
  desk.see(0, {radar_contact({40e3, 0, 0})});
  desk.see(1, {radar_contact({40e3, 0, 0}), radar_contact({20e3, 9e3, 0})});
  upkeep(desk.file, desk.at(7.5));
  ASSERT_EQ(desk.file.count, 1u);
  EXPECT_EQ(desk.told(TrackNews::What::lost), 0) << "nobody was told of the tentative one";
  upkeep(desk.file, desk.at(12.9));
  EXPECT_EQ(desk.file.count, 1u);
  upkeep(desk.file, desk.at(13.1));
  EXPECT_EQ(desk.file.count, 0u);
  ASSERT_EQ(desk.told(TrackNews::What::lost), 1);
  EXPECT_NEAR(desk.news.items().back().value, 12.1, 1e-9);
  // what is dropped leaves no trace
  const TrackFile empty{.next_id = 3};
  EXPECT_EQ(std::memcmp(&desk.file, &empty, sizeof empty), 0);
}

TEST(TrackFile, GrowsItsSigmasWhileCoasting) {
  Desk desk;
  desk.see(0, {radar_contact({40e3, 0, 0})});
  desk.see(2, {radar_contact({40e3, 0, 0})});
  upkeep(desk.file, desk.at(2));
  const float before = desk.file.tracks[0].position_sigma;
  upkeep(desk.file, desk.at(6));
  EXPECT_GT(desk.file.tracks[0].position_sigma, 2 * before);
  EXPECT_EQ(desk.file.tracks[0].time, 2) << "time is that of the last update";
}

TEST(TrackFile, MakesRoomByDroppingTheFarthestTentativeTrack) {
  Desk desk;
  std::vector<Contact> sixteen;
  for (std::size_t i = 0; i < kMaxTracks; ++i)
    sixteen.push_back(radar_contact({20e3 + 3e3 * static_cast<double>(i), 0, 0}));
  desk.see(0, sixteen);
  ASSERT_EQ(desk.file.count, kMaxTracks);
  desk.see(1, {radar_contact({80e3, 0, 0}, 77)});
  EXPECT_EQ(desk.file.tracks.back().truth, PlayerId{9}) << "a farther one is not worth it";
  desk.see(1, {radar_contact({10e3, 0, 0}, 77)});
  EXPECT_EQ(desk.file.count, kMaxTracks);
  EXPECT_EQ(desk.file.tracks.back().truth, PlayerId{77});
  EXPECT_EQ(desk.file.tracks.back().id, TrackId{17});
  for (const Track& t : desk.file.tracks)
    EXPECT_LT(t.position.x, 64e3) << "the one at 65 km made room";
}

TEST(TrackFile, OtherwiseDropsTheStalestConfirmedTrack) {
  Desk desk;
  std::vector<Contact> sixteen;
  for (std::size_t i = 0; i < kMaxTracks; ++i)
    sixteen.push_back(radar_contact({20e3 + 3e3 * static_cast<double>(i), 0, 0}));
  desk.see(0, sixteen);
  desk.see(1, sixteen);
  sixteen.erase(sixteen.begin() + 4);
  desk.see(2, sixteen);
  desk.see(6, sixteen);
  desk.see(6.9, {radar_contact({10e3, 0, 0}, 77)});
  EXPECT_EQ(desk.file.tracks.back().truth, PlayerId{9}) << "none has been quiet for 6 s yet";
  desk.see(7.1, {radar_contact({10e3, 0, 0}, 77)});
  EXPECT_EQ(desk.file.tracks.back().truth, PlayerId{77});
  EXPECT_EQ(find(desk.file, TrackId{5}), nullptr);
}

TEST(TrackFile, MergesADuplicateFromAnotherSensorIntoTheOlderTrack) {
  Desk desk;
  desk.see(0, {radar_contact({40e3, 0, 0}, 9, 300)});
  desk.see(1, {radar_contact({40e3, 0, 0}, 9, 300)});
  // a track that a mate sent, better and a little aside
  Track remote = desk.file.tracks[0];
  remote.position.y += 200;
  remote.sources = remote.fresh = kFromDatalink;
  remote.along.position = remote.across.position = 100;
  remote.identity = Identity::hostile;
  remote.time = 1;
  ASSERT_NE(add_track(desk.file, desk.at(1), remote), kMaxTracks);
  upkeep(desk.file, desk.at(1));
  ASSERT_EQ(desk.file.count, 1u);
  const Track& merged = desk.file.tracks[0];
  EXPECT_EQ(merged.id, TrackId{1});
  EXPECT_EQ(merged.sources, kFromRadar | kFromDatalink);
  EXPECT_EQ(merged.identity, Identity::hostile);
  EXPECT_EQ(merged.position.y, remote.position.y) << "the better estimate lives on";
  EXPECT_EQ(desk.told(TrackNews::What::lost), 0);
}

TEST(TrackFile, IsFoundByTheNamesOfTheTracksThatWereMergedIntoIt) {
  Desk desk;
  desk.see(0, {radar_contact({40e3, 0, 0}, 9, 300)});
  desk.see(1, {radar_contact({40e3, 0, 0}, 9, 300)});
  Track twin = desk.file.tracks[0];
  twin.sources = twin.fresh = kFromDatalink;
  for (std::uint32_t name = 2; name <= 3; ++name) {
    add_track(desk.file, desk.at(1), twin);
    upkeep(desk.file, desk.at(1));
    ASSERT_EQ(desk.file.count, 1u);
    for (std::uint32_t old = 1; old <= name; ++old)
      EXPECT_EQ(find(desk.file, TrackId{old}), &desk.file.tracks[0]) << old;
  }
  EXPECT_EQ(find(desk.file, TrackId{4}), nullptr);
  EXPECT_EQ(find(desk.file, TrackId{}), nullptr);
}

TEST(TrackFile, NeverMergesAFriendWithAHostile) {
  Desk desk;
  desk.see(0, {radar_contact({40e3, 0, 0})});
  desk.see(2, {radar_contact({40e3, 0, 0})});
  Track twin = desk.file.tracks[0];
  twin.sources = twin.fresh = kFromDatalink;
  desk.file.tracks[0].identity = Identity::hostile;
  for (const Identity other : {Identity::friendly, Identity::unknown}) {
    twin.identity = other;
    add_track(desk.file, desk.at(2), twin);
    upkeep(desk.file, desk.at(2));
    EXPECT_EQ(desk.file.count, other == Identity::friendly ? 2u : 1u);
    desk.file.count = 1;
  }
}

TEST(TrackFile, NeverMergesTwoTargetsThatOneSensorHasSeenAtOnce) {
  Desk desk;
  const std::vector pair{radar_contact({40e3, 0, 0}, 9, 300),
                         radar_contact({40e3, 150, 0}, 10, 300)};
  desk.see(0, pair);
  upkeep(desk.file, desk.at(0));
  EXPECT_EQ(desk.file.count, 2u);
  desk.see(2, pair);
  upkeep(desk.file, desk.at(3));
  EXPECT_EQ(desk.file.count, 2u);
}

TEST(TrackFile, DeclaresHostileWhoDoesNotAnswerAndFriendlyWhoDoes) {
  Desk desk;
  Contact silent = radar_contact({40e3, 0, 0}, 9), friendly = radar_contact({20e3, 9e3, 0}, 10);
  silent.interrogated = friendly.interrogated = true;
  friendly.identity = Identity::friendly;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(desk.told(TrackNews::What::identified), i == 0 ? 0 : 1);
    desk.see(i, {silent, friendly});
  }
  EXPECT_EQ(desk.file.tracks[0].identity, Identity::hostile);
  EXPECT_EQ(desk.file.tracks[1].identity, Identity::friendly);
  EXPECT_EQ(desk.told(TrackNews::What::identified), 2);
}

TEST(TrackFile, DoesNotPardonAStrangerThatTookOverAFriendsTrack) {
  Desk desk;
  Contact friendly = radar_contact({40e3, 0, 0});
  friendly.interrogated = true;
  friendly.identity = Identity::friendly;
  desk.see(0, {friendly});
  ASSERT_EQ(desk.file.tracks[0].identity, Identity::friendly);
  Contact stranger = radar_contact({40e3, 0, 0}, 10);
  stranger.interrogated = true;
  for (int i = 1; i <= 6; ++i)
    desk.see(i, {stranger});
  EXPECT_EQ(desk.file.tracks[0].identity, Identity::hostile);
  EXPECT_EQ(desk.told(TrackNews::What::identified), 2);
}

TEST(TrackFile, BelievesTheEyeMoreThanSilence) {
  Desk desk;
  Contact silent = radar_contact({3e3, 0, 0});
  silent.interrogated = true;
  for (int i = 0; i < 3; ++i)
    desk.see(i, {silent});
  ASSERT_EQ(desk.file.tracks[0].identity, Identity::hostile);
  Contact seen = radar_contact({3e3, 0, 0});
  seen.source = kFromVisual;
  seen.identity = Identity::friendly;
  seen.sigma_speed = 0;
  desk.see(3, {seen});
  EXPECT_EQ(desk.file.tracks[0].identity, Identity::friendly);
  EXPECT_EQ(desk.file.tracks[0].sources, kFromRadar | kFromVisual);
  EXPECT_EQ(desk.file.tracks[0].seen_time, 3);
}

TEST(TrackFile, FusesRadarRangeWithTheDirectionOfTheEye) {
  Desk desk;
  Contact radar = radar_contact({3000, 0, 0});
  radar.sigma_along = 20;
  radar.sigma_across = 200;
  Contact eye = radar_contact({3400, 40, 0});
  eye.source = kFromVisual;
  eye.sigma_along = 600;
  eye.sigma_across = 20;
  eye.sigma_speed = 0;
  eye.line = {1, 0, 0};
  desk.see(0, {radar});
  desk.see(0, {eye});
  ASSERT_EQ(desk.file.count, 1u);
  EXPECT_NEAR(desk.file.tracks[0].position.x, 3000, 5);
  EXPECT_NEAR(desk.file.tracks[0].position.y, 40, 5);
}

/// What decides must not depend on who it is: the same contacts under other names give the same
/// tracks but for those names.
TEST(TrackFile, NeverReadsTheTruth) {
  const auto run = [](bool scrambled) {
    Desk desk;
    std::uint32_t name = 100;
    for (int look = 0; look < 40; ++look) {
      const double t = 2.0 * look;
      Draw draw(5, PlayerId{1}, Stream::test, static_cast<std::uint64_t>(look));
      std::vector<Contact> contacts;
      for (std::uint32_t k = 0; k < 6; ++k) {
        const Vec3 place{60e3 - 250 * t, 700.0 * k, -200.0 * k};
        const Vec3 noise{40 * draw.normal(), 300 * draw.normal(), 300 * draw.normal()};
        Contact c = radar_contact(place + noise, scrambled ? ++name : k + 1, 300);
        c.interrogated = true;
        if (draw.chance(0.8))
          contacts.push_back(c);
      }
      desk.see(t, contacts);
      upkeep(desk.file, desk.at(t + 1));
    }
    for (Track& t : desk.file.tracks)
      t.truth = {};
    return desk.file;
  };
  const TrackFile a = run(false), b = run(true);
  EXPECT_GE(a.count, 5u);
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
}

TEST(Conclude, AReplyMakesAFriend) {
  Track track{.unanswered = 2};
  conclude(track, 3, true);
  EXPECT_EQ(track.identity, Identity::friendly);
}

TEST(Conclude, SilenceToSoManyInterrogationsMakesAHostile) {
  Track track;
  conclude(track, 3, false);
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::unknown);
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::hostile);
}

TEST(Conclude, ZeroTriesNeverDeclareAnyoneHostile) {
  Track track;
  for (int i = 0; i < 1000; ++i)
    conclude(track, 0, false);
  EXPECT_EQ(track.identity, Identity::unknown);
  EXPECT_EQ(track.unanswered, 255);
}

TEST(Conclude, MakesAFriendOfAHostileThatReplies) {
  Track track{.identity = Identity::hostile};
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::hostile);
  conclude(track, 3, true);
  EXPECT_EQ(track.identity, Identity::friendly);
}

TEST(Conclude, AsksAFriendThatFallsSilentAnew) {
  Track track{.identity = Identity::friendly};
  conclude(track, 3, false);
  conclude(track, 3, true);
  conclude(track, 3, false);
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::friendly) << "not three in a row";
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::unknown) << "perhaps it is somebody else by now";
  conclude(track, 3, false);
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::unknown);
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::hostile);
  for (int i = 0; i < 9; ++i)
    conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::hostile);
}

}  // namespace
}  // namespace eyrie::model::track
