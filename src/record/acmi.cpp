// SPDX-License-Identifier: MIT
#include "record/acmi.hpp"

#include <cmath>
#include <iterator>

#include "record/names.hpp"

namespace eyrie::record {
using model::EventKind;

namespace {

constexpr double kPlayers = 0.2, kMissiles = 0.1;  // s between two samples

const char* coalition(bool blue) {
  return blue ? ",Coalition=Allies,Color=Blue" : ",Coalition=Enemies,Color=Red";
}

Pose pose_of(const model::Kinematics& k, double time) {
  return {time, k.position, k.roll, k.pitch, k.heading};
}

}  // namespace

AcmiWriter::AcmiWriter(const scenario::Scenario& scenario, Out out, double window)
    : scenario_(scenario),
      out_(std::move(out)),
      window_(window),
      story_(scenario, [this](const StoryLine& line) { tell_story(line); }) {}

AcmiSample AcmiWriter::sample_of(const model::Kinematics& k) const {
  return {.step = step_, .pose = pose_of(k, time_)};
}

void AcmiWriter::begin(const sim::World& world, double dt) {
  dt_ = dt;
  players_every_ = steps_in(kPlayers, dt);
  missiles_every_ = steps_in(kMissiles, dt);
  lines_every_ = players_every_ * static_cast<std::uint64_t>(std::lround(window_ / kPlayers));
  const Geodetic& origin = scenario_.library->reference.origin();
  header_ = fmt::format(
      "\xEF\xBB\xBF"
      "FileType=text/acmi/tacview\nFileVersion=2.2\n"
      "0,ReferenceTime=2026-01-01T12:00:00Z\n0,DataSource=Eyrie\n0,DataRecorder=Eyrie\n"
      "0,Title={}\n0,Comments={}\n0,ReferenceLongitude={:.10f}\n"
      "0,ReferenceLatitude={:.10f}\n",
      acmi_name(scenario_.spec.name), acmi_text(scenario_.spec.help_text),
      degrees(wrap_pi(origin.longitude)), degrees(origin.latitude));
  step_ = world.step();
  time_ = static_cast<double>(step_) * dt;
  for (std::size_t i = 0; i < scenario_.roster.players.size(); ++i)
    introduce(PlayerId{static_cast<std::uint32_t>(i + 1)});
  seen_.assign(scenario_.roster.players.size(), {});
  see_players(world);
  write_lines();
  pass(world);
}

void AcmiWriter::see(PlayerId id, AcmiSample sample) {
  if (const auto at = objects_.find(id.value); at != objects_.end() && !at->second.gone())
    at->second.see(std::move(sample));
}

void AcmiWriter::introduce(PlayerId id) {
  if (objects_.contains(id.value))
    return;
  const scenario::Roster::Player& player = *scenario_.roster.find(id);
  objects_.try_emplace(
      id.value, id,
      fmt::format(",Type={0},Name={1},CallSign={2},Pilot={2},Group={3},Slot={4}{5}",
                  scenario_.fleet_of(id).words.acmi, acmi_name(player.label),
                  acmi_name(player.name), acmi_name(scenario_.roster.flights[player.flight].name),
                  player.rank - 1, coalition(player.side == model::Side::blue)));
}

void AcmiWriter::see_players(const sim::World& world) {
  scenario_.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
    if (const auto at = objects_.find(id.value); at != objects_.end() && at->second.gone())
      write_lines();  // he is back
    introduce(id);
    see(id, player(fleet, world, row));
    seen_[id.value - 1] = step_;
  });
  // who is flown by another program is gone while that is not heard of
  for (std::size_t i = 0; i < seen_.size(); ++i)
    if (seen_[i] && *seen_[i] != step_) {
      gone(PlayerId{static_cast<std::uint32_t>(i + 1)});
      seen_[i].reset();
    }
}

void AcmiWriter::see_missiles(const sim::World& world) {
  for (std::size_t i = 0; i < world.rows(scenario_.missiles.table); ++i) {
    AcmiSample sample = sample_of(world.rows(scenario_.missiles.kinematics)[i]);
    sample.lock = world.rows(scenario_.missiles.state)[i].intended.value;
    see(world.ids(scenario_.missiles.table)[i], std::move(sample));
  }
}

AcmiSample AcmiWriter::player(const scenario::Fleet& fleet, const sim::World& world,
                              std::size_t row) {
  const auto& k = fleet.motion(world, row);
  const scenario::Gauges gauges = fleet.gauges(world, row);
  AcmiSample sample = sample_of(k);
  if (gauges.mach) {  // a vehicle's speed is not through the air
    sample.speed = k.speed;
    sample.mach = *gauges.mach;
  }
  sample.load_factor = gauges.load_factor.value_or(0);
  if (gauges.fuel)
    sample.fuel = std::floor(*gauges.fuel);
  sample.lock = gauges.locked.value;
  const team::LastDecision last = fleet.agents->last_decision(world, row);
  if (!last.ticks)
    return sample;
  const ubf::AnyTree* tree = fleet.trees[last.tree];
  const auto [label, is_new] = labels_.try_emplace({tree, last.node});
  if (is_new)
    label->second = acmi_name(last.node < tree->size() ? tree->node(last.node).label() : "none");
  sample.winner = label->second;
  sample.vote = last.vote;
  return sample;
}

