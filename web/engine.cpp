// SPDX-License-Identifier: MIT
#include "web/engine.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/version.hpp"
#include "debrief/node_sets.hpp"
#include "debrief/what_if.hpp"
#include "model/weapon/kept_zones.hpp"
#include "page/page_data.hpp"
#include "record/run_file.hpp"
#include "record/tally.hpp"
#include "scenario/plugins.hpp"
#include "sim/trail.hpp"

namespace eyrie::web {
namespace {

constexpr double kBetweenKept = 5;     // s
constexpr std::uint64_t kTell = 1024;  // steps

std::string hex(std::uint64_t hash) {
  return fmt::format("{:#018x}", hash);
}

std::string build() {
  return fmt::format("eyrie {}", kVersion);
}

std::shared_ptr<const scenario::Scenario> loaded(const Texts& texts) {
  return scenario::load({texts.scenario, texts.sets.value_or(std::vector<std::string>{})},
                        scenario::Source::bundle(texts.files));
}

Parameter parameter(const ParamInfo& info) {
  Parameter out{.name = info.name,
                .kind = "other",
                .unit = std::string(info.unit.si_symbol),
                .help = info.help,
                .standard = info.default_text,
                .min = {},
                .max = {},
                .choices = info.choices};
  if (info.kind == ParamKind::number || info.kind == ParamKind::integer)
    out.kind = "number";
  else if (info.kind == ParamKind::boolean)
    out.kind = "flag";
  else if (info.kind == ParamKind::choice)
    out.kind = "choice";
  if (std::isfinite(info.limits.min))
    out.min = info.limits.min;
  if (std::isfinite(info.limits.max))
    out.max = info.limits.max;
  return out;
}

double number(const std::byte* at, Scalar type) {
  const auto read = [at]<class T>(T value) {
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
  };
  switch (type) {
    case Scalar::f64:
      return read(double{});
    case Scalar::f32:
      return read(float{});
    case Scalar::u16:
      return read(std::uint16_t{});
    case Scalar::u32:
      return read(std::uint32_t{});
    case Scalar::u64:
      return read(std::uint64_t{});
    case Scalar::i8:
      return read(std::int8_t{});
    case Scalar::i16:
      return read(std::int16_t{});
    case Scalar::i32:
      return read(std::int32_t{});
    case Scalar::i64:
      return read(std::int64_t{});
    case Scalar::u8:
    case Scalar::bytes:
      break;
  }
  return read(std::uint8_t{});
}

}  // namespace

/// A mission with those who watch it.
struct Engine::Flight {
  Flight(const std::shared_ptr<const scenario::Scenario>& scenario, std::uint64_t with_seed,
         std::optional<double> until)
      : mission(scenario, with_seed, until),
        seed(with_seed),
        tally(*scenario),
        story(*scenario, [this](const record::StoryLine& line) {
          lines.push_back({line.time, line.who, line.text});
        }) {
    mission.run().attach(trail);
    mission.run().attach(tally);
    mission.run().attach(story);
  }

