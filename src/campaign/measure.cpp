// SPDX-License-Identifier: MIT
#include "campaign/measure.hpp"

#include <algorithm>
#include <cmath>

#include "campaign/query.hpp"
#include "core/bind.hpp"
#include "core/math.hpp"
#include "core/text.hpp"
#include "record/story.hpp"

namespace eyrie::campaign {
namespace {

/// What a measure may say besides `what`, and what it must; the SI unit of its column; and what is
/// estimated from that.
struct About {
  std::string_view may, must = "", unit = "";
  Measure::Kind kind = Measure::mean;
};
constexpr About kAbout[] = {{" is ", "is", "", Measure::share},  // in the order of What
                            {"", "", "s"},
                            {" who "},
                            {" who "},
                            {" who "},
                            {" who ", "", "", Measure::ratio},
                            {" who ", "who", "", Measure::ratio},
                            {" who phase ", "phase", "s"},
                            {" who ", "", "kg"},
                            {" who ", "", "bit"},
                            {" who ", "", "bit"},
                            {" if ", "if", "", Measure::share},
                            {" who whom event if take value ", "event"},
                            {" who node if take value ", "node"}};
static_assert(std::size(kAbout) == enum_names<What>().size());

const About& about(const MeasureSpec& spec) {
  return kAbout[static_cast<std::size_t>(spec.what)];
}
bool is_query(const MeasureSpec& spec) {
  return spec.what == What::event || spec.what == What::decision;
}

void check(const MeasureSpec& spec, Diagnostics& diagnostics) {
  const auto& [may, must, unit, kind] = about(spec);
  for (const Value::Entry& e : spec.text.entries)
    if (e.key != "what" && may.find(fmt::format(" {} ", e.key)) == may.npos)
      diagnostics.error(e.where, "{}: '{}' says nothing of {}", spec.name, e.key,
                        enum_name(spec.what));
  if (std::ranges::find(spec.is, scenario::Outcome::running) != spec.is.end())
    diagnostics.error(spec.text.where_of("is"), "{}: no flight ends 'running'", spec.name);
  if (std::ranges::find(spec.is, scenario::Outcome::fault) != spec.is.end())
    diagnostics.error(spec.text.where_of("is"),
                      "{}: what ends with a fault is in no measure; the report and the table "
                      "`faults` count it",
                      spec.name);
  if (!must.empty() && !spec.text.find(must))
    diagnostics.error(spec.text.where, "{}: {} needs '{}'", spec.name, enum_name(spec.what), must);
  else if (is_query(spec))
    Query::check(spec, diagnostics);
}

/// A condition of which the fields are columns.
std::vector<ubf::detail::Instruction> condition_over(const std::vector<Column>& columns,
                                                     const Value& text, Diagnostics& diagnostics) {
  std::vector<ubf::StateFieldInfo> fields;
  for (const Column& column : columns) {
    const std::size_t unit = detail::unit_index(column.unit);
    fields.push_back(
        {.name = column.name,
         .unit = unit < detail::kUnits.size() ? Unit(detail::kUnits[unit].dimension) : Unit(),
         .help = {}});
  }
  ubf::FieldNames names("a measure", "there is no measure");
  Diagnostics wrong;
  const auto condition = ubf::parse_expression(text, fields, names, wrong);
  for (auto& [where, message] : wrong.sorted()) {
    for (const Column& column : columns)
      if (const std::string name = column.name.substr(0, column.name.find(".sum"));
          name != column.name && message.starts_with("there is no measure " + quote(name)))
        message = fmt::format("{0} is a ratio of all flights; one has {0}.sum and {0}.per", name);
    diagnostics.error(where, message);
  }
  return condition.value_or(std::vector<ubf::detail::Instruction>());
}

class Watcher final : public Watch {
 public:
  Watcher(const Measures& measures, const scenario::Scenario& scenario)
      : measures_(measures), scenario_(scenario), tally_(scenario), flight_(scenario) {
    Diagnostics wrong;
    for (const MeasureSpec& spec : measures.specs) {
      who_.push_back(players_named(scenario, spec, "who", spec.who, wrong));
      fuel_ |= spec.what == What::fuel_left;
      queries_.emplace_back();
      varieties_.emplace_back();
      if (spec.what == What::variety || spec.what == What::motion_variety)
        varieties_.back().emplace(flight_, who_.back(), spec.what == What::motion_variety);
      if (is_query(spec))
        queries_.back().emplace(spec, flight_, wrong);
      if (spec.what == What::time_in_phase)
        check_phase(spec, wrong);
    }
    wrong.throw_if_any();
    fuels_.resize(scenario.roster.players.size(), math::kNaN);
  }

