// SPDX-License-Identifier: MIT
#include "dis/announcer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/flight.hpp"

namespace eyrie::dis {
namespace {

struct Told {
  double time = 0;
  Packet packet;
};

/// What is told of a flight, and what somebody makes of it who only hears that.
struct Listener final : sim::Observer {
  explicit Listener(const scenario::Scenario& scenario)
      : scenario_(scenario), announcer(scenario, {}, [this](double time, const Packet& packet) {
          told.push_back({time, decode(encode(packet)).packet});
        }) {}

  void begin(const sim::World& world, double dt) override { announcer.begin(world, dt); }
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    announcer.observe(world, info, events);
    for (; heard_ < told.size(); ++heard_)
      if (const auto* state = std::get_if<EntityState>(&told[heard_].packet.pdu))
        latest_[state->id.entity] = {told[heard_].time, *state};
      else if (const auto* emission = std::get_if<Emission>(&told[heard_].packet.pdu))
        emissions_[emission->emitter.entity] = *emission;
    const double now = info.time_after();
    scenario_.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
      compare(id, fleet.motion(world, row), now);
    });
    const auto missiles = world.ids(scenario_.missiles.table);
    for (std::size_t row = 0; row < missiles.size(); ++row) {
      compare(missiles[row], world.rows(scenario_.missiles.kinematics)[row], now);
      if (world.rows(scenario_.missiles.state)[row].decoy != 0)
        if (const auto said = emissions_.find(static_cast<std::uint16_t>(missiles[row].value));
            said != emissions_.end()) {
          ++decoyed;
          decoyed_with_target += !said->second.systems.at(0).beams.at(0).targets.empty();
        }
    }
  }
  void finish(const sim::World& world) override { announcer.finish(world); }

  template <class T>
  [[nodiscard]] std::vector<std::pair<double, T>> of() const {
    std::vector<std::pair<double, T>> found;
    for (const Told& t : told)
      if (const auto* pdu = std::get_if<T>(&t.packet.pdu))
        found.emplace_back(t.time, *pdu);
    return found;
  }

  const scenario::Scenario& scenario_;
  std::vector<Told> told;
  Announcer announcer;
  double farthest = 0, most_turned = 0, oldest = 0;
  int decoyed = 0, decoyed_with_target = 0;  // steps of active seekers

 private:
  /// What is reckoned with the truth.
  void compare(PlayerId id, const model::Kinematics& k, double now) {
    const auto& [since, state] = latest_.at(static_cast<std::uint16_t>(id.value));
    const Motion motion = reckon(state.reckoning, motion_of(state), now - since);
    const Reference& earth = scenario_.library->reference;
    const model::Axes body = model::body_axes(k);
    farthest = std::max(farthest, norm(motion.position - earth.to_ecef(k.position)));
    most_turned = std::max(
        {most_turned, angle_between(motion.attitude.row_x, earth.turned_to_ecef(body.forward)),
         angle_between(motion.attitude.row_z, earth.turned_to_ecef(body.down))});
    oldest = std::max(oldest, now - since);
  }

  std::size_t heard_ = 0;
  std::map<std::uint16_t, std::pair<double, EntityState>> latest_;
  std::map<std::uint16_t, Emission> emissions_;
};

struct Heard {
  test::Flight flight;
  Listener listener;
  explicit Heard(const std::string& name, double until, const sim::RunOptions& options = {},
                 std::optional<std::uint64_t> seed = {})
      : flight(test::load_scenario(name), seed, options), listener(*flight.scenario) {
    flight.mission.run().attach(listener);
    flight.fly_until(until);
    flight.mission.run().finish();
  }
  [[nodiscard]] std::size_t events(model::EventKind kind) const {
    return flight.log.of(kind).size();
  }
};

const Heard& sweep() {
  static const Heard heard("sweep", 1e9, {}, 72);  // in which two bursts miss
  return heard;
}

TEST(Announcer, LetsOthersKnowWhereEverybodyIs) {
  const Listener& l = sweep().listener;
  EXPECT_LE(l.farthest, 1 + 1e-3) << "m; and the single precision of velocities";
  EXPECT_LE(l.most_turned, radians(3) + 1e-6);
  EXPECT_NEAR(l.oldest, 5 - 0.02, 0.011) << "heartbeat";
  EXPECT_LT(l.oldest, Thresholds{}.timeout()) << "nobody is taken for gone who is there";
}

