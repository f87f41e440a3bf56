// SPDX-License-Identifier: MIT
#include "page/page.hpp"

#include "core/hash.hpp"
#include "debrief/decision.hpp"
#include "page/decisions.hpp"
#include "page/seen.hpp"
#include "record/json_text.hpp"
#include "record/story.hpp"
#include "ubf/sequencer.hpp"

namespace eyrie::page {
namespace {

/// How often things are kept, in s.
struct Periods {
  double motion = 0.5, sights = 0.5;
  double decisions = 0;        ///< that are as the last one was; 0: all
  double other_decisions = 0;  ///< that are not
};

Periods periods(std::size_t players, double player_seconds, double plenty) {
  if (players <= kManyPlayers && player_seconds <= plenty)
    return {};
  if (player_seconds <= plenty)
    return {.motion = 1, .sights = 5, .decisions = 1};
  const double slower = player_seconds / plenty;
  return {
      .motion = slower, .sights = 5 * slower, .decisions = slower, .other_decisions = slower / 10};
}

/// What one agent decided and saw.
struct Agent {
  Decisions decisions;
  Sights sights;
};

/// What the decisions of all agents of one platform are put together with.
template <class State, class Action>
class Platform {
 public:
  using Trees = ubf::Trees<State, Action>;
  /// Its trees are numbered from `first` on.
  Platform(const Trees& trees, std::size_t first)
      : trees_(trees), first_(first), trace_(trees.max_size()) {
    for (const auto& tree : trees)
      blank_.push_back(team::unanswered(tree));
  }

  /// Keeps a decision; `see` is called with what the agent saw, and whether it is time to keep
  /// that.
  template <class See>
  void decide(const team::Moment<State>& m, Agent& agent, const Periods& periods, See see) {
    const std::uint16_t tree = m.state.agent.tree;
    const auto out = team::ask_again(trees_[tree], m, &trace_);
    const bool changed =
        agent.decisions.add(m.info.step, first_ + tree, blank_[tree], out.leader, trace_,
                            {periods.decisions / m.info.dt, periods.other_decisions / m.info.dt});
    see(m.state, changed || m.info.time() - agent.sights.last_time() > periods.sights - 1e-6);
  }

  /// As the page draws them; `platform` is "aircraft" or "vehicle".
  void put_trees(std::string_view platform, Json& all) const {
    for (std::uint16_t t = 0; t < trees_.size(); ++t) {
      const ubf::Tree<State, Action>& tree = trees_[t];
      Json nodes = Json::array();
      for (std::size_t i = 0; i < blank_[t].size(); ++i) {
        const auto& node = tree.node(static_cast<ubf::NodeIndex>(i));
        const debrief::Answer& answer = blank_[t][i];
        Json params = Json::object();
        for (const ParamValue& param : node.values())
          params[param.name] = param.text;
        nodes.push_back(
            {{"label", answer.label},
             {"type", answer.type},
             {"path", answer.path},
             {"kind", to_text(node.node_kind())},
             {"parent", answer.parent == ubf::kNone ? -1 : static_cast<int>(answer.parent)},
             {"depth", answer.depth},
             {"params", std::move(params)},
             {"remembers", node.remembers()}});
        if (const auto* sequencer = dynamic_cast<const ubf::Sequencer<State, Action>*>(&node))
          for (const auto& [from, to] : sequencer->rules())  // of its last children, in their order
            nodes.back()["rules"].push_back({from == ubf::kNone ? -1 : static_cast<int>(from), to});
      }
      all.push_back({{"name", tree.name()}, {"kind", platform}, {"nodes", std::move(nodes)}});
    }
  }
  [[nodiscard]] static Json fields() {
    Json state = Json::array();
    for (const auto& field : ubf::StateFields<State>::all()) {
      const auto kind = field.info.kind;
      Json one{{"name", field.info.name},
               {"unit", field.info.unit.si_symbol},
               {"form", team::form_of(field.info.name, field.info.unit.dimension)},
               {"kind", kind == ubf::FieldKind::number ? "number"
                        : kind == ubf::FieldKind::flag ? "flag"
                                                       : "choice"},
               {"choices", Json::array()}};
      for (const auto choice : field.info.choices)
        one["choices"].push_back(choice);
      state.push_back(std::move(one));
    }
    return {{"action", action_fields<Action>()}, {"state", std::move(state)}};
  }

