// SPDX-License-Identifier: MIT
#include "debrief/health.hpp"

#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "record/names.hpp"
#include "record/story.hpp"

namespace eyrie::debrief {
namespace {

using model::EventKind, model::Side;

constexpr double kFar = si(10, "nmi"), kMerged = si(5, "nmi"), kBanked = si(10, "deg"),
                 kNearMates = si(500, "ft");
constexpr double kRecommitted = 60;  ///< s, that show what turning in again was worth

class Meter final : public sim::Observer {
 public:
  explicit Meter(const scenario::Scenario& scenario)
      : s_(scenario), pilots_(s_.roster.players.size()) {}

  void begin(const sim::World&, double dt) override { dt_ = dt; }
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    time_ = info.time();
    for (const sim::Event& e : events)
      happened(world, e);
    if (world.step() % record::steps_in(0.1, dt_) == 0)
      look(world);
  }
  Health take() {
    for (Pilot& p : pilots_) {
      p.pursuit.stop();
      health_.pursued += 0.1 * static_cast<double>(p.pursuit.samples());
      health_.reversals += p.pursuit.reversals();
      health_.turned += p.pursuit.turned();
      health_.gained += p.pursuit.gained();
    }
    for (const auto& [id, shot] : shots_) {
      health_.killed += shot.killed;
      if (shot.zone >= 0) {
        auto& bin = health_.by_zone[std::min(static_cast<std::size_t>(shot.zone / Health::kBin),
                                             Health::kBins - 1)];
        ++bin.shots;
        bin.kills += shot.killed;
      }
    }
    return std::move(health_);
  }

 private:
  struct Pilot {
    Steadiness pursuit;
    TrackId track;    ///< that he attacks
    PlayerId target;  ///< last living enemy that he attacked
    std::uint64_t samples = 0;
    std::optional<double> recommitted;  ///< s, when he turned in again
  };
  struct Shot {
    PlayerId shooter, target;
    double zone = -1;  ///< range at launch, in r_ne of the true situation
    bool killed = false;
  };

  [[nodiscard]] Side side(PlayerId id) const {
    const auto* p = s_.roster.find(id);
    return p ? p->side : Side::none;
  }
  [[nodiscard]] const model::Kinematics* motion(const sim::World& world, PlayerId id) const {
    const auto row = world.row(s_.aircraft.table, id);
    return row ? &world.rows(s_.aircraft.kinematics)[*row] : nullptr;
  }