  void begin(const sim::World& world, double dt) override { tally_.begin(world, dt); }
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    tally_.observe(world, info, events);
    flight_.observe(events);
    for (auto& query : queries_)
      if (query)
        query->observe(world, info, events);
    for (auto& variety : varieties_)
      if (variety)
        variety->observe(world);
    if (fuel_)
      for (std::size_t row = 0; row < scenario_.fleets.front()->rows(world); ++row)
        fuels_[scenario_.fleets.front()->id(world, row).value - 1] =
            world.rows(scenario_.aircraft.propulsion)[row].fuel;
  }

  std::vector<double> values(scenario::Outcome outcome, double time) override {
    values_.resize(measures_.columns.size());
    for (std::size_t i = 0; i < measures_.specs.size(); ++i) {
      const Measure& measure = measures_.estimates[i];
      const auto [value, per] = value_of(i, outcome, time);
      values_[measure.column] = value;
      if (measure.kind == Measure::ratio)
        values_[measure.per] = per;
    }
    return values_;
  }

 private:
  std::pair<double, double> value_of(std::size_t i, scenario::Outcome outcome, double time) {
    using Player = record::Tally::OfPlayer;
    const MeasureSpec& spec = measures_.specs[i];
    const auto sum = [&](const Players& who, auto count) {
      double all = 0;
      for (std::size_t p = 0; p < who.size(); ++p)
        all += who[p] ? static_cast<double>(count(tally_.players()[p])) : 0;
      return all;
    };
    const auto lost = [](const Player& p) { return p.lost; };
    const auto kills = [](const Player& p) { return p.kills; };
    const auto shots = [](const Player& p) { return p.shots; };
    switch (spec.what) {
      case What::outcome:
        return {std::ranges::find(spec.is, outcome) != spec.is.end(), 0};
      case What::end_time:
        return {time, 0};
      case What::losses:
        return {sum(who_[i], lost), 0};
      case What::kills:
        return {sum(who_[i], kills), 0};
      case What::shots:
        return {sum(who_[i], shots), 0};
      case What::shots_per_kill:
        return {sum(who_[i], shots), sum(who_[i], kills)};
      case What::exchange_ratio:
        return {sum(enemies_of(scenario_, who_[i]), lost), sum(who_[i], lost)};
      case What::time_in_phase:
        return {time_in_phase(spec.phase, who_[i], time), 0};
      case What::fuel_left:
        return {fuel_left(who_[i]), 0};
      case What::holds:
        return {ubf::detail::run(measures_.conditions[i],
                                 [&](std::uint32_t column) { return values_[column]; }),
                0};
      case What::variety:
      case What::motion_variety:
        return {varieties_[i]->value(), 0};
      case What::event:
      case What::decision:
        break;
    }
    return {queries_[i]->value(), 0};
  }

  double time_in_phase(const std::string& phase, const Players& who, double end) const {
    double all = 0;
    const auto& flights = scenario_.roster.flights;
    for (std::uint16_t f = 0; f < flights.size(); ++f) {
      const auto& members = flights[f].members;
      if (std::ranges::none_of(members, [&](PlayerId m) { return who[m.value - 1]; }))
        continue;
      double left = 0;  // when its last member was gone
      for (const PlayerId m : members) {
        const auto& player = tally_.players()[m.value - 1];
        left = std::max(left, player.lost || player.home ? player.end_time : end);
      }
      std::optional<double> since;
      for (const auto& entered : tally_.phases()) {
        if (entered.flight != f)
          continue;
        if (since)
          all += entered.time - *since;
        since = entered.phase == phase ? std::optional(entered.time) : std::nullopt;
      }
      all += since ? left - *since : 0;
    }
    return all;
  }

  double fuel_left(const Players& who) const {
    double all = 0, count = 0;
    for (std::size_t p = 0; p < who.size(); ++p)
      if (who[p] && !tally_.players()[p].lost && !std::isnan(fuels_[p])) {
        all += fuels_[p];
        ++count;
      }
    return count > 0 ? all / count : math::kNaN;
  }

