// SPDX-License-Identifier: MIT
#include "scenario/catalog.hpp"

#include "core/describe.hpp"
#include "driver/state.hpp"
#include "model/library.hpp"
#include "scenario/data.hpp"
#include "scenario/spec.hpp"

namespace eyrie::scenario {
namespace {

/// The groups that the loader binds by hand, at the top level and in a side.
struct ByHand {
  static constexpr std::string_view type_name = "by_hand";
  static constexpr auto params() {
    return Lines{
        param("environment", &ByHand::environment, "the air and its wind"),
        param("home", &ByHand::home, "where its flights land that have no home of their own")};
  }
  model::EnvironmentSpec environment;
  std::optional<PlaceSpec> home;
};

ParamInfo by_hand(std::string_view name) {
  for (ParamInfo& info : parameters<ByHand>())
    if (info.name == name)
      return std::move(info);
  return {};
}

ParamInfo custom(std::string name, std::string shape, std::string help, bool required = false) {
  ParamInfo info;
  info.type_name = std::move(shape);
  info.name = std::move(name);
  info.help = std::move(help);
  info.required = required;
  return info;
}

std::vector<ParamInfo> with(std::vector<ParamInfo> all, std::vector<ParamInfo> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  return all;
}

/// The list of who is in a flight or a convoy.
ParamInfo members(std::string_view group) {
  return custom("players", "list",
                fmt::format("a list of names, each the {0}'s name and a rank from 1 (the lead) to "
                            "8; or of maps with one such name and what it says differently from "
                            "its {0}",
                            group),
                true);
}

std::vector<FilePart> file_parts() {
  const std::string side_help = "its flights and convoys; at least one side has some";
  return {
      {"scenario", "", std::string(ScenarioSpec::help),
       with(parameters<ScenarioSpec>(),
            {custom("extends", "text",
                    "a scenario that this one changes: one of Eyrie's own by its name, or a file; "
                    "then nothing else is required, and what is said here takes its place"),
             custom("include", "text or list of texts",
                    "a file, or a list of files, whose `trees`, `data` and `plugins` are added"),
             custom("insert", "map",
                    "what is added to that which is extended and included, by path: to a list at "
                    "its end, or `before` or `after` one of its items; to a map under a new key"),
             custom("replace", "map", "what takes the place of something else, by path"),
             custom("remove", "text or list of texts", "what is taken out: a path, or a list"),
             custom("plugins", "text or list of texts",
                    "a plug-in, or a list of them: shared libraries whose nodes and models may "
                    "then be named; relative to this file"),
             by_hand("environment"), custom("trees", "map", "trees by name: see *Trees*"),
             custom("data", "map", "models by kind and name: see *Models*"),
             custom("blue", "map", side_help), custom("red", "map", side_help)})},
      {"side",
       "blue, red",
       "the flights of one side",
       {by_hand("home"),
        custom("flights", "map", "flights by name: small letters, digits and '_', no digit last"),
        custom("convoys", "map", "convoys by name, in the same way")}},
      {"flight", "blue.flights.<name>", std::string(FlightSpec::help),
       with(parameters<FlightSpec>(), {members("flight")})},
      {"player", "blue.flights.<name>.players.<player>", std::string(PlayerSpec::help),
       parameters<PlayerSpec>()},
      {"convoy", "blue.convoys.<name>", std::string(ConvoySpec::help),
       with(parameters<ConvoySpec>(), {members("convoy")})},
      {"vehicle", "blue.convoys.<name>.players.<player>", std::string(VehicleSpec::help),
       parameters<VehicleSpec>()}};
}

template <Described Model>
ModelKind kind(const KindOfModel<Model>& of, const Source& source) {
  ModelKind result{std::string(of.folder), std::string(Model::type_name), std::string(Model::help),
                   parameters<Model>(),    source.data_names(of.folder),  {}};
  for (const std::string& name : result.names)
    if (const auto origin = source.origin(of.folder, name))
      result.origins[name] = *origin;
  return result;
}

}  // namespace

Catalog make_catalog(const Source& source, const Plugins& plugins) {
  Catalog result;
  result.scenarios = source.shipped_names();
  std::ranges::sort(result.scenarios);
  result.file = file_parts();
  const auto nodes = plugins.registries().pilots.catalog();
  result.nodes.assign(nodes.begin(), nodes.end());
  result.fields = ubf::state_field_infos<pilot::State>();
  result.others = {{"vehicles", "convoys", "convoy", own_nodes(plugins.registries().drivers),
                    ubf::state_field_infos<driver::State>()}};
  for (const MakeKind& make : plugins.registries().kinds) {
    const auto added = make();
    FilePart group = added->group();
    result.others.push_back({std::string(added->fleet()->words.plural), std::string(added->key()),
                             group.name, added->nodes(), added->state_fields()});
    FilePart& side = *std::ranges::find(result.file, "side", &FilePart::name);
    side.parameters.push_back(custom(std::string(added->key()), "map", group.help + ", by name"));
    result.file.push_back(std::move(group));
  }
  each_kind_of_model([&](const auto& of) { result.models.push_back(kind(of, source)); });
  return result;
}

}  // namespace eyrie::scenario