 private:
  const Trees& trees_;
  std::size_t first_;
  ubf::Trace<Action> trace_;
  std::vector<std::vector<debrief::Answer>> blank_;
};

class Writer final : public Packer {
 public:
  Writer(const scenario::Scenario& scenario, double until, double plenty)
      : scenario_(scenario),
        periods_(periods(scenario_.roster.players.size(),
                         static_cast<double>(scenario_.roster.players.size()) * until, plenty)),
        shapes_(texts_),
        pilots_(*scenario_.trees, 0),
        drivers_(*scenario_.driver_trees, scenario_.trees->size()),
        pilot_system_(debrief::find_system<pilot::PilotSystem>(*scenario_.simulation)),
        driver_system_(debrief::find_system<driver::DriverSystem>(*scenario_.simulation)),
        motions_(scenario_, periods_.motion),
        story_(scenario_, [this](const record::StoryLine& line) { tell(line); }),
        known_(known()) {
    for (std::size_t i = 0; i < scenario_.roster.players.size(); ++i)
      agents_.push_back({Decisions(shapes_, texts_), Sights(scenario_, texts_)});
  }

  void remember(const sim::World& world, const debrief::Happened& happened) override {
    motions_.remember(world, happened.info, happened.events);
    story_.observe(world, happened.info, happened.events);
  }
  void begin(const sim::World& world, double dt) override { motions_.begin(world, dt); }
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    motions_.observe(world, info, events);
    story_.observe(world, info, events);
  }
  void finish(const sim::World& world) override { motions_.finish(world); }

  [[nodiscard]] std::string packed(const FlightFacts& facts) const override {
    ColumnBytes bytes;
    return whole(json(facts, bytes), bytes);
  }
  [[nodiscard]] std::string take(const FlightFacts& facts) override {
    ColumnBytes bytes;
    Json document = json(facts, bytes);
    document["now"] = motions_.now();
    taken_ = true;
    texts_.take();
    shapes_.take();
    motions_.forget();
    for (Agent& agent : agents_) {
      agent.decisions.forget();
      agent.sights.forget();
    }
    lines_ = Json::array();
    return whole(document, bytes);
  }

  void look(const sim::World& before, const sim::World& after,
            std::span<const sim::Order> orders) override {
    for (std::size_t i = 0; i < agents_.size(); ++i) {
      const PlayerId who{static_cast<std::uint32_t>(i + 1)};
      Agent& agent = agents_[i];
      if (scenario_.fleet_of(who).agents == driver_system_)
        driver_system_->revisit(
            before, after, who, orders, [&](const team::Moment<driver::State>& m) {
              drivers_.decide(m, agent, periods_, [&](const driver::State& s, bool is_time) {
                if (is_time)
                  agent.sights.add(s);
              });
            });
      else
        pilot_system_->revisit(
            before, after, who, orders, [&](const team::Moment<pilot::State>& m) {
              pilots_.decide(m, agent, periods_, [&](const pilot::State& s, bool is_time) {
                // a decision that is kept names tracks as they are then
                const bool keeps_all = periods_.decisions == 0;
                if (is_time || (keeps_all && agent.sights.names_others(s)))
                  agent.sights.add(s, after, who);
              });
            });
    }
  }

 private:
  void tell(const record::StoryLine& line) {
    constexpr const char* kTones[] = {"plain", "blue", "red", "kill", "phase"};
    lines_.push_back({{"t", line.time},
                      {"kind", model::event_name(line.kind)},
                      {"tone", kTones[static_cast<std::size_t>(line.tone)]},
                      {"who", index_of(scenario_.roster, line.player)},
                      {"name", line.who},
                      {"text", line.text},
                      {"decider", index_of(scenario_.roster, line.decider)},
                      {"decided", line.decided}});
  }

  [[nodiscard]] static std::string whole(const Json& document, const ColumnBytes& columns) {
    const std::string text = record::json_text(document);
    std::string all;
    for (int shift = 0; shift < 32; shift += 8)
      all.push_back(static_cast<char>(text.size() >> shift & 255));
    return all + text + columns.bytes();
  }
  [[nodiscard]] Json json(const FlightFacts& facts, ColumnBytes& bytes) const {
    Json players = Json::array();
    for (std::size_t i = 0; i < agents_.size(); ++i)
      players.push_back(player(i, bytes));
    Json all{{"format", 2},
             {"about", about(facts)},
             {"players", std::move(players)},
             {"missiles", motions_.missiles(bytes)},
             {"shapes", shapes_.json()},
             {"texts", texts_.left()},
             {"story", lines_}};
    if (!taken_)
      all.update(known_);
    return all;
  }
  /// What is known before the flight.
  [[nodiscard]] Json known() const {
    Json all;
    const Geodetic& origin = scenario_.library->reference.origin();
    all["origin"] = {{"latitude", degrees(origin.latitude)},
                     {"longitude", degrees(origin.longitude)}};
    all["flights"] = flights();
    all["stores"] = Json::array();  // as releases count them
    for (std::uint16_t i = 0; i < scenario_.library->missiles.size(); ++i)
      all["stores"].push_back(scenario_.library->missiles[i].label);
    all["trees"] = Json::array();
    pilots_.put_trees("aircraft", all["trees"]);
    drivers_.put_trees("vehicle", all["trees"]);
    all["platforms"] = {{"aircraft", Platform<pilot::State, pilot::Action>::fields()},
                        {"vehicle", Platform<driver::State, driver::Action>::fields()}};
    return all;
  }

