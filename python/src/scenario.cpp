// SPDX-License-Identifier: MIT
/// \file  Scenarios: loaded from files, and what they say of their players and
/// of their worlds.
#include <filesystem>

#include "common.hpp"
#include "core/field.hpp"
#include "scenario/mission.hpp"
#include "scenario/source.hpp"

namespace eyrie::python {
namespace {
namespace fs = std::filesystem;

using Sets = std::vector<std::string>;
using Files = std::map<std::string, std::string>;

/// The file that a name means: itself if it is one, or the one of Eyrie's own.
std::string file_named(const std::string& name, const scenario::Source& source) {
  std::error_code ignored;
  if (fs::is_regular_file(name, ignored))
    return name;
  if (const std::string own = source.shipped(name); !own.empty())
    return own;
  std::vector<std::string> names = source.shipped_names();
  std::sort(names.begin(), names.end());
  raise("MissingError",
        fmt::format("there is no scenario {}{}", quote(name), did_you_mean(name, names)));
}

Scenario load(const std::string& name, const std::optional<std::string>& text, const Sets& sets,
              const Sets& plugins, const Sets& includes, const std::vector<Behavior>& behaviors,
              const std::string& home) {
  const GilReleased released;
  scenario::Source source = scenario::Source::disk(home, includes);
  if (text)
    source.add(name, *text);
  std::string file = text ? name : file_named(name, source);
  return {scenario::load(
      {.file = std::move(file), .sets = sets, .plugins = plugins, .add = adds(behaviors)},
      std::move(source))};
}

Scenario load_texts(const std::string& file, const Files& files, const Sets& sets,
                    const Sets& plugins, const std::vector<Behavior>& behaviors) {
  const GilReleased released;
  return {scenario::load({.file = file, .sets = sets, .plugins = plugins, .add = adds(behaviors)},
                         scenario::Source::bundle(files))};
}

Sets plugins_of(const Scenario& s) {
  return listed(s.loaded->plugins, &scenario::PluginFile::path);
}

/// (name, kind, type, label, side, flight, rank)
using Player =
    std::tuple<std::string, std::string, std::string, std::string, std::string, std::string, int>;
std::vector<Player> players_of(const Scenario& s) {
  std::vector<Player> all;
  const scenario::Roster& roster = s.loaded->roster;
  for (const auto& player : roster.players)
    all.emplace_back(player.name, std::string(s.loaded->fleets[player.fleet]->words.name),
                     player.type, printable(player.label),
                     std::string(scenario::side_name(player.side)),
                     roster.flights[player.flight].name, player.rank);
  return all;
}

/// What the values of an enum are called.
std::map<std::uint64_t, std::string> choices_of(const FieldInfo& field) {
  constexpr std::uint64_t kMost = 256;
  std::map<std::uint64_t, std::string> names;
  for (std::uint64_t value = 0; field.choice && value < kMost; ++value)
    if (const std::string_view name = field.choice(value); !name.empty())
      names.emplace(value, name);
  return names;
}

/// (name, offset, type, count, unit, choices)
using Field = std::tuple<std::string, std::uint32_t, std::string, std::uint32_t, std::string,
                         std::map<std::uint64_t, std::string>>;
/// (name, bytes per row, fields)
using Column = std::tuple<std::string, std::uint32_t, std::vector<Field>>;
/// (name, columns)
using Table = std::tuple<std::string, std::vector<Column>>;

std::vector<Table> schema_of(const Scenario& s) {
  std::vector<Table> tables;
  const sim::Schema& schema = s.loaded->simulation->schema();
  for (const sim::TableInfo& table : schema.tables()) {
    std::vector<Column> columns;
    for (const std::uint32_t index : table.columns) {
      const sim::ColumnInfo& column = schema.column(index);
      std::vector<Field> fields;
      for (const FieldInfo& field : column.fields)
        fields.emplace_back(std::string(field.name.view()), field.offset,
                            std::string(scalar_name(field.type)), field.count,
                            std::string(field.unit), choices_of(field));
      columns.emplace_back(column.name, column.stride, std::move(fields));
    }
    tables.emplace_back(table.name, std::move(columns));
  }
  return tables;
}

}  // namespace

void add_scenario(nb::module_& m) {
  m.def("load", &load, nb::arg("name"), nb::arg("text").none(), nb::arg("sets"), nb::arg("plugins"),
        nb::arg("includes"), nb::arg("behaviors"), nb::arg("home"),
        "Loads a scenario from a file, one of Eyrie's own below home, or a "
        "text of that name.");
  m.def("load_texts", &load_texts, nb::arg("file"), nb::arg("files"), nb::arg("sets"),
        nb::arg("plugins"), nb::arg("behaviors"), "Loads a scenario from the texts of its files.");
  nb::class_<Scenario>(m, "Scenario", "A scenario that is ready to fly: eyrie.Scenario says more.")
      .def_prop_ro("name", [](const Scenario& s) { return printable(s.loaded->spec.name); })
      .def_prop_ro("file", [](const Scenario& s) { return printable(s.loaded->file); })
      .def_prop_ro("files", [](const Scenario& s) { return s.loaded->files; })
      .def_prop_ro("sets", [](const Scenario& s) { return s.loaded->sets; })
      .def_prop_ro("plugins", &plugins_of, "The files of its plug-ins.")
      .def_prop_ro("seed", [](const Scenario& s) { return s.loaded->spec.seed; })
      .def_prop_ro("until", [](const Scenario& s) { return s.loaded->spec.until; })
      .def_prop_ro("dt", [](const Scenario& s) { return s.loaded->simulation->dt(); })
      .def_prop_ro("players", &players_of, "(name, kind, type, label, side, flight, rank)")
      .def_prop_ro("schema", &schema_of,
                   "(table, [(column, bytes per row, [(field, offset, type, count, unit, "
                   "choices)])])");
}

}  // namespace eyrie::python