void AcmiWriter::born(const sim::Event& e, const sim::World& world) {
  const auto row = world.row(scenario_.missiles.table, e.who);
  if (!row)
    return;
  const auto* shooter = scenario_.roster.find(PlayerId{e.detail});
  AcmiSample sample = sample_of(world.rows(scenario_.missiles.kinematics)[*row]);
  sample.lock = e.whom.value;
  objects_.try_emplace(e.who.value, e.who,
                       fmt::format(",Type=Weapon+Missile,Name={},Parent={:x}{}",
                                   acmi_name(store_label(scenario_, e.values[1])), e.detail,
                                   coalition(shooter && shooter->side == model::Side::blue)));
  see(e.who, std::move(sample));
}

void AcmiWriter::gone(PlayerId id) {
  const auto at = objects_.find(id.value);
  if (at == objects_.end() || at->second.gone())
    return;
  at->second.leave(step_ - 1);
  lines_.push_back({step_, AcmiLine::Kind::removal, fmt::format("-{:x}\n", id.value)});
}

void AcmiWriter::happened(const sim::Event& e, const sim::World& world) {
  switch (kind_of(e)) {
    case EventKind::launch:
      born(e, world);
      break;
    case EventKind::kill:
      tell("0,Event=Destroyed|{:x}|\n", e.whom.value);
      break;
    case EventKind::loss:
    case EventKind::crash:
      if (scenario_.roster.find(e.who))
        tell("0,Event=Destroyed|{:x}|\n", e.who.value);
      break;
    case EventKind::home:
      tell("0,Event=LeftArea|{:x}|\n", e.who.value);
      break;
    case EventKind::detonation:
    case EventKind::timeout:
      tell("0,Event=Timeout|SourceId:{:x}|TargetId:{:x}|Outcome:{}\n", e.who.value, e.whom.value,
           fate_of(e)->end == "kill" ? "Kill" : "Miss");
      break;
    case EventKind::phase:
      if (is_outermost(scenario_, e))
        tell("0,Event=Message|{:x}|{}: {}\n", e.who.value,
             acmi_event_text(scenario_.roster.name(e.who)),
             acmi_event_text(phase_name(scenario_, e)));
      break;
    default:
      break;
  }
  if (const auto fate = fate_of(e))
    gone(fate->who);
}

/// Of phases every player's own are told already.
void AcmiWriter::tell_story(const StoryLine& line) {
  const std::string text = acmi_event_text(fmt::format("{}: {}", line.who, line.text));
  const bool phase = line.kind == EventKind::phase;
  if (!phase)
    tell("0,Event=Message|{:x}|{}\n", line.player.value, text);
  if (phase || line.tone == Tone::kill || line.kind == EventKind::launch ||
      line.kind == EventKind::commit || line.kind == EventKind::defend)
    tell("0,Event=Bookmark|{:x}|{}\n", line.player.value, text);
}

void AcmiWriter::observe(const sim::World& world, const sim::StepInfo& info,
                         std::span<const sim::Event> events) {
  time_ = info.time_after();
  step_ = world.step();
  story_.observe(world, info, events);
  for (const sim::Event& e : events)
    happened(e, world);
  if (step_ % players_every_ == 0)
    see_players(world);
  else
    for (const sim::Event& e : events)
      if (kind_of(e) == EventKind::in_charge)
        if (const auto there = scenario_.find(world, e.who))
          see(e.who, player(there->fleet, world, there->row));
  if (step_ % missiles_every_ == 0)
    see_missiles(world);
  if (step_ % lines_every_ == 0)
    write_lines();
  pass(world);
}

/// Tells every object where it is now.
void AcmiWriter::pass(const sim::World& world) {
  const auto note = [&](PlayerId id, const model::Kinematics& k) {
    if (const auto at = objects_.find(id.value); at != objects_.end())
      at->second.pass(pose_of(k, time_));
  };
  scenario_.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
    note(id, fleet.motion(world, row));
  });
  for (std::size_t i = 0; i < world.rows(scenario_.missiles.table); ++i)
    note(world.ids(scenario_.missiles.table)[i], world.rows(scenario_.missiles.kinematics)[i]);
}

void AcmiWriter::write_lines() {
  std::vector<AcmiLine> lines;
  for (auto at = objects_.begin(); at != objects_.end();) {
    at->second.write(scenario_.library->reference, lines);
    at = at->second.gone() ? objects_.erase(at) : std::next(at);
  }
  std::move(lines_.begin(), lines_.end(), std::back_inserter(lines));
  lines_.clear();
  std::vector<const AcmiLine*> sorted;
  for (const AcmiLine& line : lines)
    sorted.push_back(&line);
  std::ranges::sort(sorted, [](const AcmiLine* a, const AcmiLine* b) {
    return std::tuple(a->step, a->kind, a) < std::tuple(b->step, b->kind, b);
  });
  std::string text = written_frame_.empty() ? header_ : "";
  for (const AcmiLine* at : sorted) {
    const AcmiLine& line = *at;
    const std::string frame =
        fmt::format("#{}\n", seconds_text(static_cast<double>(line.step) * dt_));
    if (frame != written_frame_)
      text += written_frame_ = frame;
    text += line.text;
  }
  out_(text);
}

std::string AcmiWriter::whole() const {
  std::string text = header_ + written_frame_;
  for (const auto& [id, object] : objects_)
    object.write_whole(text);
  return text;
}

void AcmiWriter::finish(const sim::World& world) {
  if (step_ % players_every_ != 0)
    see_players(world);
  if (step_ % missiles_every_ != 0)
    see_missiles(world);
  write_lines();
}

}  // namespace eyrie::record
