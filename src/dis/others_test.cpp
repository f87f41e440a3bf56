// SPDX-License-Identifier: MIT
/// \file  One mission by two programs, in one process: each hears of the other's players by packets
/// alone, over a network that delays, loses, doubles and overtakes.
#include "dis/others.hpp"

#include <gtest/gtest.h>

#include "core/draw.hpp"
#include "dis/announcer.hpp"
#include "record/acmi.hpp"
#include "sim/trail.hpp"
#include "support/flight.hpp"

namespace eyrie::dis {
namespace {

constexpr double kStart = 1'767'268'800;  // s since 1970: 2026-01-01 12:00 UTC, when missions begin

struct Network {
  double delay = 0;   ///< s
  double jitter = 0;  ///< s, more for some
  double loss = 0, twice = 0;
};

struct Program {
  Program(const std::string& name, std::vector<std::string> ours, std::uint16_t number,
          const Network& network, const sim::RunOptions& options = {})
      : flight(test::load_scenario(name, sets_of(std::move(ours))), {}, options),
        station{.application = number},
        others(*flight.scenario, station),
        announcer(
            *flight.scenario, station,
            [this](double, const Packet& packet) { sent.push_back(encode(packet)); }, &others),
        network_(network) {
    flight.mission.run().attach(announcer);
  }
  static std::vector<std::string> sets_of(std::vector<std::string> ours) {
    std::string list;
    for (const std::string& one : ours)
      list += (list.empty() ? "" : ", ") + one;
    return ours.empty() ? std::vector<std::string>{} : std::vector{"ours=[" + list + "]"};
  }

  bool step() {
    const double now = kStart + flight.mission.run().time();
    for (auto at = coming_.begin(); at != coming_.end() && at->first <= now; at = coming_.erase(at))
      others.hear(at->second, at->first);
    for (const sim::Order& order : others.orders(flight.world(), now))
      EXPECT_EQ(flight.mission.run().submit(order), "");
    return flight.mission.step();
  }
  /// What was sent since goes to `to`.
  void deliver(Program& to) {
    const double now = kStart + flight.mission.run().time();
    for (auto& bytes : sent) {
      Draw draw(1, PlayerId{station.application}, Stream::datalink, ++sent_count_);
      if (draw.chance(network_.loss))
        continue;
      const double way = network_.delay + network_.jitter * draw.uniform();
      if (draw.chance(network_.twice))
        to.coming_.emplace(now + way + 0.01, bytes);
      to.coming_.emplace(now + way, std::move(bytes));
    }
    sent.clear();
  }
  [[nodiscard]] std::vector<std::string> kills() const {
    std::vector<std::string> all;
    for (const auto& h : flight.log.of(model::EventKind::kill))
      all.push_back(flight.scenario->roster.name(h.event.who) + " kills " +
                    flight.scenario->roster.name(h.event.whom));
    std::sort(all.begin(), all.end());
    return all;
  }
  [[nodiscard]] std::vector<std::string> shots() const {
    std::vector<std::string> all;
    for (const auto& h : flight.log.of(model::EventKind::launch))
      all.push_back(flight.scenario->roster.name(PlayerId{h.event.detail}) + " at " +
                    flight.scenario->roster.name(h.event.whom));
    std::sort(all.begin(), all.end());
    return all;
  }

  test::Flight flight;
  Station station;
  std::vector<std::vector<std::byte>> sent;
  Others others;
  Announcer announcer;

 private:
  Network network_;
  std::multimap<double, std::vector<std::byte>> coming_;
  std::uint64_t sent_count_ = 0;
};

struct Both {
  explicit Both(const std::string& scenario, const Network& network = {},
                const sim::RunOptions& options = {})
      : blue(scenario, {"blue"}, 1, network, options), red(scenario, {"red"}, 2, network) {}

  /// Until both are over, or `until` (s).
  void fly(double until) {
    bool blue_flies = true, red_flies = true;
    while ((blue_flies || red_flies) && blue.flight.mission.run().time() < until) {
      blue_flies = blue_flies && blue.step();
      red_flies = red_flies && red.step();
      blue.deliver(red);
      red.deliver(blue);
      worst = std::max({worst, apart(blue, red), apart(red, blue)});
    }
    blue.flight.mission.run().finish();
    red.flight.mission.run().finish();
  }
  /// m, between where one has the other's players and where they are.
  static double apart(const Program& here, const Program& there) {
    double most = 0;
    const auto& s = *here.flight.scenario;
    const auto ids = here.flight.world().ids(s.aircraft.table);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto& k = here.flight.world().rows(s.aircraft.kinematics)[i];
      const auto row = there.flight.world().row(s.aircraft.table, ids[i]);
      if (here.flight.world().rows(s.aircraft.fit)[i].remote != 0 && row && !model::is_nowhere(k))
        most = std::max(
            most,
            norm(k.position - there.flight.world().rows(s.aircraft.kinematics)[*row].position));
    }
    return most;
  }

