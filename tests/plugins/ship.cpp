// SPDX-License-Identifier: MIT
/// \file  A third kind of player in one file: ships, which sail a route and turn away from
/// aircraft. Nothing of Eyrie knows them.
#include <algorithm>
#include <array>

#include "core/angle.hpp"
#include "core/bind.hpp"
#include "core/math.hpp"
#include "model/motion_check.hpp"
#include "model/vehicle/vehicle.hpp"
#include "scenario/assemble.hpp"
#include "scenario/player_kind.hpp"
#include "scenario/spec.hpp"
#include "team/decision.hpp"
#include "team/member.hpp"
#include "ubf/standard_nodes.hpp"

namespace ship {
using namespace eyrie;

// rows

/// The nearest aircraft, as the lookout sees it.
struct Horizon {
  double range = 1e9;   ///< m
  double bearing = 0;   ///< rad, true
  PlayerId aircraft{};  ///< none: nobody is there
  std::uint32_t reserved = 0;
  static constexpr auto fields() {
    return field_list(field("range", &Horizon::range, "m"),
                      field("bearing", &Horizon::bearing, "rad"),
                      field("aircraft", &Horizon::aircraft), field("reserved", &Horizon::reserved));
  }
};
struct Agent {
  static constexpr std::string_view system = "captain";
  std::uint64_t decided = 0;
  std::uint32_t ticks = 0;
  float vote = 0;
  std::uint16_t tree = team::kNoTree, node = ubf::kNone, phase = ubf::kNone, call = 0;
  static constexpr auto fields() {
    return field_list(field("decided", &Agent::decided), field("ticks", &Agent::ticks),
                      field("vote", &Agent::vote), field("tree", &Agent::tree),
                      field("node", &Agent::node), field("phase", &Agent::phase),
                      field("call", &Agent::call));
  }
};
struct Columns : sim::Table<Columns> {
  sim::Column<model::Fit> fit;
  sim::Column<model::Kinematics> kinematics;
  sim::Column<model::Driving> helm;
  sim::Column<model::DriveCommand> command;
  sim::Column<Horizon> horizon;
  static constexpr std::string_view table_name = "ship";
  static constexpr auto columns() {
    using C = Columns;
    using sim::column, sim::WrittenBy;
    using enum sim::Phase;
    return std::tuple{column("fit", &C::fit),
                      column("kinematics", &C::kinematics, WrittenBy{"ship", move}),
                      column("helm", &C::helm, WrittenBy{"ship", move}),
                      column("command", &C::command, WrittenBy{"captain", decide}),
                      column("horizon", &C::horizon, WrittenBy{"ship", perceive})};
  }
};

// what a captain perceives and wants

struct Action {
  std::optional<double> heading, speed;
};
struct Bridge {
  const model::Kinematics& own;
  const model::Driving& helm;
  const Horizon& horizon;
  const Agent& agent;
  static constexpr auto columns() {
    return std::tuple{&Columns::kinematics, &Columns::helm, &Columns::horizon};
  }
};
const model::VehicleType& hull() {
  static const model::VehicleType type = [] {
    model::VehicleType made;
    made.wheelbase = 80;
    made.top_speed = 15;
    made.acceleration = 0.2;
    made.braking = 0.2;
    made.capture_radius = 200;
    made.prepare();
    return made;
  }();
  return type;
}
struct Plan {};
struct State : Bridge {
  State(const Bridge& bridge, const model::Library& library, const model::Fit& fit, const Plan&,
        double now)
      : Bridge(bridge), group(library.flights[fit.flight]), time(now) {}

  const model::Flight& group;
  double time;

  bool leads() const { return true; }
  std::optional<team::Leader> leader() const { return std::nullopt; }
  Vec3 place() const { return {}; }
  double forward_of(const team::Leader&) const { return own.heading; }
  std::span<const model::Route> routes() const { return group.routes; }
  model::NavState nav() const { return helm.nav; }
  const model::flight::GuidanceGains& guidance() const { return hull().guidance; }
  Vec3 wind() const { return {}; }
};
std::vector<team::Perceived> perceived(const State& s) {
  if (!s.horizon.aircraft)
    return {};
  return {{"aircraft", 1, s.horizon.aircraft, {team::number_value("range", "m", s.horizon.range)}}};
}

}  // namespace ship

