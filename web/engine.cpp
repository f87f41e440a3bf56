// SPDX-License-Identifier: MIT
#include "web/engine.hpp"

#include "core/hash.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "debrief/what_if.hpp"
#include "model/weapon/kept_zones.hpp"
#include "page/page.hpp"
#include "record/run_file.hpp"
#include "scenario/plugins.hpp"
#include "sim/trail.hpp"

namespace eyrie::web {
namespace {

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

}  // namespace

/// A mission with those who watch it.
struct Engine::Flight {
  Flight(const std::shared_ptr<const scenario::Scenario>& scenario, std::uint64_t with_seed)
      : mission(scenario, with_seed),
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

Nothing Engine::take_zones(std::string_view file) {
  model::weapon::kept_zones().take(file);
  return {};
}

NodeTypes Engine::node_types(const Nothing&) const {
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

Problems problems_of(const ConfigError& error) {
  Problems all;
  for (const Diagnostic& one : error.diagnostics().sorted())
    all.problems.push_back(
        {std::string(one.where.file.text()), one.where.line, one.where.column, one.message});
  return all;
}

Problems Engine::validate(const Texts& texts) const {
  try {
    static_cast<void>(loaded(texts));
    return {};
  } catch (const ConfigError& e) {
    return problems_of(e);
  }
}

About Engine::load(const Load& load) {
  auto scenario = loaded(load.texts);
  std::uint64_t seed = scenario->spec.seed;
  if (load.seed) {
    const auto given = number_from<std::uint64_t>(*load.seed);
    if (!given)
      throw BadRequest("seed: expected digits of a number below 2^64");
    seed = *given;
  }
  reflown_.reset();
  recorded_.reset();
  here_.reset();
  flight_ = std::make_shared<Flight>(scenario, seed);
  return about(*scenario, seed, flight_->mission.until());
}

About Engine::about(const scenario::Scenario& scenario, std::uint64_t seed, double until) const {
  const Geodetic& origin = scenario.library->reference.origin();
  About about{scenario.spec.name,       std::to_string(seed),      until,
              degrees(origin.latitude), degrees(origin.longitude), {}};
  for (const auto& player : scenario.roster.players)
    about.players.push_back({player.name, std::string(scenario::side_name(player.side))});
  return about;
}

scenario::Mission& Engine::mission() const {
  if (!flight_)
    throw BadRequest("nothing was loaded that could be flown");
  return flight_->mission;
}

Flown Engine::fly(const Until& until) {
  scenario::Mission& flown = mission();
  bool over = false;
  while (!over && (!until.until || flown.run().time() < *until.until)) {
    over = !flown.step();
    tell(flown.run().world(), flown.run().simulation().dt());
  }
  return flown_so_far(over);
}

Flown Engine::end_flight(const Nothing&) {
  mission().stop();
  return flown_so_far(true);
}

Flown Engine::flown_so_far(bool over) {
  scenario::Mission& mission = flight_->mission;
  Flown flown{mission.run().time(),
              hash_text(mission.run().world().hash()),
              {},
              {},
              std::exchange(flight_->lines, {})};
  if (!over)
    return flown;
  mission.run().finish();
  flown.result = debrief::outcome_of(mission, flight_->tally);
  if (const sim::Fault* fault = mission.run().fault())
    flown.fault =
        scenario::fault_text(*fault, mission.scenario().roster, mission.run().simulation().dt());
  for (Line& line : flight_->lines)
    flown.story.push_back(std::move(line));
  record::RunFile run = record::run_file_of(mission.scenario(), flight_->seed, build());
  run.trail = flight_->trail.trail();
  const auto orders = mission.run().orders();
  run.orders.assign(orders.begin(), orders.end());
  run.outcome = std::string(enum_name(mission.outcome()));
  flight_.reset();
  open(record::encode(run));
  return flown;
}

Nothing Engine::run_file(const Nothing&, std::string& bytes) {
  bytes = record::encode(run_with_trail().run);
  return {};
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
  reflown_.reset();
  recorded_ = std::move(opened.recorded);
  here_ = recorded_->scenario->world(recorded_->run.seed);
  return about(*recorded_->scenario, recorded_->run.seed, recorded_->until());
}

}  // namespace eyrie::web
