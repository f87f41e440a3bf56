// SPDX-License-Identifier: MIT
#include "model/datalink/datalink.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace eyrie::model::datalink {
namespace {

constexpr PlayerId kLead{1}, kWing{2}, kThree{3};
constexpr std::array kMembers{kLead, kWing, kThree};
constexpr Datalink kLink{.rate = 1, .delay = 0.5, .timeout = 5};
constexpr track::Tracker kTracker{};

OwnReport report(double time, const Vec3& position = {}, TrackId target = {}) {
  return {.time = time,
          .position = position,
          .velocity = {200, 0, 0},
          .fuel = 3000,
          .target = target,
          .shot_at = {}};
}
Draw draw(std::uint64_t step) {
  return Draw(1, kLead, Stream::datalink, step);
}

Track confirmed(std::uint32_t id, const Vec3& place, Identity identity = Identity::hostile) {
  Track t;
  t.id = TrackId{id};
  t.position = place;
  t.velocity = {-250, 0, 0};
  t.along = t.across = {100 * 100, 0, 10 * 10};
  t.position_sigma = 100;
  t.velocity_sigma = 10;
  t.truth = PlayerId{id + 50};
  t.identity = identity;
  t.sources = t.fresh = kFromRadar;
  t.hits = 5;
  t.confirmed = 1;
  return t;
}
TrackFile file_of(std::initializer_list<Track> tracks) {
  TrackFile file;
  for (const Track& t : tracks) {
    file.tracks[file.count++] = t;
    file.next_id = t.id.value + 1;
  }
  return file;
}

TEST(Datalink, MessagesArriveExactlyAfterTheDelay) {
  DatalinkSent sent;
  DatalinkState state;
  start(state, kMembers, kLead, 0);
  Mate& wing = state.members[1];
  constexpr double kDt = 0.02;
  double last_arrived = -1;
  for (int step = 0; step < 500; ++step) {
    const double time = step * kDt;
    if (receive(wing, kLink, sent, true, time, draw(static_cast<std::uint64_t>(step))) != nullptr) {
      // sent at full seconds, heard 25 steps later, not one earlier or later
      EXPECT_EQ((step - 25) % 50, 0) << step;
      EXPECT_NEAR(wing.time, time - 0.5, 1e-9);
      EXPECT_GT(wing.time, last_arrived);
      last_arrived = wing.time;
    }
    if (step % 50 == 0)
      transmit(sent, report(time, {100 * time, 0, 0}), {});
  }
  EXPECT_NEAR(last_arrived, 9, 1e-9);
  EXPECT_NEAR(position_at(wing, 9.5).x, 900 + 0.5 * 200, 1e-6);
  EXPECT_NEAR(static_cast<double>(wing.fuel), 3000, 1e-3);
}

TEST(Datalink, ALateReaderGetsTheNewestThatHasArrived) {
  DatalinkSent sent;
  for (int i = 0; i < 9; ++i)
    transmit(sent, report(i), {});
  std::uint32_t number = 0;
  ASSERT_NE(newest_arrived(sent, 0.5, 8.2, number), nullptr);
  EXPECT_EQ(newest_arrived(sent, 0.5, 8.2, number)->time, 7);
  EXPECT_EQ(number, 8u);
  EXPECT_EQ(newest_arrived(sent, 0.5, 8.5, number)->time, 8);
  EXPECT_EQ(newest_arrived(sent, 5, 8.2, number), nullptr) << "the ring does not go back so far";
  EXPECT_EQ(number, 0u);
}

TEST(Datalink, RefusesADelayLongerThanItsRing) {
  EXPECT_EQ(Datalink{}.problem(), "");
  EXPECT_EQ((Datalink{.rate = 1, .delay = 2}.problem()), "");
  EXPECT_NE((Datalink{.rate = 2, .delay = 1.5}.problem()), "");
  EXPECT_NE((Datalink{.rate = 0.05, .timeout = 5}.problem()), "") << "every mate would be lost";
  EXPECT_NE((Datalink{.rate = 0.5, .delay = 4, .timeout = 2}.problem()), "");
}

TEST(Datalink, NothingComesThroughOutOfReachAndTheLostStayLost) {
  DatalinkSent sent;
  DatalinkState state;
  start(state, kMembers, kLead, 0);
  Mate& wing = state.members[1];
  transmit(sent, report(0), {});
  EXPECT_EQ(receive(wing, kLink, sent, false, 1, draw(1)), nullptr);
  EXPECT_EQ(receive(wing, kLink, sent, true, 1.1, draw(2)), nullptr) << "it has gone past";
  EXPECT_EQ(wing.reported, 0);
  const Datalink deaf{.delay = 0.5, .loss = 1};
  transmit(sent, report(1), {});
  EXPECT_EQ(receive(wing, deaf, sent, true, 2, draw(3)), nullptr);
}

TEST(Datalink, LosesAsManyMessagesAsItSays) {
  const Datalink poor{.delay = 0, .loss = 0.3};
  int heard = 0;
  constexpr int kSent = 5000;
  DatalinkSent sent;
  Mate mate{.id = kWing};
  for (int i = 0; i < kSent; ++i) {
    transmit(sent, report(i), {});
    heard += receive(mate, poor, sent, true, i, draw(static_cast<std::uint64_t>(i))) != nullptr;
  }
  EXPECT_NEAR(heard / double(kSent), 0.7, 4 * std::sqrt(0.21 / kSent));
}

TEST(Datalink, BelievesASilentMateLostAfterTheTimeout) {
  DatalinkState state;
  TrackFile file = file_of({confirmed(1, {40e3, 0, 0})});
  start(state, kMembers, kWing, 10);
  EXPECT_EQ(living_rank(state), 2u);
  EXPECT_EQ(lead(state)->id, kLead);
  state.members[0].heard_time = 12;
  state.members[2].heard_time = 16;
  file.tracks[0].targeted_by = 0b101;
  file.tracks[0].shot_by = 0b001;

  EXPECT_EQ(check_silence(state, kLink, 17), 0);
  EXPECT_EQ(state.members[0].alive, 1) << "5 s are not longer than 5 s";
  const std::uint8_t lost = check_silence(state, kLink, 17.1);
  EXPECT_EQ(lost, 0b001);
  forget_claims(file, lost);
  EXPECT_EQ(state.members[0].alive, 0);
  EXPECT_EQ(state.members[1].alive, 1) << "oneself";
  EXPECT_EQ(state.members[2].alive, 1);
  EXPECT_EQ(living_rank(state), 1u);
  EXPECT_EQ(lead(state)->id, kWing);
  EXPECT_EQ(file.tracks[0].targeted_by, 0b100) << "the dead claim nothing";
  EXPECT_EQ(file.tracks[0].shot_by, 0);
}

TEST(Datalink, AMateThatIsHeardAgainIsAliveAgain) {
  DatalinkState state;
  start(state, kMembers, kLead, 0);
  EXPECT_EQ(check_silence(state, kLink, 100), 0b110);
  ASSERT_EQ(state.members[1].alive, 0);
  DatalinkSent sent;
  transmit(sent, report(100), {});
  ASSERT_NE(receive(state.members[1], kLink, sent, true, 100.5, draw(1)), nullptr);
  EXPECT_EQ(state.members[1].alive, 1);
}

TEST(Transmit, SaysFirstWhatIsShotAtThenTheTargetThenTheNearestStrangers) {
  TrackFile file =
      file_of({confirmed(1, {10e3, 0, 0}), confirmed(2, {20e3, 0, 0}),
               confirmed(3, {5e3, 0, 0}, Identity::friendly), confirmed(4, {30e3, 0, 0}),
               confirmed(5, {60e3, 0, 0}), confirmed(6, {50e3, 0, 0}), confirmed(7, {1e3, 0, 0})});
  file.tracks[6].confirmed = 0;
  const std::array shots{TrackId{5}};
  OwnReport own = report(0, {}, TrackId{6});
  own.shot_at = shots;
  DatalinkSent sent;
  transmit(sent, own, file);
  const DatalinkMessage& m = sent.messages[0];
  ASSERT_EQ(m.track_count, kSharedTracks);
  EXPECT_EQ(m.tracks[0].truth, PlayerId{55});
  EXPECT_EQ(m.tracks[0].engagement, kShotAt);
  EXPECT_EQ(m.tracks[1].truth, PlayerId{56});
  EXPECT_EQ(m.tracks[1].engagement, kTargeted);
  EXPECT_EQ(m.tracks[2].truth, PlayerId{51});
  EXPECT_EQ(m.tracks[3].truth, PlayerId{52});
  EXPECT_EQ(m.tracks[2].engagement, 0);
}

TEST(Transmit, SaysWhatIsShotAtByTheNameOfATrackThatWasMerged) {
  TrackFile file = file_of({confirmed(1, {10e3, 0, 0})});
  file.tracks[0].absorbed = {TrackId{4}, TrackId{2}};
  const std::array shots{TrackId{2}};
  OwnReport own = report(0, {}, TrackId{4});
  own.shot_at = shots;
  DatalinkSent sent;
  transmit(sent, own, file);
  EXPECT_EQ(sent.messages[0].tracks[0].engagement, kShotAt | kTargeted);
}

TEST(Transmit, DoesNotPassOnWhatItOnlyHeard) {
  Track heard = confirmed(1, {10e3, 0, 0});
  heard.sensed_time = kNever;
  heard.sources = heard.fresh = kFromDatalink;
  DatalinkSent sent;
  transmit(sent, report(0), file_of({heard}));
  EXPECT_EQ(sent.messages[0].track_count, 0u);
  // but it may be the target, and then the mates must know
  transmit(sent, report(1, {}, TrackId{1}), file_of({heard}));
  ASSERT_EQ(sent.messages[1].track_count, 1u);
  EXPECT_EQ(sent.messages[1].tracks[0].sensed, 0);
}

/// A receiver at the origin.
struct Receiver {
  TrackFile file;
  track::TrackNewsList news;
  track::TrackContext at(double time) { return {kTracker, {}, time, 3, news}; }
};
DatalinkMessage message_of(const TrackFile& tracks, TrackId target = {},
                           std::span<const TrackId> shots = {}) {
  DatalinkSent sent;
  OwnReport own = report(0, {0, 3e3, 0}, target);
  own.shot_at = shots;
  transmit(sent, own, tracks);
  return sent.messages[0];
}

TEST(Fuse, MakesATrackOfWhatOnlyTheMateSees) {
  Receiver r;
  fuse(r.file, r.at(0.5), message_of(file_of({confirmed(8, {50e3, 0, 0})})), {}, 1);
  ASSERT_EQ(r.file.count, 1u);
  const Track& t = r.file.tracks[0];
  EXPECT_EQ(t.id, TrackId{1}) << "a name of the own file";
  EXPECT_NEAR(t.position.x, 50e3 - 0.5 * 250, 0.01) << "carried on over the delay";
  EXPECT_EQ(t.sources, kFromDatalink);
  EXPECT_EQ(t.identity, Identity::hostile);
  EXPECT_EQ(t.confirmed, 1);
  EXPECT_GT(t.position_sigma, 100.0f);
  ASSERT_EQ(r.news.items().size(), 2u);
}

TEST(Fuse, TakesWhatIsBetterAndKeepsWhatIsWorseOut) {
  const DatalinkMessage message = message_of(file_of({confirmed(8, {50e3, 0, 0})}));
  Receiver good;
  Track own = confirmed(1, {49.9e3, 50, 0}, Identity::unknown);
  own.along = own.across = {20 * 20, 0, 4};
  own.time = 0.5;
  good.file = file_of({own});
  fuse(good.file, good.at(0.5), message, {}, 1);
  ASSERT_EQ(good.file.count, 1u);
  EXPECT_EQ(good.file.tracks[0].position, own.position);
  EXPECT_EQ(good.file.tracks[0].identity, Identity::hostile) << "who it is, is taken over";
  EXPECT_EQ(good.file.tracks[0].sources, kFromRadar | kFromDatalink);

  Receiver poor;
  own.along = own.across = {400 * 400, 0, 100 * 100};
  poor.file = file_of({own});
  fuse(poor.file, poor.at(0.5), message, {}, 1);
  ASSERT_EQ(poor.file.count, 1u);
  EXPECT_NEAR(poor.file.tracks[0].position.y, 0, 1);
  EXPECT_EQ(poor.file.tracks[0].fresh, kFromDatalink);
  EXPECT_EQ(poor.file.tracks[0].id, TrackId{1});
}

TEST(Fuse, JoinsTheRangeOfOneWithTheDirectionOfTheOther) {
  // the mate looks along y, the own radar along x; each knows its range well and its direction
  // badly
  Track theirs = confirmed(8, {50e3, 0, 0});
  theirs.along = {30 * 30, 0, 3 * 3};
  theirs.across = {600 * 600, 0, 30 * 30};
  OwnReport mate = report(0, {50e3, 60e3, 0});
  DatalinkSent sent;
  transmit(sent, mate, file_of({theirs}));
  Track own = confirmed(1, {50010, 500, 0});
  own.along = {30 * 30, 0, 3 * 3};
  own.across = {700 * 700, 0, 35 * 35};
  Receiver r;
  r.file = file_of({own});
  fuse(r.file, r.at(0), sent.messages[0], {}, 1);
  ASSERT_EQ(r.file.count, 1u);
  const Track& joint = r.file.tracks[0];
  EXPECT_NEAR(joint.position.x, 50010, 5) << "the own range is not made worse";
  EXPECT_LT(joint.along.position, 31.0f * 31);
  EXPECT_LT(joint.across.position, 500.0f * 500) << "half of the directions across is known well";
}

/// What I told a mate comes back from it: neither of us knows any more than before.
TEST(Fuse, LearnsNothingFromItsOwnEcho) {
  Receiver me, mate;
  Track own = confirmed(1, {50e3, 0, 0});
  own.along = {50 * 50, 300, 4 * 4};
  own.across = {500 * 500, 4000, 40 * 40};
  own.turning.probability = 0.1f;
  own.turning.along = {80 * 80, 500, 30 * 30, 0, 0, 900};
  own.turning.across = {600 * 600, 5000, 90 * 90, 0, 0, 900};
  me.file = file_of({own});
  const auto pass = [](Receiver& from, Receiver& to, double time) {
    DatalinkSent sent;
    OwnReport sender = report(time);
    from.file.tracks[0].sensed_time = time;  // held by a sensor, or it would not be passed on
    transmit(sent, sender, from.file, kTracker);
    fuse(to.file, to.at(time), sent.messages[0], {}, 1);
    ASSERT_EQ(to.file.count, 1u);
  };
  for (int i = 0; i < 20; ++i) {
    pass(me, mate, 0.5 * i);
    pass(mate, me, 0.5 * i);
  }
  // as if nobody had said anything
  const track::Prediction alone = track::predict(own, kTracker, {{}, {200, 0, 0}}, 9.5);
  const track::Prediction now = track::predict(me.file.tracks[0], kTracker, {{}, {200, 0, 0}}, 9.5);
  const track::Covariance sure = covariance_of(now), sure_alone = covariance_of(alone);
  EXPECT_GT(sure.along.position, 0.98 * sure_alone.along.position);
  EXPECT_GT(sure.across.position, 0.98 * sure_alone.across.position);
  EXPECT_GT(sure.along.velocity, 0.98 * sure_alone.along.velocity);
  EXPECT_GT(sure.across.velocity, 0.98 * sure_alone.across.velocity);
  EXPECT_NEAR(norm(now.position - alone.position), 0, 1);
}

TEST(Fuse, CallsNobodyHostileWhoMayBeAFriend) {
  DatalinkState state;
  state.count = 3;
  state.self = 0;
  state.members[2] = {.position = {50e3, 500, 0}, .velocity = {}, .alive = 1, .reported = 1};
  const DatalinkMessage message = message_of(file_of({confirmed(8, {50e3, 0, 0})}));
  const auto identity_after = [&] {
    Receiver r;
    Track own = confirmed(1, {49.9e3, 300, 0}, Identity::unknown);
    own.along = own.across = {80 * 80, 0, 4};  // better than the sender's
    r.file = file_of({own});
    fuse(r.file, r.at(0.1), message, state, 1);
    return r.file.tracks[0].identity;
  };
  EXPECT_EQ(identity_after(), Identity::unknown);
  state.members[2].alive = 0;
  EXPECT_EQ(identity_after(), Identity::hostile);
  state.members[2].alive = 1;
  state.members[2].position = {50e3, 9e3, 0};
  EXPECT_EQ(identity_after(), Identity::hostile);
}

TEST(Fuse, MarksTheClaimsOfTheMateAndTakesThemBack) {
  Receiver r;
  r.file = file_of({confirmed(1, {50e3, 0, 0}), confirmed(2, {50e3, 9e3, 0})});
  const TrackFile theirs = file_of({confirmed(8, {50e3, 0, 0}), confirmed(9, {50e3, 9e3, 0})});
  const std::array shots{TrackId{9}};
  fuse(r.file, r.at(0.1), message_of(theirs, TrackId{8}, shots), {}, 2);
  EXPECT_EQ(r.file.tracks[0].targeted_by, 0b100);
  EXPECT_EQ(r.file.tracks[0].shot_by, 0);
  EXPECT_EQ(r.file.tracks[1].shot_by, 0b100);
  fuse(r.file, r.at(0.2), message_of(theirs, TrackId{9}), {}, 2);
  EXPECT_EQ(r.file.tracks[0].targeted_by, 0);
  EXPECT_EQ(r.file.tracks[1].targeted_by, 0b100);
  EXPECT_EQ(r.file.tracks[1].shot_by, 0);
}

TEST(Fuse, DoesNotTakeItselfForAStranger) {
  Receiver r;
  fuse(r.file, r.at(0.1), message_of(file_of({confirmed(8, {200, 100, 0})})), {}, 1);
  EXPECT_EQ(r.file.count, 0u);
}

Mate mate_at(const Vec3& place) {
  return {.position = place,
          .velocity = {-250, 0, 0},
          .time = 0,
          .id = kWing,
          .alive = 1,
          .reported = 1};
}

TEST(RecognizeMate, NamesTheTrackThatFliesWhereTheMateSaysItIs) {
  Receiver r;
  r.file = file_of({confirmed(1, {20e3, 0, 0}, Identity::unknown),
                    confirmed(2, {20e3, 3e3, 0}, Identity::unknown)});
  recognize_mate(r.file, r.at(0.5), mate_at({20e3, 2950, 0}));
  EXPECT_EQ(r.file.tracks[0].identity, Identity::unknown);
  EXPECT_EQ(r.file.tracks[1].identity, Identity::friendly);
}

TEST(RecognizeMate, IsNotFooledByABanditThatComesTheOtherWay) {
  Receiver r;
  Track bandit = confirmed(1, {20e3, 0, 0}, Identity::unknown);
  bandit.velocity = {250, 0, 0};
  r.file = file_of({bandit});
  recognize_mate(r.file, r.at(0), mate_at({20e3, 50, 0}));
  EXPECT_EQ(r.file.tracks[0].identity, Identity::unknown);
}

TEST(RecognizeMate, DoesNotPardonAHostile) {
  Receiver r;
  r.file = file_of({confirmed(1, {20e3, 0, 0}, Identity::hostile)});
  recognize_mate(r.file, r.at(0), mate_at({20e3, 0, 0}));
  EXPECT_EQ(r.file.tracks[0].identity, Identity::hostile);
}

}  // namespace
}  // namespace eyrie::model::datalink