TEST(Announcer, TellsFewStatesOfWhoFliesStraight) {
  const auto states = sweep().listener.of<EntityState>();
  const auto early = std::count_if(states.begin(), states.end(),
                                   [](const auto& s) { return s.first > 60 && s.first < 260; });
  EXPECT_LE(early, 6 * 200 / 5);  // heartbeats
  EXPECT_LT(states.size(), 7500u) << "six aircraft, eleven missiles and a close fight";
}

TEST(Announcer, TellsWhoSomebodyIs) {
  std::map<std::uint16_t, EntityState> first;
  for (const auto& [time, state] : sweep().listener.of<EntityState>())
    first.try_emplace(state.id.entity, state);
  const EntityState& eagle = first.at(1);
  EXPECT_EQ(eagle.id, (EntityId{1, 1, 1}));
  EXPECT_EQ(eagle.force, Force::friendly);
  EXPECT_EQ(eagle.type, (model::EntityType{1, 2, 225, 1, 5, 3}));
  EXPECT_EQ(std::string(eagle.marking.data()), "eagle1");
  EXPECT_EQ(first.at(6).force, Force::opposing);
  EXPECT_EQ(first.at(6).type.country, 222);
  const EntityState& missile = first.at(7);
  EXPECT_EQ(missile.type, (model::EntityType{2, 1, 225, 1, 2, 3}));
  EXPECT_EQ(missile.force, Force::friendly);
  EXPECT_EQ(std::string(missile.marking.data()), "AIM-120 7");
}

TEST(Announcer, TellsEveryShotAndItsEnd) {
  using model::EventKind;
  const auto fires = sweep().listener.of<Fire>();
  const auto ends = sweep().listener.of<Detonation>();
  const auto launches = sweep().flight.log.of(EventKind::launch);
  ASSERT_GT(launches.size(), 3u);
  ASSERT_EQ(fires.size(), launches.size() + sweep().events(EventKind::gun_burst));
  std::map<EventId, Fire> shots;
  std::size_t i = 0;
  for (const auto& [time, fire] : fires) {
    EXPECT_TRUE(shots.try_emplace(fire.event, fire).second) << "every shot has its number";
    if (fire.munition.entity == 0)
      continue;  // a burst
    ASSERT_LT(i, launches.size());
    EXPECT_EQ(time, launches[i].time);
    EXPECT_EQ(fire.shooter.entity, launches[i].event.detail);
    EXPECT_EQ(fire.target.entity, launches[i].event.whom.value);
    EXPECT_EQ(fire.munition.entity, launches[i].event.who.value);
    EXPECT_EQ(fire.range, launches[i].event.values[0]);
    ++i;
  }
  EXPECT_EQ(i, launches.size());
  EXPECT_EQ(ends.size(),
            sweep().events(EventKind::detonation) + sweep().events(EventKind::timeout));
  for (const auto& [time, end] : ends) {
    const Fire& fire = shots.at(end.event);
    EXPECT_EQ(end.munition, fire.munition);
    EXPECT_EQ(end.shooter, fire.shooter);
    EXPECT_EQ(end.what.type, fire.what.type);
  }
}

TEST(Announcer, SaysHowAWeaponEnded) {
  using model::EventKind;
  std::map<std::uint32_t, Detonation> ends;
  for (const auto& [time, end] : sweep().listener.of<Detonation>())
    ends.try_emplace(end.munition.entity, end);
  const auto kills = sweep().flight.log.of(EventKind::kill);
  ASSERT_GT(kills.size(), 0u);
  for (const auto& kill : kills)
    EXPECT_TRUE(kill.event.detail == 0 ||  // a gun
                ends.at(kill.event.detail).result == Result::proximate);
  for (const auto& fuze : sweep().flight.log.of(EventKind::detonation)) {
    const Detonation& end = ends.at(fuze.event.who.value);
    EXPECT_EQ(end.result == Result::proximate, fuze.event.values[2] < fuze.event.values[1]);
    // beside the target, as far as it missed and both fly on in what is left of the step
    const Vec3 place{end.place[0], end.place[1], end.place[2]};
    EXPECT_NEAR(norm(place), fuze.event.values[0], 30);
  }
  // who was missed flies on: where others reckon it, the warhead was as far away as they were told
  bool missed = false;
  for (const auto& [time, end] : sweep().listener.of<Detonation>())
    if (end.result == Result::end_game_miss) {
      const std::pair<double, EntityState>* latest = nullptr;
      const auto states = sweep().listener.of<EntityState>();
      for (const auto& told : states)
        if (told.first <= time && told.second.id == end.target)
          latest = &told;
      ASSERT_TRUE(latest);
      const Motion target = reckon(Reckoning::rvw, motion_of(latest->second), time - latest->first);
      const Vec3 place = target.attitude * (end.location - target.position);
      // off by a metre, by three degrees of the way there, and by what is flown in a step: the
      // fuze works within it, and others are told where the target is after it
      EXPECT_LT(norm(place - Vec3{end.place[0], end.place[1], end.place[2]}),
                1.1 + radians(3) * norm(place) + 0.02 * norm(target.velocity));
      missed = true;
    }
  EXPECT_TRUE(missed);
  for (const auto& late : sweep().flight.log.of(EventKind::timeout))
    EXPECT_GE(ends.at(late.event.who.value).result, Result::ground_impact);
}