  [[nodiscard]] Json about(const FlightFacts& facts) const {
    const double dt = scenario_.simulation->dt();
    const double period = pilot_system_->setup().dt * pilot_system_->setup().period;
    return {{"scenario", scenario_.spec.name},
            {"help", scenario_.spec.help_text},
            {"file", facts.file},
            {"seed", std::to_string(facts.seed)},
            {"sets", scenario_.sets},
            {"hash", hash_text(facts.hash)},
            {"build", facts.build},
            {"steps", facts.steps},
            {"dt", dt},
            {"duration", static_cast<double>(facts.steps) * dt},
            {"outcome", facts.outcome},
            {"decision_period", std::max(periods_.decisions, period)},
            {"thinned", periods_.decisions > 0}};
  }

  [[nodiscard]] Json flights() const {
    const model::Library& library = *scenario_.library;
    Json all = Json::array();
    for (const model::Flight& flight : library.flights) {
      Json members = Json::array(), route = Json::array(), home;
      std::string_view kind = "aircraft";
      for (const PlayerId id : flight.members) {
        members.push_back(id.value - 1);
        kind = scenario_.fleet_of(id).words.name;
      }
      if (!flight.routes.empty())
        for (const model::Waypoint& waypoint : flight.routes[0].waypoints) {
          const OnMap at = on_map(library.reference, waypoint.position);
          route.push_back({at.east, at.north, waypoint.altitude,
                           waypoint.speed ? Json(*waypoint.speed) : Json()});
        }
      if (flight.home) {
        const OnMap at = on_map(library.reference, *flight.home);
        home = {at.east, at.north, at.up};
      }
      all.push_back({{"name", flight.name},
                     {"side", scenario::side_name(flight.side)},
                     {"kind", kind},
                     {"members", std::move(members)},
                     {"route", std::move(route)},
                     {"home", std::move(home)}});
    }
    return all;
  }

  [[nodiscard]] Json player(std::size_t index, ColumnBytes& bytes) const {
    Json j = motions_.player(index, bytes);
    if (const auto& p = scenario_.roster.players[index]; !taken_)
      j.update({{"name", p.name},
                {"side", scenario::side_name(p.side)},
                {"kind", scenario_.fleets[p.fleet]->words.name},
                {"type", p.label},
                {"model", p.type},
                {"flight", p.flight},
                {"remote", p.remote},
                {"radar", radar(p.type)}});
    const auto& [decisions, sights] = agents_[index];
    j["decisions"] = taken_ && decisions.empty() ? Json() : decisions.json(bytes);
    j["sights"] = taken_ && sights.empty() ? Json() : sights.json(bytes);
    return j;
  }
  [[nodiscard]] Json radar(const std::string& type) const {
    const model::Library& library = *scenario_.library;
    const auto at = library.aircraft.find(type);
    if (!at || !library.aircraft[*at].index.radar)
      return {};
    const model::Radar& radar = library.radars[*library.aircraft[*at].index.radar];
    return {{"azimuth", radar.scan_half_azimuth},
            {"elevation", (radar.scan_bars * radar.bar_spacing + radar.beam_width) / 2},
            {"range", radar.reference_range}};
  }

  const scenario::Scenario& scenario_;
  Periods periods_;
  TextBook texts_;
  ShapeBook shapes_;
  Platform<pilot::State, pilot::Action> pilots_;
  Platform<driver::State, driver::Action> drivers_;
  const pilot::PilotSystem* pilot_system_;
  const driver::DriverSystem* driver_system_;
  std::vector<Agent> agents_;
  Motions motions_;
  record::Story story_;
  Json lines_ = Json::array();
  Json known_;
  bool taken_ = false;
};

}  // namespace

std::unique_ptr<Packer> make_packer(const scenario::Scenario& scenario, double until,
                                    double plenty) {
  return std::make_unique<Writer>(scenario, until, plenty);
}

FlightFacts facts_of(const debrief::Recorded& recorded) {
  const record::RunFile& run = recorded.run;
  return {run.scenario, run.build,           run.outcome,
          run.seed,     run.trail.last_hash, recorded.last_step()};
}

}  // namespace eyrie::page