template <>
struct eyrie::ubf::ActionTraits<ship::Action> {
  static constexpr auto fields =
      std::tuple{field<blend::Angle>("heading", &ship::Action::heading, "rad", {-1e4, 1e4}),
                 field<blend::Mean>("speed", &ship::Action::speed, "m/s", {-100, 100})};
};
template <>
struct eyrie::ubf::StateFields<ship::State> {
  static std::span<const StateField<ship::State>> all() {
    static constexpr std::array kFields{FieldsOf<ship::State>::number(
        "aircraft_range", "m", "to the nearest aircraft",
        [](const ship::State& s) { return s.horizon.aircraft ? s.horizon.range : kNoValue; })};
    return kFields;
  }
};

namespace ship {

struct Platform {
  using State = ship::State;
  using Action = ship::Action;
  using Agent = ship::Agent;
  using Columns = ship::Columns;
  using Plan = ship::Plan;
  using View = Bridge;
  struct Controls {
    model::DriveCommand& command;
    static constexpr auto columns() { return std::tuple{&Columns::command}; }
  };
  struct Teller : team::Telling {
    Teller(PlayerId who, const State& state, sim::Outbox& out)
        : Telling(who, state.own.position, out) {}
    void notice(Agent&, const model::Fit&) const {}
    void changes(const Agent& before, const ubf::Proposal<Action>&, const Agent& agent) const {
      in_charge(before, agent);
    }
  };
  static constexpr double cruise = 8;
  static constexpr auto speeds = range(0.5, 20);
  static constexpr std::string_view speed_help = "on legs that give none";
  static constexpr std::uint16_t kOrder = 40;
  static constexpr sim::OrderKind swap_tree{kOrder};

  static void account(const State&, Agent&) {}
  static void rest(const Controls&) {}
  static void execute(const Action& action, const State&, const Controls& controls, Agent&) {
    controls.command.heading = wrap_pi(action.heading.value_or(controls.command.heading));
    controls.command.speed = action.speed.value_or(controls.command.speed);
  }
};

using Tick = ubf::Tick<State>;
using Proposal = ubf::Proposal<Action>;

class Navigate final : public team::Navigate<Platform> {
 public:
  static constexpr std::string_view help = "sails along the route";
  ubf::Status tick(const Tick& t, Proposal& out) const override { return go(t, out).status; }
};
class TurnAway final : public ubf::Behavior<State, Action> {
 public:
  static constexpr std::string_view type_name = "turn_away", help = "away from an aircraft";
  ubf::Status tick(const Tick& t, Proposal& out) const override {
    if (!t.state.horizon.aircraft)
      return fails(t, "nobody is in sight");
    out.action.heading = wrap_tau(t.state.horizon.bearing + kPi);
    out.action.speed = 15;
    out.vote = 50;
    return ubf::Status::running;
  }
};

/// Looks out, moves, and lowers its boats, for which the table has no room.
class Ships final : public sim::System {
 public:
  Ships(const Columns& ships, const model::AircraftColumns& aircraft,
        std::shared_ptr<const model::Library> library, std::uint32_t boats)
      : ships_(ships), aircraft_(aircraft), library_(std::move(library)), boats_(boats) {}
  std::string_view name() const override { return "ship"; }
  TableId table() const override { return ships_.table; }

  void perceive(sim::World& world, const sim::StepInfo&, sim::Chunk chunk,
                sim::Outbox&) const override {
    const auto others = std::as_const(world).rows(aircraft_.kinematics);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const model::Kinematics& own = std::as_const(world).rows(ships_.kinematics)[i];
      Horizon nearest;
      for (std::size_t k = 0; k < others.size(); ++k) {
        const Vec3 sight = others[k].position - own.position;
        if (norm(sight) < std::min(nearest.range, 30e3))
          nearest = {norm(sight), math::atan2(dot(own.east, sight), dot(own.north, sight)),
                     world.ids(aircraft_.table)[k]};
      }
      world.rows(ships_.horizon)[i] = nearest;
    }
  }
  void move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
            sim::Outbox&) const override {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      model::vehicle::drive(
          hull(), library_->reference,
          library_->flights[std::as_const(world).rows(ships_.fit)[i].flight].routes,
          std::as_const(world).rows(ships_.command)[i], info.dt, world.rows(ships_.kinematics)[i],
          world.rows(ships_.helm)[i]);
  }
  void commit(sim::World&, const sim::StepInfo& info, std::span<const sim::Event>,
              sim::CommitContext& context) const override {
    for (std::uint32_t i = 0; info.step == 50 && i < boats_; ++i)
      (void)context.spawn(ships_.table);
  }

 private:
  Columns ships_;
  model::AircraftColumns aircraft_;
  std::shared_ptr<const model::Library> library_;
  std::uint32_t boats_;
};

// what a file says of them

