// SPDX-License-Identifier: MIT
#include "campaign/query.hpp"

#include <algorithm>

#include "core/angle.hpp"
#include "core/math.hpp"
#include "record/names.hpp"

namespace eyrie::campaign {
namespace {

using ubf::StateFieldInfo;

struct OfPlayer {
  StateFieldInfo own, whom;
};
/// What a player shows at the time, in the order in which Query::field reads it.
constexpr std::array kOfPlayer = [] {
  const auto one = [](std::string_view own, std::string_view whom, Unit unit) {
    return OfPlayer{{.name = own, .unit = unit, .help = {}},
                    {.name = whom, .unit = unit, .help = {}}};
  };
  return std::array{one("altitude", "whom.altitude", "m"),
                    one("speed", "whom.speed", "m/s"),
                    one("mach", "whom.mach", {}),
                    one("fuel", "whom.fuel", "kg"),
                    one("missile_range", "whom.missile_range", "m"),
                    one("enemy_range", "whom.enemy_range", "m")};
}();

model::EventKind kind_named(std::string_view name) {
  const auto found = std::ranges::find(model::event_infos(), name, &model::EventInfo::name);
  return found == model::event_infos().end() ? model::EventKind::none : found->kind;
}

/// The values of a kind of event that are numbers, or words with a number of their own.
std::vector<std::uint8_t> own_values(model::EventKind kind) {
  const std::span<const model::EventValue> values = model::event_values(kind);
  std::vector<std::uint8_t> own;
  for (std::uint8_t i = 0; i < values.size(); ++i)
    if (!values[i].is_name())
      own.push_back(i);
  return own;
}

/// Its own values, the time, who's, whom's.
std::vector<StateFieldInfo> fields_of(const MeasureSpec& spec) {
  std::vector<StateFieldInfo> fields;
  if (spec.what == What::decision)
    fields.push_back({.name = "vote", .unit = {}, .help = {}});
  const model::EventKind kind = kind_named(spec.event);
  for (const std::uint8_t i : own_values(kind)) {
    const model::EventValue& value = model::event_values(kind)[i];
    fields.push_back({.name = value.name, .unit = value.unit, .help = {}});
  }
  fields.push_back({.name = "time", .unit = "s", .help = {}});
  for (const OfPlayer& of : kOfPlayer)
    fields.push_back(of.own);
  if (spec.what == What::event)
    for (const OfPlayer& of : kOfPlayer)
      fields.push_back(of.whom);
  return fields;
}

/// Which field is taken; the number of fields if there is no such.
std::size_t value_of(const MeasureSpec& spec, std::span<const StateFieldInfo> fields) {
  const std::string_view name = spec.value.empty() ? "time" : std::string_view(spec.value);
  const auto found = std::ranges::find(fields, name, &StateFieldInfo::name);
  return static_cast<std::size_t>(found - fields.begin());
}

ubf::FieldNames naming(const MeasureSpec& spec) {
  const bool of_event = spec.what == What::event;
  return {"a value", fmt::format("{} has no value", of_event ? spec.event : "a decision")};
}

std::optional<std::vector<ubf::detail::Instruction>> condition_of(
    const MeasureSpec& spec, std::span<const StateFieldInfo> fields, Diagnostics& diagnostics) {
  const Value* const text = spec.text.find("if");
  ubf::FieldNames names = naming(spec);
  return text && text->is_scalar() ? ubf::parse_expression(*text, fields, names, diagnostics)
                                   : std::optional(std::vector<ubf::detail::Instruction>());
}

/// How far the nearest of some is, of which `counts`; NaN if none does.
template <class Column, class Counts>
void nearest(const sim::World& world, Column column, const Vec3& from, Counts counts,
             double& range) {
  const auto motions = world.rows(column);
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (counts(i))
      range = std::fmin(range, norm(motions[i].position - from));
}

double of_player(const scenario::Scenario& s, const sim::World& world, PlayerId who,
                 std::size_t field) {
  const auto found = s.find(world, who);
  if (!found)
    return math::kNaN;
  const model::Kinematics& k = found->fleet.motion(world, found->row);
  double range = math::kNaN;
  switch (field) {
    case 0:
      return k.altitude;
    case 1:
      return k.speed;
    case 2:
      return k.mach;
    case 3:
      return found->fleet.gauges(world, found->row).fuel.value_or(math::kNaN);
    case 4: {
      const auto missiles = world.rows(s.missiles.state);
      nearest(
          world, s.missiles.kinematics, k.position,
          [&](std::size_t i) { return missiles[i].intended == who || missiles[i].seen == who; },
          range);
      return range;
    }
    default:
      for (const auto& fleet : s.fleets)
        if (fleet->agents)
          nearest(
              world, fleet->kinematics, k.position,
              [&](std::size_t i) {
                return s.roster.find(fleet->id(world, i))->side != s.roster.find(who)->side;
              },
              range);
      return range;
  }
}

constexpr std::size_t kWaysToMove = 15;
std::size_t way_to_move(const model::Kinematics& k) {
  const auto beyond = [](double x, std::initializer_list<double> limits) {
    return static_cast<std::size_t>(
        std::ranges::count_if(limits, [&](double limit) { return x > limit; }));
  };
  return 3 * beyond(k.roll, {-radians(45), -radians(10), radians(10), radians(45)}) +
         beyond(k.pitch, {-radians(5), radians(5)});
}

}  // namespace

Players players_named(const scenario::Scenario& scenario, const MeasureSpec& spec,
                      std::string_view key, const std::string& name, Diagnostics& diagnostics) {
  const scenario::Roster& roster = scenario.roster;
  Players meant;
  for (const auto& player : roster.players)
    meant.push_back(name.empty() || player.name == name ||
                    roster.flights[player.flight].name == name ||
                    scenario::side_name(player.side) == name);
  if (std::ranges::find(meant, true) == meant.end())
    diagnostics.error(spec.text.where_of(key), "{}: there is no side, flight or player {}{}",
                      spec.name, quote(name), nearest_or_all(name, roster.names()));
  return meant;
}

Players enemies_of(const scenario::Scenario& scenario, const Players& who) {
  const auto& players = scenario.roster.players;
  Players enemies(who.size(), true);
  for (std::size_t i = 0; i < who.size(); ++i)
    for (std::size_t j = 0; who[i] && j < who.size(); ++j)
      if (players[j].side == players[i].side)
        enemies[j] = false;
  return enemies;
}

void Flight::observe(std::span<const sim::Event> events) {
  for (const sim::Event& e : events)
    if (record::kind_of(e) == model::EventKind::launch) {
      const std::size_t i = e.who.value - scenario.roster.players.size() - 1;
      shooters_.resize(std::max(shooters_.size(), i + 1));
      shooters_[i] = PlayerId{e.detail};
    }
}

PlayerId Flight::player(PlayerId id) const {
  const std::size_t players = scenario.roster.players.size();
  if (id.value <= players)
    return id;
  const std::size_t i = id.value - players - 1;
  return i < shooters_.size() ? shooters_[i] : PlayerId{};
}

void Query::check(const MeasureSpec& spec, Diagnostics& diagnostics) {
  if (spec.what == What::event && kind_named(spec.event) == model::EventKind::none) {
    const std::string hint =
        did_you_mean(spec.event, listed(model::event_infos(), &model::EventInfo::name));
    diagnostics.error(spec.text.where_of("event"), "{}: there is no event {}{}", spec.name,
                      quote(spec.event),
                      hint.empty() ? "; 'eyrie catalog --events' tells which there are" : hint);
    return;
  }
  const std::vector<StateFieldInfo> fields = fields_of(spec);
  static_cast<void>(condition_of(spec, fields, diagnostics));
  if (value_of(spec, fields) == fields.size())
    diagnostics.error(spec.text.where_of("value"), "{}: {}", spec.name,
                      naming(spec).unknown(fields, spec.value));
  const Value* const take = spec.text.find("take");
  const bool takes_value = spec.take != Take::any && spec.take != Take::count;
  const bool is_read = !take || take->text == enum_name(spec.take);
  if (!spec.value.empty() && !takes_value && is_read)
    diagnostics.error(spec.text.where_of("value"), "{}: '{}' takes no value", spec.name,
                      enum_name(spec.take));
}

std::string_view Query::unit(const MeasureSpec& spec) {
  const std::vector<StateFieldInfo> fields = fields_of(spec);
  const std::size_t value = value_of(spec, fields);
  const bool plain = spec.take == Take::any || spec.take == Take::count;
  return plain || value == fields.size() ? "" : fields[value].unit.si_symbol;
}

Variety::Variety(const Flight& flight, Players who, bool of_motion)
    : scenario_(flight.scenario),
      who_(std::move(who)),
      decisions_(flight.scenario),
      of_motion_(of_motion) {
  std::vector<std::string_view> names;
  for (const auto& fleet : scenario_.fleets)
    for (auto& of_fleet = types_.emplace_back(); const ubf::AnyTree* tree : fleet->trees)
      for (auto& of_tree = of_fleet.emplace_back(); of_tree.size() < tree->size();) {
        const std::string_view type =
            tree->node(static_cast<ubf::NodeIndex>(of_tree.size())).type();
        const auto known = std::ranges::find(names, type);
        of_tree.push_back(static_cast<std::size_t>(known - names.begin()));
        if (known == names.end())
          names.push_back(type);
      }
  counts_.resize(of_motion ? kWaysToMove : names.size());
}

void Variety::observe(const sim::World& world) {
  decisions_.each(world, who_, [&](PlayerId id, std::size_t fleet, const auto& led) {
    if (of_motion_) {
      const auto found = scenario_.find(world, id);
      ++counts_[way_to_move(found->fleet.motion(world, found->row))];
    } else if (led.tree < types_[fleet].size() && led.node < types_[fleet][led.tree].size()) {
      ++counts_[types_[fleet][led.tree][led.node]];
    }
  });
}

double Variety::value() const {
  double all = 0, bits = 0;
  for (const std::uint64_t count : counts_)
    all += static_cast<double>(count);
  for (const std::uint64_t count : counts_)
    if (count > 0)
      bits -= static_cast<double>(count) / all * math::log2(static_cast<double>(count) / all);
  return all > 0 ? std::max(bits, 0.0) : math::kNaN;
}

Query::Query(const MeasureSpec& spec, const Flight& flight, Diagnostics& diagnostics)
    : spec_(spec),
      flight_(flight),
      who_(players_named(flight.scenario, spec, "who", spec.who, diagnostics)),
      whom_(players_named(flight.scenario, spec, "whom", spec.whom, diagnostics)),
      kind_(kind_named(spec.event)),
      own_values_(spec.what == What::decision ? std::vector<std::uint8_t>{0} : own_values(kind_)),
      decisions_(flight.scenario) {
  const std::vector<StateFieldInfo> fields = fields_of(spec);
  condition_ = *condition_of(spec, fields, diagnostics);
  value_ = value_of(spec, fields);
  if (spec.what == What::event)
    return;
  bool known = false;
  std::vector<std::string> labels;
  for (const auto& fleet : flight.scenario.fleets)
    for (auto& of_fleet = nodes_.emplace_back(); const ubf::AnyTree* tree : fleet->trees) {
      Players& has = of_fleet.emplace_back();
      for (std::size_t n = 0; n < tree->size(); ++n) {
        const ubf::AnyNode& node = tree->node(static_cast<ubf::NodeIndex>(n));
        labels.emplace_back(node.label());
        has.push_back(node.label() == spec.node || node.type() == spec.node);
        known |= has.back();
      }
    }
  if (!known)
    diagnostics.error(spec.text.where_of("node"), "{}: no tree has a node {}{}", spec.name,
                      quote(spec.node), nearest_or_all(spec.node, labels));
}

double Query::field(const Case& c, std::size_t index) const {
  if (index < own_values_.size()) {
    const std::uint8_t own = own_values_[index];
    const auto value = static_cast<double>(c.values[own]);
    const auto about = model::event_values(kind_);
    const bool is_angle = own < about.size() && about[own].unit.dimension == Dimension::angle;
    return is_angle ? wrap_tau(value) : value;  // as in tables of events
  }
  if (index == own_values_.size())
    return c.time;
  const std::size_t of = index - own_values_.size() - 1;
  return of_player(flight_.scenario, c.world, of < kOfPlayer.size() ? c.who : c.whom,
                   of % kOfPlayer.size());
}

void Query::observe(const sim::World& world, const sim::StepInfo& info,
                    std::span<const sim::Event> events) {
  const double time = spec_.what == What::decision ? info.time() : info.time_after();
  if (spec_.what == What::decision)
    return decisions_.each(world, who_, [&](PlayerId who, std::size_t fleet, const auto& led) {
      const auto& nodes = nodes_[fleet];
      if (led.tree < nodes.size() && led.node < nodes[led.tree].size() && nodes[led.tree][led.node])
        take({world, time, who, {}, std::span(&led.vote, 1)});
    });
  const auto meant = [](const Players& players, PlayerId id) {
    return id && id.value <= players.size() && players[id.value - 1];
  };
  for (const sim::Event& e : events) {
    if (record::kind_of(e) != kind_)
      continue;
    const PlayerId who = flight_.player(e.who), whom = flight_.player(e.whom);
    if (meant(who_, who) && (spec_.whom.empty() || meant(whom_, whom)))
      take({world, time, who, whom, e.values});
  }
}

void Query::take(const Case& c) {
  if (!condition_.empty() &&
      !ubf::detail::run(condition_, [&](std::uint32_t i) { return field(c, i); }))
    return;
  if (spec_.take == Take::any || spec_.take == Take::count ||
      (spec_.take == Take::first && count_ > 0)) {
    ++count_;
    return;
  }
  const double value = field(c, value_);
  // of the first or last event, also where that has none: another one's would be taken for it
  if (std::isnan(value) && spec_.take != Take::first && spec_.take != Take::last)
    return;
  const bool is_first = count_++ == 0;
  switch (spec_.take) {
    case Take::sum:
      result_ += value;
      break;
    case Take::least:
      result_ = is_first ? value : std::min(result_, value);
      break;
    case Take::most:
      result_ = is_first ? value : std::max(result_, value);
      break;
    default:
      result_ = value;
  }
}

double Query::value() const {
  if (spec_.take == Take::any)
    return count_ > 0;
  if (spec_.take == Take::count)
    return count_;
  return count_ > 0 || spec_.take == Take::sum ? result_ : math::kNaN;
}

}  // namespace eyrie::campaign