  scenario::Mission mission;
  std::uint64_t seed;
  sim::TrailRecorder trail;
  record::Tally tally;
  std::vector<Line> lines;
  record::Story story;
};

void Engine::FlightDeleter::operator()(Flight* flight) const {
  delete flight;
}

void Engine::take_zones(std::string_view file) {
  model::weapon::kept_zones().take(file);
}

NodeTypes Engine::node_types() {
  const scenario::Plugins plugins;
  const auto types = [](std::span<const ubf::NodeInfo> infos) {
    std::vector<NodeType> all;
    for (const ubf::NodeInfo& info : infos) {
      NodeType type{info.name,
                    std::string(to_text(info.kind)),
                    info.help,
                    std::find(info.child_keys.begin(), info.child_keys.end(), "children") !=
                        info.child_keys.end(),
                    {}};
      for (const ParamInfo& one : info.parameters)
        type.parameters.push_back(parameter(one));
      all.push_back(std::move(type));
    }
    return all;
  };
  return {types(plugins.registries().pilots.catalog()),
          types(plugins.registries().drivers.catalog())};
}

Problems Engine::validate(const Texts& texts) {
  Problems result;
  try {
    static_cast<void>(loaded(texts));
  } catch (const ConfigError& e) {
    for (const Diagnostic& one : e.diagnostics().sorted())
      result.problems.push_back(
          {std::string(one.where.file.text()), one.where.line, one.where.column, one.message});
  }
  return result;
}

About Engine::load(const Load& load) {
  auto scenario = loaded(load.texts);
  std::uint64_t seed = scenario->spec.seed;
  if (load.seed) {
    const std::string& text = *load.seed;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (failed != std::errc{} || end != text.data() + text.size())
      throw BadRequest("seed: expected digits of a number below 2^64");
  }
  if (load.until)
    if (const auto problem = scenario::until_problem(scenario->spec, *load.until))
      throw BadRequest("until: " + *problem);
  recorded_.reset();
  kept_.clear();
  here_.reset();
  flight_.reset(new Flight(scenario, seed, load.until));
  return about(*scenario, seed, "", flight_->mission.until());
}

About Engine::about(const scenario::Scenario& scenario, std::uint64_t seed, std::string build,
                    double until) const {
  About about{scenario.spec.name,
              scenario.spec.help_text,
              std::to_string(seed),
              std::move(build),
              scenario.simulation->dt(),
              until,
              {},
              {}};
  for (const auto& player : scenario.roster.players)
    about.players.push_back(
        {player.name, std::string(scenario::side_name(player.side)), player.label});
  for (const sim::TableInfo& table : scenario.simulation->schema().tables())
    about.tables.push_back(table.name);
  return about;
}

Flown Engine::fly(const Until& until) {
  if (!flight_)
    throw BadRequest("nothing was loaded that could be flown");
  scenario::Mission& mission = flight_->mission;
  bool over = false;
  while (!over && (!until.until || mission.run().time() < *until.until)) {
    over = !mission.step();
    if (progress_ && mission.run().world().step() % kTell == 0)
      progress_(mission.run().time());
  }
  Flown flown{mission.run().world().step(),
              mission.run().time(),
              hex(mission.run().world().hash()),
              std::string(scenario::outcome_name(mission.outcome())),
              {},
              std::exchange(flight_->lines, {})};
  if (!over)
    return flown;
  mission.run().finish();
  flown.result = debrief::outcome_of(mission, flight_->tally);
  for (Line& line : flight_->lines)
    flown.story.push_back(std::move(line));
  record::RunFile run = record::run_file_of(mission.scenario(), flight_->seed, build());
  run.trail = flight_->trail.trail();
  const auto orders = mission.run().orders();
  run.orders.assign(orders.begin(), orders.end());
  run.outcome = flown.outcome;
  flight_.reset();
  open(record::encode(run));
  return flown;
}

std::string Engine::run_file() const {
  return record::encode(run().run);
}

About Engine::open(std::string_view run_file) {
  record::Decoded decoded = record::decode(run_file);
  if (!decoded.error.empty())
    throw BadRequest(decoded.error);
  if (!decoded.run.plugins.empty())
    throw BadRequest("the run needs plug-ins, which a page cannot open");
  debrief::Opened opened = debrief::open(std::move(decoded.run), "run.eyrie", {}, build());
  if (!opened.recorded)
    throw std::runtime_error(opened.problems.front());
  flight_.reset();
  recorded_ = std::move(opened.recorded);
  kept_.clear();
  here_ = recorded_->scenario->world(recorded_->run.seed);
  return about(*recorded_->scenario, recorded_->run.seed, recorded_->run.build, recorded_->until());
}

const debrief::Recorded& Engine::run() const {
  if (!recorded_)
    throw BadRequest("there is no run: open one, or fly to the end");
  return *recorded_;
}

void Engine::keep(const sim::World& world) {
  const double since = kept_.empty() ? kBetweenKept
                                     : static_cast<double>(world.step() - kept_.back().step()) *
                                           run().scenario->simulation->dt();
  if (since >= kBetweenKept)
    kept_.push_back(world);
}

std::string Engine::page() {
  kept_.clear();
  return page::page_bytes(run(), [this](const debrief::Reflight& flight) {
    keep(flight.after());
    if (progress_)
      progress_(flight.time());
    return true;
  });
}

Moment Engine::seek(const Step& step) {
  const debrief::Recorded& recorded = run();
  if (step.step > recorded.last_step())
    throw BadRequest(fmt::format("step: the run ends at {}", recorded.last_step()));
  const sim::World* from = here_->step() <= step.step ? &*here_ : nullptr;
  const auto later = std::upper_bound(
      kept_.begin(), kept_.end(), step.step,
      [](std::uint64_t wanted, const sim::World& world) { return wanted < world.step(); });
  if (later != kept_.begin() && (!from || (later - 1)->step() > from->step()))
    from = &*(later - 1);
  sim::World start = from ? *from : recorded.scenario->world(recorded.run.seed);
  sim::Run run(recorded.scenario->simulation, std::move(start));
  for (const sim::Order& order : recorded.run.orders)
    if (order.step >= run.world().step())
      static_cast<void>(run.submit(order));
  while (run.world().step() < step.step && !run.fault())
    run.step();
  here_ = run.world();
  return {here_->step(), run.time(), hex(here_->hash())};
}

Engine::Around Engine::around() const {
  const debrief::Recorded& recorded = run();
  Around around{*here_, *here_, {}};
  sim::Run run(recorded.scenario->simulation, *here_);
  for (const sim::Order& order : recorded.run.orders)
    if (order.step == here_->step()) {
      around.orders.push_back(order);
      static_cast<void>(run.submit(order));
    }
  run.step();
  around.after = run.world();
  return around;
}

Rows Engine::rows(const Table& wanted) const {
  const sim::Schema& schema = run().scenario->simulation->schema();
  const TableId table = schema.find_table(wanted.table);
  if (!table) {
    std::vector<std::string> names;
    for (const sim::TableInfo& one : schema.tables())
      names.push_back(one.name);
    throw BadRequest("there is no table " + quote(wanted.table) +
                     did_you_mean(wanted.table, names));
  }
  Rows rows;
  for (const PlayerId id : here_->ids(table))
    rows.ids.push_back(id.value);
  for (const std::uint32_t index : schema.table(table).columns) {
    const sim::ColumnInfo& column = schema.column(index);
    const std::byte* bytes = here_->column_bytes(index).data();
    for (const FieldInfo& field : column.fields)
      for (std::uint32_t i = 0; i < field.count; ++i) {
        Column& out = rows.columns.emplace_back();
        out.name = fmt::format("{}.{}", column.name, std::string_view(field.name));
        if (field.count > 1)
          out.name += fmt::format("[{}]", i);
        out.unit = field.unit;
        for (std::size_t row = 0; row < rows.ids.size(); ++row)
          out.values.push_back(
              number(bytes + row * column.stride + field.offset + i * scalar_size(field.type),
                     field.type));
      }
  }
  return rows;
}

PlayerId Engine::player(const std::string& name) const {
  const scenario::Roster& roster = run().scenario->roster;
  const auto found = roster.find(name);
  if (!found) {
    std::vector<std::string> names;
    for (const auto& one : roster.players)
      names.push_back(one.name);
    throw BadRequest("there is no player " + quote(name) + did_you_mean(name, names));
  }
  return *found;
}

std::shared_ptr<const scenario::Scenario> Engine::other(
    const std::string& name, const std::vector<std::string>& sets) const {
  Diagnostics wrong;
  auto overrides = debrief::read_overrides(*run().scenario, player(name), sets, wrong);
  if (!wrong.ok())
    throw ConfigError(wrong);
  return debrief::with_overrides(run(), overrides.sets, std::move(overrides.changes));
}

Decided Engine::explain(const Who& who) {
  const PlayerId id = player(who.player);
  const Around at = around();
  return {debrief::Explainer(*run().scenario).explain(at.before, at.after, id, at.orders)};
}

Decided Engine::decide(const Otherwise& otherwise) {
  const PlayerId id = player(otherwise.player);
  const auto changed = other(otherwise.player, otherwise.sets);
  const Around at = around();
  return {
      debrief::Explainer(*run().scenario, *changed).explain(at.before, at.after, id, at.orders)};
}

debrief::WhatIf Engine::what_if(const Otherwise& otherwise) const {
  return debrief::what_if(run(), *other(otherwise.player, otherwise.sets), player(otherwise.player),
                          otherwise.from.value_or(0));
}

debrief::Outcome Engine::branch(const Branch& branch) const {
  std::string problem;
  const auto outcome = debrief::branch(run(), other(branch.player, branch.sets), here_->step(),
                                       branch.until, problem);
  if (!outcome)
    throw BadRequest(problem);
  return *outcome;
}

}  // namespace eyrie::web