  Program blue, red;
  double worst = 0;
};

TEST(Others, FlyOneMissionFromTwoProgramsAndTellTheSameStory) {
  Both both("merge_learned");
  both.fly(600);
  EXPECT_EQ(both.blue.kills(), both.red.kills());
  EXPECT_EQ(both.blue.shots(), both.red.shots());
  EXPECT_GE(both.blue.shots().size(), 1u);
  EXPECT_GE(both.blue.kills().size(), 1u);
  EXPECT_EQ(both.blue.flight.mission.outcome(), both.red.flight.mission.outcome());
  EXPECT_LT(both.worst, 30);  // m: of a break turn, between two steps of the network
  EXPECT_EQ(both.blue.others.counts()[Unused::no_place], 0u);
}

TEST(Others, TellTheSameStoryOverABadNetwork) {
  Both both("sweep_even", {.delay = 0.05, .jitter = 0.03, .loss = 0.02, .twice = 0.05});
  both.fly(1200);
  EXPECT_EQ(both.blue.kills(), both.red.kills());
  EXPECT_EQ(both.blue.shots().size(), both.red.shots().size());
  EXPECT_GE(both.blue.kills().size(), 1u);
  const HeardCounts& counts = both.blue.others.counts();
  EXPECT_GT(counts[Unused::late], 0u);
  EXPECT_GT(counts[Unused::twice], 0u);
  EXPECT_EQ(counts[Unused::malformed] + counts[Unused::own] + counts[Unused::exercise], 0u);
}

TEST(Others, MissNobodyWhileTheMissionStandsStill) {
  Both both("merge");
  both.fly(10);
  Others& others = both.blue.others;
  const double noon = kStart + both.blue.flight.mission.run().time();
  for (int second = 1; second < 60; ++second) {
    others.hold(noon + second);
    EXPECT_TRUE(others.orders(both.blue.flight.world(), noon + second).empty());
  }
  EXPECT_EQ(others.counts().vanished, 0u);
  EXPECT_FALSE(others.orders(both.blue.flight.world(), noon + 80).empty());
  EXPECT_EQ(others.counts().vanished, 1u);
}

TEST(Others, KeepOneStateOfEachInAStepHoweverManyCome) {
  Both both("merge");
  both.fly(5);
  Others& others = both.blue.others;
  static_cast<void>(others.orders(both.blue.flight.world(), kStart + 5));
  const auto who = both.blue.flight.scenario->roster.find("bandit1");
  EntityState state;
  state.id = others.entity_of(*who);
  state.location = both.blue.flight.scenario->library->reference.to_ecef({0, 0, 3000});
  for (int i = 0; i < 5000; ++i) {
    others.hear(encode({.timestamp = timestamp_at(6 + i * 1e-4), .pdu = state}),
                kStart + 6 + i * 1e-4);
  }
  EXPECT_EQ(others.orders(both.blue.flight.world(), kStart + 7).size(), 3u);
  // and no more while that step is waited for
  for (int i = 0; i < 50; ++i) {
    others.hear(encode({.timestamp = timestamp_at(8 + i), .pdu = state}), kStart + 8 + i);
    EXPECT_TRUE(others.orders(both.blue.flight.world(), kStart + 8 + i).empty());
  }
  EXPECT_EQ(others.counts().vanished, 0u);
  both.blue.flight.mission.step();
  EXPECT_EQ(others.orders(both.blue.flight.world(), kStart + 58).size(), 3u);
}

/// A missile of bandit1 as another program tells it, s after the mission began.
struct Missile {
  explicit Missile(Both& both) : both_(both) {
    const auto& scenario = *both.blue.flight.scenario;
    fire_.munition = state_.id = {1, 2, 500};
    fire_.shooter = both.blue.others.entity_of(*scenario.roster.find("bandit1"));
    fire_.what.type = state_.type =
        model::entity_type_of(scenario.library->missiles[0].entity_type).value();
    fire_.location = state_.location = scenario.library->reference.to_ecef({0, 0, 3000});
    fire_.event = {1, 2, 1};
    end_.munition = fire_.munition;
    end_.shooter = fire_.shooter;
    end_.location = fire_.location;
    end_.event = fire_.event;
  }
  void fire(double at) { hear(at, fire_); }
  /// The same shot as another event.
  void fire_anew(double at) {
    ++fire_.event.number;
    fire(at);
  }
  void end(double at) { hear(at, end_); }
  void state(double at) { hear(at, state_); }
  /// How many launches the orders of that time are.
  [[nodiscard]] auto launches(double at) const {
    const auto orders = both_.blue.others.orders(both_.blue.flight.world(), kStart + at);
    return std::count_if(orders.begin(), orders.end(), [](const sim::Order& order) {
      return order.kind == sim::OrderKind(model::RemoteOrder::launch);
    });
  }