  void look(const sim::World& world) {
    const auto ids = world.ids(s_.aircraft.table);
    const auto motions = world.rows(s_.aircraft.kinematics);
    const auto agents = world.rows(s_.pilots.agent);
    const auto tracks = world.rows(s_.aircraft.tracks);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      Pilot& pilot = pilots_[ids[i].value - 1];
      const model::Kinematics& k = motions[i];
      const bool pursues = s_.fleets[0]->leader(world, i) == "pursue";
      const model::Track* target = find(tracks[i], agents[i].target);
      const bool second = pilot.samples++ % 10 == 0;
      if (pursues && second)
        health_.pursuit_mach.push_back(static_cast<float>(k.mach));
      const bool far = pursues && target && norm(position_at(*target, time_) - k.position) > kFar;
      if (far)
        pilot.pursuit.sample(time_, k.heading, k.roll);
      else
        pilot.pursuit.stop();
      if (second && merged(ids[i], k, ids, motions))
        health_.merged_mach.push_back(static_cast<float>(k.mach));
      for (std::size_t mate = i + 1; mate < ids.size(); ++mate)
        if (side(ids[i]) == side(ids[mate]) &&
            norm(motions[mate].position - k.position) < kNearMates)
          health_.near_mates = 1;
      if (target && target->id != pilot.track && enemies(ids[i], target->truth) &&
          motion(world, target->truth)) {
        pilot.track = target->id;
        took(pilot, target->truth);
      }
    }
  }
  [[nodiscard]] bool merged(PlayerId who, const model::Kinematics& k, std::span<const PlayerId> ids,
                            std::span<const model::Kinematics> motions) const {
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (enemies(who, ids[i]) && norm(motions[i].position - k.position) < kMerged)
        return true;
    return false;
  }
  [[nodiscard]] bool enemies(PlayerId a, PlayerId b) const {
    return side(b) != Side::none && side(a) != side(b);
  }
  /// A track that began anew is no other target, nor is the next one of who has lost his.
  void took(Pilot& pilot, PlayerId target) {
    if (!pilot.target)
      ++health_.engagements;
    else if (pilot.target != target && !dead_.contains(pilot.target))
      ++health_.target_changes;
    pilot.target = target;
  }
  void happened(const sim::World& world, const sim::Event& e) {
    switch (record::kind_of(e)) {
      case EventKind::launch:
        launched(world, e);
        break;
      case EventKind::kill: {
        died(e.whom);
        if (side(e.who) == side(e.whom))
          ++health_.fratricides;
        if (const auto shot = shots_.find(PlayerId{e.detail}); shot != shots_.end())
          shot->second.killed = shot->second.target == e.whom;
        break;
      }
      case EventKind::crash:
        health_.collisions += e.whom ? 1 : 0;
        [[fallthrough]];
      case EventKind::fuel_out:
      case EventKind::loss:
        died(e.who);
        break;
      case EventKind::defend:
        if (!e.whom)
          break;  // turns from a fighter
        ++health_.defenses;
        if (const auto shot = shots_.find(e.whom); shot != shots_.end())
          health_.for_others += shot->second.target != e.who && !seeks(world, e.whom, e.who);
        break;
      case EventKind::phase:
        entered(world, e.who, record::phase_name(s_, e));
        break;
      default:
        break;
    }
  }
  void died(PlayerId who) {
    if (!dead_.insert(who).second || !s_.roster.find(who))
      return;  // known, or a missile
    const Pilot& pilot = pilots_[who.value - 1];
    health_.recommits_lost += pilot.recommitted && time_ - *pilot.recommitted < kRecommitted;
  }
  void launched(const sim::World& world, const sim::Event& e) {
    Shot& shot = shots_[e.who];
    shot = {PlayerId{e.detail}, e.whom};
    ++health_.missiles;
    const model::Kinematics* own = motion(world, shot.shooter);
    if (own)
      health_.launch_mach.push_back(static_cast<float>(own->mach));
    const model::Kinematics* target = motion(world, shot.target);
    if (dead_.contains(shot.target) || !target) {
      ++health_.at_the_dead;
      return;
    }
    if (!own)
      return;
    const auto zone = s_.library->missiles[static_cast<std::size_t>(e.values[1])].zone.at(
        model::weapon::launch_situation(party(*own), party(*target)));
    const double range = norm(target->position - own->position);
    if (zone.r_ne > 0)
      shot.zone = range / zone.r_ne;
  }
  [[nodiscard]] model::weapon::LaunchParty party(const model::Kinematics& k) const {
    return {k.position, through_air(k, s_.library->environment.wind), k.altitude};
  }
  void entered(const sim::World& world, PlayerId who, std::string_view phase) {
    if (phase == "recommit") {
      ++health_.recommits;
      pilots_[who.value - 1].recommitted = time_;
    }
    if (phase == "egress")
      health_.left_fighting |= any_enemy(world, who);
    if (phase != "wvr")
      return;
    ++health_.wvr;
    health_.wvr_seen += sees_enemy(world, who);
  }
  [[nodiscard]] bool any_enemy(const sim::World& world, PlayerId of) const {
    const auto ids = world.ids(s_.aircraft.table);
    return std::ranges::any_of(ids, [&](PlayerId id) { return enemies(of, id); });
  }
  /// Whether somebody is whom the seeker of a missile saw last, whomever it was shot at: it rests
  /// on him, or looks for him where he must be.
  [[nodiscard]] bool seeks(const sim::World& world, PlayerId missile, PlayerId whom) const {
    const auto row = world.row(s_.missiles.table, missile);
    return row && world.rows(s_.missiles.state)[*row].seen == whom;
  }
  /// Whether an eye of his flight saw a living enemy in the last 5 s.
  [[nodiscard]] bool sees_enemy(const sim::World& world, PlayerId who) const {
    const auto* player = s_.roster.find(who);
    for (const PlayerId member : s_.roster.flights[player->flight].members) {
      const auto row = world.row(s_.aircraft.table, member);
      if (!row)
        continue;
      const model::TrackFile& file = world.rows(s_.aircraft.tracks)[*row];
      for (std::uint32_t i = 0; i < file.count; ++i) {
        const model::Track& t = file.tracks[i];
        if (time_ - t.seen_time < 5 && enemies(who, t.truth) && motion(world, t.truth))
          return true;
      }
    }
    return false;
  }