TEST(Announcer, TellsABurstOfTheGunAndItsHitsTogether) {
  const auto scenario = test::load_scenario("sweep");
  const sim::World world = scenario->world(1);
  for (const float hits : {0.0f, 3.0f}) {
    Listener listener(*scenario);
    listener.announcer.begin(world, 0.02);
    const sim::Event burst{.kind = model::EventKind::gun_burst,
                           .who = PlayerId{1},
                           .whom = PlayerId{5},
                           .values = {40, 500, hits}};
    listener.announcer.observe(world, {.step = 0, .seed = 1, .dt = 0.02}, {&burst, 1});
    const auto fires = listener.of<Fire>();
    const auto ends = listener.of<Detonation>();
    ASSERT_EQ(fires.size(), 1u);
    const Fire& fire = fires[0].second;
    EXPECT_EQ(fire.munition, kNobody) << "rounds are no entities";
    EXPECT_EQ(fire.what.type, (model::EntityType{2, 9, 225, 2, 1, 3}));
    EXPECT_EQ(fire.what.quantity, 40);
    EXPECT_EQ(fire.what.rate, 6000) << "rounds a minute";
    EXPECT_EQ(fire.range, 500);
    ASSERT_EQ(ends.size(), hits > 0 ? 1u : 0u);
    if (ends.empty())
      continue;
    EXPECT_EQ(ends[0].second.event, fire.event);
    EXPECT_EQ(ends[0].second.target, (EntityId{1, 1, 5}));
    EXPECT_EQ(ends[0].second.what.quantity, 3);
    EXPECT_EQ(ends[0].second.result, Result::impact);
  }
  Listener listener(*scenario);
  listener.announcer.begin(world, 0.02);
  const sim::Event at_nobody{
      .kind = model::EventKind::gun_burst, .who = PlayerId{1}, .values = {40, model::kNothing, 0}};
  listener.announcer.observe(world, {.step = 0, .seed = 1, .dt = 0.02}, {&at_nobody, 1});
  EXPECT_EQ(listener.of<Fire>().at(0).second.range, 0) << "DIS has no other word for it";
}

TEST(Announcer, TellsOfJammers) {
  const auto emissions = Heard("jamming", 30).listener.of<Emission>();
  EXPECT_TRUE(std::any_of(emissions.begin(), emissions.end(), [](const auto& told) {
    const auto& systems = told.second.systems;
    return systems.size() == 2 && systems[1].number == 2 &&
           systems[1].beams.at(0).function == BeamFunction::jamming;
  }));
}

TEST(Announcer, TakesLeaveOfEverybody) {
  std::map<std::uint16_t, std::uint32_t> last;
  for (const auto& [time, state] : sweep().listener.of<EntityState>()) {
    EXPECT_EQ(last[state.id.entity] & kDeactivated, 0u) << "nothing is told of who has left";
    last[state.id.entity] = state.appearance;
  }
  ASSERT_GT(sweep().events(model::EventKind::home), 0u);
  const auto kills = sweep().flight.log.of(model::EventKind::kill);
  for (const auto& [id, appearance] : last) {
    const bool is_aircraft = id <= 6;  // who is home, or flies on when it is over, is whole
    const bool is_lost =
        !is_aircraft || std::any_of(kills.begin(), kills.end(),
                                    [&](const auto& k) { return k.event.whom.value == id; });
    EXPECT_EQ(appearance, is_lost ? kDeactivated | kDestroyed : kDeactivated) << id;
  }
  EXPECT_EQ(last.size(), 6 + sweep().events(model::EventKind::launch));
  ASSERT_EQ(sweep().listener.of<StartResume>().size(), 1u);
  ASSERT_EQ(sweep().listener.of<StopFreeze>().size(), 1u);
  // to our own entities: we do not manage the exercise of others
  EXPECT_EQ(sweep().listener.of<StopFreeze>()[0].second.to, (EntityId{1, 1, 0xFFFF}));
}

