// SPDX-License-Identifier: MIT
#include "record/acmi.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/angle.hpp"
#include "record/acmi_text.hpp"
#include "record/names.hpp"

namespace eyrie::record {
using model::EventKind;

namespace {

constexpr std::uint64_t kPlayersEvery = 10, kMissilesEvery = 5;  // steps at 50 Hz

}  // namespace

AcmiWriter::AcmiWriter(const scenario::Scenario& scenario, disk::Sink& sink)
    : scenario_(scenario), sink_(sink), shown_(scenario.roster.players.size()) {}

void AcmiWriter::flush() {
  sink_.write({out_.data(), out_.size()});
  out_.clear();
}

void AcmiWriter::frame(double time) {
  if (time == written_time_)
    return;
  written_time_ = time;
  fmt::format_to(std::back_inserter(out_), "#{:.2f}\n", time);
}

void AcmiWriter::place(PlayerId id, const model::Kinematics& k) {
  const Reference& reference = scenario_.library->reference;
  const Geodetic at = reference.to_geodetic(k.position);
  const Geodetic& origin = reference.origin();
  fmt::format_to(std::back_inserter(out_), "{:x},T={:.7f}|{:.7f}|{:.2f}|{:.1f}|{:.1f}|{:.1f}",
                 id.value, degrees(wrap_pi(at.longitude - origin.longitude)),
                 degrees(at.latitude - origin.latitude), at.altitude, degrees(k.roll),
                 degrees(k.pitch), degrees(wrap_tau(k.heading)));
}

void AcmiWriter::begin(const sim::World& world, double dt) {
  dt_ = dt;
  const Geodetic& origin = scenario_.library->reference.origin();
  fmt::format_to(std::back_inserter(out_),
                 "\xEF\xBB\xBF"
                 "FileType=text/acmi/tacview\nFileVersion=2.2\n"
                 "0,ReferenceTime=2026-01-01T12:00:00Z\n0,DataSource=Eyrie\n0,DataRecorder=Eyrie\n"
                 "0,Title={}\n0,Comments={}\n0,ReferenceLongitude={:.10f}\n"
                 "0,ReferenceLatitude={:.10f}\n",
                 acmi_name(scenario_.spec.name), acmi_text(scenario_.spec.help_text),
                 degrees(origin.longitude), degrees(origin.latitude));
  time_ = static_cast<double>(world.step()) * dt;
  frame(time_);
  const auto ids = world.ids(scenario_.aircraft.table);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto& player = scenario_.roster.players[ids[i].value - 1];
    aircraft(world, i);
    introduce(player, "Air+FixedWing");
  }
  if (scenario_.vehicles)
    for (std::size_t i = 0; i < world.rows(scenario_.vehicles->table); ++i) {
      const PlayerId id = world.ids(scenario_.vehicles->table)[i];
      vehicle(world, i);
      introduce(*scenario_.roster.find(id), "Ground+Vehicle");
    }
}

void AcmiWriter::introduce(const scenario::Roster::Player& player, std::string_view type) {
  const bool blue = player.side == model::Side::blue;
  out_.resize(out_.size() - 1);  // the same line says who it is
  fmt::format_to(std::back_inserter(out_),
                 ",Type={},Name={},CallSign={},Pilot={},Group={},Slot={},Coalition={},Color={}\n",
                 type, acmi_name(player.label), acmi_name(player.name), acmi_name(player.name),
                 acmi_name(scenario_.roster.flights[player.flight].name), player.rank - 1,
                 blue ? "Allies" : "Enemies", blue ? "Blue" : "Red");
}

template <class Agent, class Trees>
void AcmiWriter::winner(Shown& shown, const Agent& agent, const Trees& trees) {
  const std::uint32_t behavior = (std::uint32_t{agent.tree} << 16) | agent.node;
  if (!agent.ticks || (behavior == shown.behavior && agent.vote == shown.vote))
    return;
  const auto& tree = trees[agent.tree];
  const std::string label =
      acmi_name(agent.node < tree.size() ? tree.node(agent.node).label() : "none");
  fmt::format_to(std::back_inserter(out_), ",UbfWinner={},UbfVote={:g},Label={} {:g}", label,
                 agent.vote, label, agent.vote);
  shown.behavior = behavior;
  shown.vote = agent.vote;
}

void AcmiWriter::vehicle(const sim::World& world, std::size_t row) {
  const PlayerId id = world.ids(scenario_.vehicles->table)[row];
  const auto& k = world.rows(scenario_.vehicles->kinematics)[row];
  place(id, k);
  fmt::format_to(std::back_inserter(out_), ",TAS={:.1f}", k.speed);
  winner(shown_[id.value - 1], world.rows(scenario_.drivers.agent)[row], *scenario_.driver_trees);
  out_.push_back('\n');
}

void AcmiWriter::players(const sim::World& world) {
  for (std::size_t i = 0; i < world.rows(scenario_.aircraft.table); ++i)
    aircraft(world, i);
  if (scenario_.vehicles)
    for (std::size_t i = 0; i < world.rows(scenario_.vehicles->table); ++i)
      vehicle(world, i);
}