  const scenario::Scenario& s_;
  Health health_;
  std::vector<Pilot> pilots_;
  std::map<PlayerId, Shot> shots_;  ///< by missile
  std::set<PlayerId> dead_;
  double time_ = 0, dt_ = 0;
};

}  // namespace

void Steadiness::sample(double time, double heading, double roll) {
  if (watched_ && time - begin_ >= kWindow) {
    const int bank = bank_;
    stop();
    bank_ = bank;
  }
  if (!watched_) {
    watched_ = true;
    begin_ = time;
    first_ = heading_ = heading;
  }
  ++samples_;
  turned_ += std::abs(wrap_pi(heading - heading_));
  heading_ = heading;
  if (std::abs(roll) < kBanked)
    return;
  const int side = roll > 0 ? 1 : -1;
  reversals_ += bank_ == -side;
  bank_ = side;
}

void Steadiness::stop() {
  if (watched_)
    gained_ += std::abs(wrap_pi(heading_ - first_));
  watched_ = false;
  bank_ = 0;
}

void Health::add(const Health& o) {
  for (const auto sum :
       {&Health::runs, &Health::reversals, &Health::killed, &Health::missiles, &Health::at_the_dead,
        &Health::fratricides, &Health::engagements, &Health::target_changes, &Health::wvr,
        &Health::wvr_seen, &Health::defenses, &Health::for_others, &Health::near_mates,
        &Health::collisions, &Health::recommits, &Health::recommits_lost, &Health::undecided,
        &Health::left_fighting})
    this->*sum += o.*sum;
  for (const auto sum : {&Health::pursued, &Health::turned, &Health::gained})
    this->*sum += o.*sum;
  for (const auto all : {&Health::pursuit_mach, &Health::launch_mach, &Health::merged_mach})
    (this->*all).insert((this->*all).end(), (o.*all).begin(), (o.*all).end());
  for (std::size_t i = 0; i < kBins; ++i) {
    by_zone[i].shots += o.by_zone[i].shots;
    by_zone[i].kills += o.by_zone[i].kills;
  }
  for (const auto sides : {&Health::lost, &Health::players, &Health::won})
    for (std::size_t i = 0; i < 2; ++i)
      (this->*sides)[i] += (o.*sides)[i];
}

Health measure(const std::shared_ptr<const scenario::Scenario>& scenario, std::uint64_t seed) {
  record::Tally tally(*scenario);
  Meter meter(*scenario);
  scenario::Mission mission(scenario, seed);
  mission.run().attach(tally);
  mission.run().attach(meter);
  mission.fly();
  Health h = meter.take();
  h.runs = 1;
  const auto blue = tally.side(Side::blue), red = tally.side(Side::red);
  h.lost = {blue.losses, red.losses};
  h.players = {blue.players, red.players};
  h.won = {blue.losses < red.losses, red.losses < blue.losses};
  h.undecided = mission.outcome() == scenario::Outcome::time && blue.losses < blue.players &&
                red.losses < red.players;
  return h;
}

}  // namespace eyrie::debrief