struct GroupSpec {
  static constexpr std::string_view type_name = "task_group", help = "ships that sail together";
  static constexpr auto params() {
    return std::tuple{param("players", &GroupSpec::players, "names, by rank").required(),
                      param("tree", &GroupSpec::tree, "the tree that they sail by").required(),
                      param("start", &GroupSpec::start, "where it begins").required(),
                      param("heading", &GroupSpec::heading, "rad", any(), "true"),
                      param("boats", &GroupSpec::boats, range(0, 9), "that it lowers after 1 s"),
                      param("route", &GroupSpec::route, "the points of its way")};
  }
  std::vector<std::string> players;
  std::string tree;
  scenario::PlaceSpec start;
  double heading = 0;
  std::uint32_t boats = 0;
  std::vector<scenario::PlaceSpec> route;
};

class Kind final : public scenario::AgentKind<Platform> {
 public:
  Kind() : AgentKind(registry()) {}
  scenario::FilePart group() const override { return group_of<GroupSpec>(); }
  std::string_view key() const override { return "task_groups"; }
  void read(const Value::Entry& group, model::Side side, Diagnostics& diagnostics) override {
    Group read{group.key, side, group.where, {}, true};
    read.sound = bind(read.spec, group.value, diagnostics);
    used_.insert(read.spec.tree);
    names_.insert(read.spec.players.begin(), read.spec.players.end());
    groups_.push_back(std::move(read));
  }
  void enter(scenario::Scenario& scenario, model::Library& library, std::uint8_t fleet,
             Diagnostics& diagnostics) override {
    for (const Group& group : groups_) {
      const auto place = [&](const scenario::PlaceSpec& spec) {
        return group.sound ? scenario::resolve(spec, 0, library.reference, group.where, diagnostics)
                           : Vec3{};
      };
      model::Flight flight{.name = group.name, .side = group.side};
      model::Route route{.name = "mission", .waypoints = {}, .end = model::RouteEnd::stop};
      for (const scenario::PlaceSpec& point : group.spec.route)
        route.waypoints.push_back({place(point), 0, {}});
      flight.routes.push_back(std::move(route));
      std::vector<scenario::Roster::Player> members;
      for (const std::string& name : group.spec.players) {
        members.push_back({.name = name, .type = "ship", .label = "Ship"});
        members.back().rank = static_cast<std::uint16_t>(members.size());
        starts_.push_back(
            {place(group.spec.start) + Vec3{-500.0 * double(members.size() - 1), 0, 0},
             group.spec.heading, group.spec.tree});
      }
      enter_group(scenario, library, fleet, std::move(flight), members);
    }
  }
  void add_systems(sim::SimulationBuilder& builder, const scenario::Scenario& scenario, double dt,
                   std::uint32_t period) override {
    std::uint32_t boats = 0;
    for (const Group& group : groups_)
      boats += group.spec.boats;
    builder.add<Ships>(columns_, scenario.aircraft, scenario.library, boats);
    add_agents(builder, scenario, dt, period);
  }
  void populate(const scenario::Scenario& scenario, sim::World& world) const override {
    for (const Start& start : starts_) {
      const auto born = world.spawn(columns_.table);
      const auto& player = *scenario.roster.find(born.value().id);
      columns_.set_defaults(world, born->row);
      world.rows(columns_.kinematics)[born->row] =
          model::vehicle::parked(scenario.library->reference, start.place, start.heading, 5);
      world.rows(columns_.fit)[born->row] = {.flight = player.flight,
                                             .rank = static_cast<std::uint8_t>(player.rank),
                                             .side = player.side};
      world.rows(columns_.command)[born->row] = {.heading = start.heading, .speed = 5};
      world.rows(brains_.agent)[born->row] = {.tree = trees_->find(start.tree).value()};
    }
  }
  std::shared_ptr<const scenario::Fleet> fleet() const override {
    return fleet_of<scenario::Fleet>(scenario::Fleet::Words{.name = "ship",
                                                            .plural = "ships",
                                                            .group = "task group",
                                                            .there = "at sea",
                                                            .acmi = "Sea+Watercraft"});
  }

 private:
  struct Group {
    std::string name;
    model::Side side;
    Location where;
    GroupSpec spec;
    bool sound;
  };
  struct Start {
    Vec3 place;
    double heading;
    std::string tree;
  };
  static Registry registry() {
    Registry registry;
    ubf::add_standard_nodes(registry);
    registry.add<Navigate>();
    registry.add<TurnAway>();
    return registry;
  }
  std::vector<Group> groups_;
  std::vector<Start> starts_;
};

}  // namespace ship

EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) {
  registrar.add_kind([] { return std::make_unique<ship::Kind>(); });
})