void AcmiWriter::aircraft(const sim::World& world, std::size_t row) {
  const PlayerId id = world.ids(scenario_.aircraft.table)[row];
  Shown& shown = shown_[id.value - 1];
  const auto& k = world.rows(scenario_.aircraft.kinematics)[row];
  const auto& tracks = world.rows(scenario_.aircraft.tracks)[row];
  const TrackId wanted = world.rows(scenario_.aircraft.request)[row].target;
  const double fuel = std::floor(world.rows(scenario_.aircraft.propulsion)[row].fuel);

  place(id, k);
  fmt::format_to(std::back_inserter(out_), ",TAS={:.1f},Mach={:.3f},VerticalGForce={:.1f}", k.speed,
                 k.mach, k.load_factor);
  if (fuel != shown.fuel)
    fmt::format_to(std::back_inserter(out_), ",FuelWeight={:.0f}", shown.fuel = fuel);
  std::uint64_t locked = 0;
  for (std::uint32_t i = 0; i < tracks.count; ++i)
    if (wanted && tracks.tracks[i].id == wanted)
      locked = tracks.tracks[i].truth.value;
  if (locked != shown.locked) {
    if (locked)
      fmt::format_to(std::back_inserter(out_), ",LockedTargetMode=1,LockedTarget={:x}", locked);
    else
      fmt::format_to(std::back_inserter(out_), ",LockedTargetMode=0,LockedTarget=0");
    shown.locked = locked;
  }
  winner(shown, world.rows(scenario_.pilots.agent)[row], *scenario_.trees);
  out_.push_back('\n');
}

void AcmiWriter::new_missile(const sim::Event& e, const sim::World& world) {
  const auto row = world.row(scenario_.missiles.table, e.who);
  if (!row)
    return;
  const auto& k = world.rows(scenario_.missiles.kinematics)[*row];
  const auto* shooter = scenario_.roster.find(PlayerId{e.detail});
  const bool blue = shooter && shooter->side == model::Side::blue;
  place(e.who, k);
  fmt::format_to(std::back_inserter(out_),
                 ",Type=Weapon+Missile,Name={},Parent={:x},Coalition={},Color={}",
                 acmi_name(store_label(scenario_, e.values[1])), e.detail,
                 blue ? "Allies" : "Enemies", blue ? "Blue" : "Red");
  if (e.whom)
    fmt::format_to(std::back_inserter(out_), ",LockedTargetMode=1,LockedTarget={:x}", e.whom.value);
  out_.push_back('\n');
}

void AcmiWriter::happened(const sim::Event& e, const sim::World& world) {
  const auto to = std::back_inserter(out_);
  switch (kind_of(e)) {
    case EventKind::launch:
      new_missile(e, world);
      break;
    case EventKind::kill:
      fmt::format_to(to, "0,Event=Destroyed|{:x}|\n", e.whom.value);
      gone_.push_back(e.whom);
      break;
    case EventKind::loss:
    case EventKind::crash:
      if (scenario_.roster.find(e.who))
        fmt::format_to(to, "0,Event=Destroyed|{:x}|\n", e.who.value);
      gone_.push_back(e.who);
      break;
    case EventKind::home:
      fmt::format_to(to, "0,Event=LeftArea|{:x}|\n", e.who.value);
      gone_.push_back(e.who);
      break;
    case EventKind::detonation:
    case EventKind::timeout: {
      const bool kill = kind_of(e) == EventKind::detonation && e.values[2] < e.values[1];
      fmt::format_to(to, "0,Event=Timeout|SourceId:{:x}|TargetId:{:x}|Outcome:{}\n", e.who.value,
                     e.whom.value, kill ? "Kill" : "Miss");
      gone_.push_back(e.who);
      break;
    }
    case EventKind::phase:
      if (is_outermost(scenario_, e))
        fmt::format_to(to, "0,Event=Message|{:x}|{}: {}\n", e.who.value,
                       acmi_event_text(scenario_.roster.name(e.who)),
                       acmi_event_text(phase_name(scenario_, e)));
      break;
    case EventKind::lead_change:
      fmt::format_to(to, "0,Event=Message|{:x}|{} leads\n", e.who.value,
                     acmi_event_text(scenario_.roster.name(e.who)));
      break;
    default:
      break;
  }
}

void AcmiWriter::observe(const sim::World& world, const sim::StepInfo& info,
                         std::span<const sim::Event> events) {
  time_ = info.time() + info.dt;
  gone_.clear();
  for (const sim::Event& e : events) {
    const std::size_t before = out_.size();
    const double last = written_time_;
    frame(time_);
    const std::size_t framed = out_.size();
    happened(e, world);
    if (out_.size() == framed) {  // nothing to tell: take the frame back
      out_.resize(before);
      written_time_ = last;
    }
  }
  if (world.step() % kPlayersEvery == 0) {
    frame(time_);
    players(world);
  }
  const auto missiles = world.ids(scenario_.missiles.table);
  if (world.step() % kMissilesEvery == 0 && !missiles.empty()) {
    frame(time_);
    const auto kinematics = world.rows(scenario_.missiles.kinematics);
    for (std::size_t i = 0; i < missiles.size(); ++i) {
      place(missiles[i], kinematics[i]);
      out_.push_back('\n');
    }
  }
  std::sort(gone_.begin(), gone_.end());
  gone_.erase(std::unique(gone_.begin(), gone_.end()), gone_.end());
  for (const PlayerId id : gone_)
    fmt::format_to(std::back_inserter(out_), "-{:x}\n", id.value);
  if (out_.size() > 1 << 18)
    flush();
}

void AcmiWriter::finish(const sim::World& world) {
  frame(time_);
  players(world);
  flush();
}

}  // namespace eyrie::record