TEST(Announcer, TellsWhatRadarsDo) {
  bool searched = false, tracked = false, locked = false, sought = false;
  for (const auto& [time, emission] : sweep().listener.of<Emission>()) {
    ASSERT_LE(emission.systems.size(), 1u);
    for (const auto& system : emission.systems)
      for (const auto& beam : system.beams) {
        searched |= beam.function == BeamFunction::search;
        tracked |= beam.function == BeamFunction::acquisition_and_tracking;
        locked |= beam.function == BeamFunction::tracking && !beam.targets.empty();
        if (beam.function == BeamFunction::missile_seeker) {
          sought = true;
          EXPECT_GT(emission.emitter.entity, 6);
        } else {
          EXPECT_EQ(system.name, emission.emitter.entity <= 4 ? 1800 : 29430) << time;
        }
        EXPECT_EQ(beam.function == BeamFunction::search,
                  beam.targets.empty() && beam.function < BeamFunction::tracking);
      }
  }
  EXPECT_TRUE(searched && tracked && locked && sought);
  EXPECT_GT(sweep().listener.decoyed, 100);
  EXPECT_LT(sweep().listener.decoyed_with_target, sweep().listener.decoyed / 10)
      << "who flies after chaff tracks nobody";
}

TEST(Announcer, TellsWhoDecides) {
  const auto comments = sweep().listener.of<Comment>();
  const auto data = sweep().listener.of<Data>();
  ASSERT_GT(comments.size(), 20u);
  EXPECT_GE(data.size(), comments.size());
  for (const auto& [time, d] : data) {
    ASSERT_EQ(d.datums.fixed.size(), 3u);
    EXPECT_EQ(d.datums.fixed[0].id, kVote);
    const std::string& behavior = d.datums.variable.at(0).text;
    const auto vote = std::bit_cast<float>(d.datums.fixed[0].value);
    const auto said = std::find_if(comments.begin(), comments.end(), [&](const auto& c) {
      return c.first == time && c.second.from == d.from;
    });
    if (said != comments.end()) {
      EXPECT_EQ(said->second.datums.variable.at(0).text,
                fmt::format("{} decides, vote {:.0f}", behavior, vote));
    }
  }
}

TEST(Announcer, SaysInWordsWhatTheEventsHave) {
  const auto comments = sweep().listener.of<Comment>();
  const auto leads = sweep().flight.log.of(model::EventKind::in_charge);
  ASSERT_GT(leads.size(), 20u);
  for (const auto& lead : leads) {
    const std::string label =
        record::node_label(*sweep().flight.scenario, lead.event, lead.event.values[0]);
    EXPECT_TRUE(std::any_of(
        comments.begin(), comments.end(),
        [&](const auto& c) {
          return c.first == lead.time && c.second.from.entity == lead.event.who.value &&
                 c.second.datums.variable.at(0).text ==
                     fmt::format("{} decides, vote {:.0f}", label, lead.event.values[1]);
        }))
        << label << " at " << lead.time;
  }
}

TEST(Announcer, FitsEveryPacketIntoADatagram) {
  for (const Told& t : sweep().listener.told)
    ASSERT_LE(encode(t.packet).size(), 1400u);  // of one datagram of an Ethernet
  EXPECT_EQ(sweep().listener.announcer.nameless(), 0u);
}

TEST(Announcer, SaysTheSameWhateverTheWorkers) {
  const auto bytes = [](unsigned workers) {
    std::vector<std::byte> all;
    for (const Told& t : Heard("sweep", 560, {.workers = workers}).listener.told) {
      const auto packet = encode(t.packet);
      all.insert(all.end(), packet.begin(), packet.end());
    }
    return all;
  };
  EXPECT_EQ(bytes(1), bytes(3));
}

TEST(Announcer, TellsOfVehicles) {
  const Heard convoy("convoy", 20);
  std::map<std::uint16_t, EntityState> first;
  for (const auto& [time, state] : convoy.listener.of<EntityState>())
    first.try_emplace(state.id.entity, state);
  EXPECT_TRUE(std::any_of(first.begin(), first.end(), [](const auto& e) {
    return e.second.type == model::EntityType{1, 1, 225, 7, 5};
  }));
  EXPECT_LE(convoy.listener.farthest, 1 + 1e-3);
}

}  // namespace
}  // namespace eyrie::dis