  void check_phase(const MeasureSpec& spec, Diagnostics& wrong) const {
    std::vector<std::string> names, inner;
    const auto note = [&](const ubf::AnyTree& tree) {
      auto* of = &names;  // the first sequencer of a tree is its outermost
      for (std::size_t n = 0; n < tree.size(); ++n)
        if (const auto& node = tree.node(static_cast<ubf::NodeIndex>(n)); node.is_sequencer()) {
          for (const auto& child : node.children())
            if (child->node_kind() != ubf::Kind::condition)  // but a transition's
              of->emplace_back(child->label());
          of = &inner;
        }
    };
    // those that somebody flies, or may be ordered to
    scenario_.each_player(
        *scenario_.start, [&](const scenario::Fleet& fleet, PlayerId, std::size_t row) {
          if (!fleet.agents)
            return;
          const std::size_t now = fleet.agents->last_decision(*scenario_.start, row).tree;
          for (std::size_t tree = 0; tree < fleet.trees.size(); ++tree)
            if (tree == now || !scenario_.orders.empty())
              note(*fleet.trees[tree]);
        });
    if (std::ranges::find(names, spec.phase) != names.end())
      return;
    if (std::ranges::find(inner, spec.phase) != inner.end())
      wrong.error(spec.text.where_of("phase"),
                  "{}: {} is a phase within another one; those of the outermost sequencer count",
                  spec.name, quote(spec.phase));
    else
      wrong.error(spec.text.where_of("phase"), "{}: there is no phase {}{}", spec.name,
                  quote(spec.phase), nearest_or_all(spec.phase, names));
  }

  const Measures& measures_;
  const scenario::Scenario& scenario_;
  record::Tally tally_;
  Flight flight_;
  std::vector<Players> who_;                       ///< by measure
  std::vector<std::optional<Query>> queries_;      ///< by measure
  std::vector<std::optional<Variety>> varieties_;  ///< by measure
  bool fuel_ = false;
  std::vector<double> fuels_, values_;
};

}  // namespace

Measures read_measures(const Value& map, Diagnostics& diagnostics) {
  Measures all;
  if (!map.is_map() || map.entries.empty()) {
    diagnostics.error(map.where, "measures: expected a map of measures, got " +
                                     (map.is_map() ? "none" : map.shown()));
    return all;
  }
  for (const Value::Entry& e : map.entries) {
    MeasureSpec spec{.name = e.key, .text = e.value};
    if (const auto problem = identifier_problem(e.key))
      diagnostics.error(e.where, *problem);
    else if (bind(spec, e.value, diagnostics))
      check(spec, diagnostics);
    else if (!spec.event.empty() || !spec.node.empty())
      Query::check(spec, diagnostics);  // what could be read is told in the same go
    auto& condition = all.conditions.emplace_back();
    if (const Value* const text = e.value.find("if"); text && spec.what == What::holds)
      condition = condition_over(all.columns, *text, diagnostics);
    const auto kind = is_query(spec) && spec.take == Take::any ? Measure::share : about(spec).kind;
    const auto unit = is_query(spec) ? Query::unit(spec) : about(spec).unit;
    Measure measure{e.key, kind, all.columns.size()};
    all.columns.push_back({kind == Measure::ratio ? e.key + ".sum" : e.key, std::string(unit)});
    if (kind == Measure::ratio) {
      measure.per = all.columns.size();
      all.columns.push_back({e.key + ".per", ""});
    }
    all.estimates.push_back(std::move(measure));
    all.specs.push_back(std::move(spec));
  }
  return all;
}

std::unique_ptr<Watch> watch(const Measures& measures, const scenario::Scenario& scenario) {
  return std::make_unique<Watcher>(measures, scenario);
}

void Estimator::add(std::span<const double> values) {
  if (values.empty() || !measure_->applies(values))
    return;
  const double value = values[measure_->column];
  if (measure_->kind == Measure::ratio)
    return ratio_.add(value, values[measure_->per]);
  numbers_.add(value);
  share_ = {share_.count + (value != 0), share_.n + 1};
}

Estimate Estimator::estimate(double confidence) const {
  const auto of = [](std::uint64_t n, std::optional<double> value, auto interval, double error) {
    return Estimate{n, n ? value : std::nullopt, interval,
                    value && n > 1 ? std::optional(error) : std::nullopt};
  };
  if (measure_->kind == Measure::ratio)
    return of(ratio_.n(), ratio_.value(), ratio_.fieller(confidence), ratio_.error());
  if (measure_->kind == Measure::mean)
    return of(numbers_.n(), numbers_.mean(), stats::t_interval(numbers_, confidence),
              numbers_.error());
  return of(share_.n, share_.value(), stats::wilson(share_, confidence), share_.error());
}

}  // namespace eyrie::campaign