 private:
  void hear(double at, const Pdu& pdu) {
    both_.blue.others.hear(encode({.timestamp = timestamp_at(at), .pdu = pdu}), kStart + at);
  }
  Both& both_;
  Fire fire_;
  Detonation end_;
  EntityState state_;
};

TEST(Others, HearAMissileOfANameThatOneHadLongBefore) {
  Both both("merge");
  both.fly(5);
  Missile missile(both);
  missile.fire(6);
  EXPECT_EQ(missile.launches(6), 1);
  missile.end(7);
  missile.fire(8);  // overtaken by its end
  missile.state(8);
  EXPECT_EQ(missile.launches(8), 0);
  for (double at = 13; at < 60; at += 5) {  // who is told of to the end stays the same
    missile.state(at);
    EXPECT_EQ(missile.launches(at), 0) << at;
  }
  missile.fire(80);  // the program began anew
  EXPECT_EQ(missile.launches(80), 1);
  missile.end(81);
  EXPECT_EQ(missile.launches(81), 0);
  missile.state(100);  // and its Fire was lost
  EXPECT_EQ(missile.launches(100), 0);
  EXPECT_EQ(missile.launches(101), 1);
}

TEST(Others, HearAMissileOnceHoweverManyEventsSayThatItIsFired) {
  Both both("merge");
  both.fly(5);
  Missile missile(both);
  const HeardCounts before = both.blue.others.counts();
  for (double at = 6; at < 7; at += 0.01)
    missile.fire_anew(at);
  EXPECT_EQ(missile.launches(7), 1);
  EXPECT_EQ(both.blue.others.counts().shots, before.shots + 1);
  missile.fire_anew(7.1);
  EXPECT_EQ(missile.launches(7.1), 0);
  missile.fire_anew(20);  // the program began anew
  EXPECT_EQ(missile.launches(20), 1);
}

TEST(Others, ForgetWhoIsSilentWhereThereAreTooMany) {
  Both both("merge");
  both.fly(5);
  Others& others = both.blue.others;
  EntityState state;
  state.location = both.blue.flight.scenario->library->reference.to_ecef({0, 0, 3000});
  state.type.kind = 1;
  const auto hear = [&](unsigned first, double at) {
    for (unsigned i = 0; i < Incoming::kMost + 100; ++i) {
      state.id = {7, 7, static_cast<std::uint16_t>(first + i)};
      others.hear(encode({.timestamp = timestamp_at(at), .pdu = state}), kStart + at);
    }
    const auto before = others.counts().entities;
    static_cast<void>(others.orders(both.blue.flight.world(), kStart + at));
    return others.counts().entities - before;
  };
  EXPECT_GT(hear(1, 6), 4000u);
  EXPECT_EQ(hear(10'000, 8), 0u);
  EXPECT_GT(hear(20'000, 100), 4000u);
}

TEST(Announcer, TellsThatEverybodyStandsStill) {
  Both both("merge");
  both.fly(2);
  both.blue.sent.clear();
  both.blue.announcer.hold();
  ASSERT_EQ(both.blue.sent.size(), 1u);
  const Decoded read = decode(both.blue.sent.front());
  const auto& state = std::get<EntityState>(read.packet.pdu);
  EXPECT_EQ(state.appearance, kFrozen);
  EXPECT_EQ(norm(wide(state.velocity)), 0);
}

TEST(Others, AreGoneFromTheRecordingUntilTheyAreHeardOfAgain) {
  Both both("merge");
  std::string acmi;
  record::AcmiWriter writer(*both.blue.flight.scenario,
                            [&](std::string_view lines) { acmi += lines; });
  both.blue.flight.mission.run().attach(writer);
  const auto count = [&](const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = acmi.find(what); at != acmi.npos; at = acmi.find(what, at + 1))
      ++n;
    return n;
  };
  const auto fly = [&](double until, bool is_heard) {
    while (both.blue.flight.mission.run().time() < until) {
      both.blue.step();
      both.red.step();
      if (is_heard)
        both.red.deliver(both.blue);
      both.red.sent.clear();
    }
  };
  fly(5, true);
  fly(30, false);
  EXPECT_EQ(count("\n-2\n"), 1u);
  EXPECT_EQ(count("\n-1\n"), 0u);
  fly(40, true);
  both.blue.flight.mission.run().finish();
  EXPECT_EQ(count("\n-2\n"), 1u);
  EXPECT_EQ(count(",Pilot=bandit1,"), 2u) << acmi.substr(0, 2000);
}

}  // namespace
}  // namespace eyrie::dis
