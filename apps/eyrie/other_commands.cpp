// SPDX-License-Identifier: MIT
/// \file  validate, catalog and --version.
#include <set>

#include "campaign/whole_scenario.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "locate.hpp"
#include "record/event_table.hpp"
#include "record/json_schema.hpp"
#include "say.hpp"
#include "scenario/catalog.hpp"
#include "scenario/plugins.hpp"
#include "tables/schema.hpp"

namespace eyrie::app {

std::string version_text() {
  return "eyrie " EYRIE_VERSION " (" EYRIE_COMPILER ", " EYRIE_BUILD_TYPE ")";
}

namespace {

/// "6 aircraft in 2 flights and 5 vehicles in 1 convoy"
std::string players_text(const scenario::Scenario& scenario) {
  std::string text;
  for (std::size_t f = 0; f < scenario.fleets.size(); ++f) {
    const auto& words = scenario.fleets[f]->words;
    const auto players = std::ranges::count_if(
        scenario.roster.players, [&](const auto& player) { return player.fleet == f; });
    const auto groups = static_cast<std::size_t>(
        std::ranges::count_if(scenario.roster.flights, [&](const auto& flight) {
          return scenario.roster.find(flight.members.front())->fleet == f;
        }));
    if (players)
      text += fmt::format("{}{} {} in {}", text.empty() ? "" : " and ", players,
                          players == 1 ? words.name : words.plural, counted(groups, words.group));
  }
  return text;
}

}  // namespace

int validate(const ValidateOptions& options) {
  int printed = 0;
  const auto check = [&](const std::string& name) {
    const auto [file, source] = locate(name, options.includes);
    const scenario::LoadRequest request{
        .file = file, .plugins = options.plugins, .may_open = trusted()};
    if (const auto trees = scenario::check_package(request, source)) {
      if (options.print)
        refuse("{}: a package is no whole scenario: --print has nothing to print",
               quote_path(file));
      say("{}: a package, {}\n", file, counted(*trees, "tree"));
      return 0;
    }
    const auto scenario = scenario::load(request, source);
    std::set<std::string_view> trees;  // one may serve pilots and drivers
    for (const ubf::AnyTree* tree : scenario->all_trees())
      trees.insert(tree->name());
    if (options.print) {
      const campaign::WholeScenario whole = campaign::whole_scenario(file, {}, source);
      const std::string allowed = allowances(home() + "/", whole.folders);
      if (printed++)
        say("---\n");
      if (!allowed.empty())
        say("# elsewhere it is flown with{}\n", allowed);
      say("{}", lines(whole.text));
    } else {
      say("{}: {}, {}\n", file, players_text(*scenario), counted(trees.size(), "tree"));
    }
    return 0;
  };
  int code = 0;
  for (const std::string& file : options.files)
    code = std::max(code, attempt([&] { return check(file); }));
  return code;
}

int catalog(const CatalogOptions& options) {
  if (options.events || options.tables) {
    say("{}", lines(options.events ? record::events_markdown() : tables::tables_markdown()));
    return 0;
  }
  scenario::Source source = scenario::Source::disk(home());
  scenario::Plugins plugins;
  Diagnostics wrong;
  scenario::load_plugins({.file = {}, .plugins = options.plugins}, plugins, source, wrong);
  wrong.throw_if_any();
  const scenario::Catalog all = scenario::make_catalog(source, plugins);
  if (!options.node.empty()) {
    const auto text = scenario::node_text(all, options.node);
    if (!text) {
      const std::string hint = did_you_mean(options.node, scenario::node_names(all));
      refuse("there is no node {}{}", quote(options.node),
             hint.empty() ? "; 'eyrie catalog' tells which there are" : hint);
    }
    say("{}", lines(*text));
    return 0;
  }
  say("{}", lines(options.json_schema ? record::catalog_json_schema(all)
                  : options.markdown  ? scenario::catalog_markdown(all)
                                      : scenario::catalog_text(all)));
  return 0;
}

}  // namespace eyrie::app
