// SPDX-License-Identifier: MIT
#include "campaign/spec.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/bind.hpp"
#include "core/text.hpp"
#include "core/yaml.hpp"
#include "disk/sink.hpp"
#include "scenario/path.hpp"
#include "scenario/source.hpp"

namespace eyrie::campaign {
namespace {

/// `stop:` as the file gives it.
struct StopSpec {
  static constexpr std::string_view type_name = "stop";
  static constexpr auto params() {
    using S = StopSpec;
    constexpr Range kCount = range(2, Spec::kMostReplicates);
    return Lines{
        param("measure", &S::measure, "name of a measure").required(),
        param("width", &S::width, "of its interval").required(),
        param("confidence", &S::confidence, range(0.5, 0.9999), "of its interval"),
        param("least", &S::least, kCount, "replicates before the first look"),
        param("most", &S::most, kCount, "replicates of a cell"),
        param("every", &S::every, range(1, Spec::kMostReplicates), "replicates between two looks")};
  }
  std::string measure, width;
  double confidence = Stopping{}.confidence;
  std::uint64_t least = Stopping{}.least, most = Stopping{}.most, every = Stopping{}.every;
};

std::optional<Stopping> read_stop(const Value& map, const Measures& measures,
                                  Diagnostics& diagnostics) {
  StopSpec stop;
  if (!bind(stop, map, diagnostics))
    return std::nullopt;
  const Measure* const measure = find_measure(measures, map, "stop", diagnostics);
  if (!measure)
    return std::nullopt;
  const std::string& symbol = measures.columns[measure->column].unit;
  const UnitInfo* const unit = measure->kind == Measure::mean ? find_unit(symbol) : nullptr;
  const Parsed width = parse_quantity(stop.width, unit ? unit->dimension : Dimension::none);
  if (!width || width.value <= 0)
    diagnostics.error(map.where_of("width"),
                      "stop: width: " + (width ? "must be more than 0" : width.error));
  else if (measure->kind == Measure::share && width.value >= 1)
    diagnostics.error(map.where_of("width"),
                      "stop: width: that of a share must be less than 1, got " + quote(stop.width));
  if (stop.least > stop.most)
    diagnostics.error(map.where_of("most"), "stop: most: {} is less than least, {}", stop.most,
                      stop.least);
  const auto index = static_cast<std::size_t>(measure - measures.estimates.data());
  return Stopping{index, width.value, stop.confidence, stop.least, stop.most, stop.every};
}

Design read_design(const Value& value, Diagnostics& diagnostics) {
  Design design;
  // a name alone is its kind
  bind(design, value.is_scalar() ? Value::map({{"kind", value.where, value}}, value.where) : value,
       diagnostics);
  return design;
}

constexpr std::string_view kSeed = "seed";
constexpr std::string_view kIdleSeed = "'seed' does nothing here: 'seeds' says which are flown";

/// Of `path=value`, or a path alone.
std::string quoted_path(std::string_view set) {
  return quote(set.substr(0, scenario::path_size(set)));
}

/// Where each of the texts of a key stands.
std::vector<Location> places_of(const Value& document, std::string_view key) {
  std::vector<Location> all;
  if (const Value* list = document.find(key))
    for (const Value& item : list->is_list() ? std::span(list->items) : std::span(list, 1))
      if (!item.is_null())
        all.push_back(item.where);
  return all;
}

/// The first path of one factor that another one sets, too; nothing if there is none.
std::optional<std::string> shared_path(const Factor& one, const Factor& other) {
  for (const std::string& path : one.all_paths())
    for (const std::string& theirs : other.all_paths())
      if (scenario::covers(theirs, path))
        return path;
      else if (scenario::covers(path, theirs))
        return theirs;
  return std::nullopt;
}

/// What a factor says that does nothing.
void refuse_idle(const Factor& factor, Diagnostics& diagnostics) {
  const auto refuse_twice = [&](std::span<const std::string> sets, const Location& where) {
    for (const auto& [first, again] : scenario::set_twice(sets))
      diagnostics.error(where, "{}: {} is set twice", factor.name, quoted_path(sets[first]));
  };
  refuse_twice(factor.paths, factor.where);
  for (const Level& level : factor.levels)
    if (factor.paths.empty())
      refuse_twice(level.sets, level.where);
  for (const std::string& path : factor.all_paths())
    if (scenario::covers(kSeed, path))
      diagnostics.error(factor.where, "{}: {}", factor.name, kIdleSeed);
}

/// What `set:` and the factors say that does nothing.
void refuse_idle_sets(const Spec& spec, Diagnostics& diagnostics) {
  const std::size_t read = std::min(spec.sets.size(), spec.sets_where.size());
  for (std::size_t i = 0; i < read; ++i)
    if (scenario::path_size(spec.sets[i]) == spec.sets[i].size())
      diagnostics.error(spec.sets_where[i], "set: expected path=value, got {}",
                        quote(spec.sets[i]));
    else if (scenario::covers(kSeed, spec.sets[i]))
      diagnostics.error(spec.sets_where[i], "set: {}", kIdleSeed);
  for (const auto& [first, again] : scenario::set_twice(std::span(spec.sets).first(read)))
    diagnostics.error(spec.sets_where[again], "set: {} is set twice (also at {})",
                      quoted_path(spec.sets[first]), spec.sets_where[first].text());
  for (std::size_t f = 0; f < spec.factors.size(); ++f) {
    const Factor& factor = spec.factors[f];
    refuse_idle(factor, diagnostics);
    for (const Factor& before : std::span(spec.factors).first(f))
      if (const auto path = shared_path(factor, before))
        diagnostics.error(factor.where, "{}: {} is set by {}, too: one would undo the other",
                          factor.name, quote(*path), before.name);
  }
}

/// Whether each level of a factor sets what `set` does.
bool undoes(const Factor& factor, const std::string& set) {
  const auto covers = [&](const std::string& own) { return scenario::covers(own, set); };
  if (!factor.paths.empty())
    return std::ranges::any_of(factor.paths, covers);
  return !factor.levels.empty() && std::ranges::all_of(factor.levels, [&](const Level& level) {
    return std::ranges::any_of(level.sets, covers);
  });
}

std::string refuses(std::string_view what, std::string_view value) {
  return fmt::format("{}: the scenario refuses {}", what, quote(value));
}

/// Who in the campaign sets what the first of these mistakes is in, and where; nothing if it is in
/// the scenario itself.
std::optional<Diagnostic> setter_of(const Diagnostics& wrong, const Spec& spec, const Cell& cell) {
  const std::string file(wrong.sorted().front().where.file.text());
  const auto is_in = [&](const std::string& set) { return file == "--set " + set; };
  for (std::size_t f = 0; f < spec.factors.size(); ++f) {
    const Factor& factor = spec.factors[f];
    const std::string& value = cell.values[f];
    const std::vector<std::string> sets = factor.sets_of(value);
    if (std::ranges::none_of(sets, is_in))
      continue;
    const auto level = std::ranges::find(factor.levels, value, &Level::name);
    return Diagnostic{level == factor.levels.end() ? factor.where : level->where,
                      refuses(factor.name, value)};
  }
  for (std::size_t i = 0; i < spec.sets_where.size(); ++i)
    if (is_in(spec.sets[i]))
      return Diagnostic{spec.sets_where[i], refuses("set", spec.sets[i])};
  for (std::size_t i = 0; i < spec.plugins_where.size(); ++i)
    if (file == "--plugin " + spec.plugins[i])
      return Diagnostic{spec.plugins_where[i],
                        fmt::format("plugins: {} cannot be used", quote_path(spec.plugins[i]))};
  return std::nullopt;
}

/// What the scenario refuses of a cell; who is to blame, if anybody is, is said first.
void try_it(const Spec& spec, const Cell& cell, const Load& load, Diagnostics& wrong, auto blame) {
  try {
    static_cast<void>(watch(spec.measures, *load(sets_of(spec, cell))));
  } catch (const ConfigError& error) {
    if (const std::optional<Diagnostic> first = blame(error.diagnostics()))
      wrong.error(first->where, first->message);
    wrong.merge(error.diagnostics());
  }
}

}  // namespace

std::optional<std::pair<std::uint64_t, std::uint64_t>> two_numbers(std::string_view text,
                                                                   std::string_view between) {
  const std::size_t at = text.find(between);
  if (at == text.npos)
    return std::nullopt;
  const auto one = number_from<std::uint64_t>(text.substr(0, at));
  const auto other = number_from<std::uint64_t>(text.substr(at + between.size()));
  return one && other ? std::optional(std::pair(*one, *other)) : std::nullopt;
}

const Measure* find_measure(const Measures& measures, const Value& map, std::string_view owner,
                            Diagnostics& diagnostics) {
  const Value* const wanted = map.find("measure");
  std::vector<std::string> names;
  for (const Measure& m : measures.estimates)
    if (wanted && m.name == wanted->text)
      return &m;
    else
      names.push_back(m.name);
  if (wanted)
    diagnostics.error(wanted->where, "{}: there is no measure {}{}", owner, quote(wanted->text),
                      nearest_or_all(wanted->text, names));
  return nullptr;
}

Spec bind_spec(const Value& document, const std::string& file,
               std::span<const std::string_view> also, Diagnostics& diagnostics) {
  Spec spec;
  if (!document.is_map())
    throw ConfigError({file, 1, 1}, "expected a map, got " + document.shown());
  if (const auto other = scenario::other_format(document))
    throw ConfigError(other->where, other->message);
  if (document.find("blue") || document.find("red"))
    throw ConfigError({file, 1, 1}, "this is a scenario: eyrie fly " + quote_path(file));
  std::vector<std::string_view> by_hand{"factors", "measures"};
  by_hand.insert(by_hand.end(), also.begin(), also.end());
  bind(spec, document, diagnostics, by_hand);
  spec.file = file;
  if (const Value* scenario = document.find("scenario"); scenario && spec.scenario.empty())
    diagnostics.error(scenario->where, "scenario: expected a name or a file, got ''");
  if (spec.scenario.ends_with(".yaml"))
    spec.scenario = scenario::relative_to(file, spec.scenario);
  for (std::string& plugin : spec.plugins)
    plugin = scenario::relative_to(file, plugin);
  spec.scenario_where = document.where_of("scenario");
  spec.sets_where = places_of(document, "set");
  spec.plugins_where = places_of(document, "plugins");
  if (const Value* factors = document.find("factors"))
    spec.factors = read_factors(*factors, diagnostics);
  refuse_idle_sets(spec, diagnostics);
  if (const Value* measures = document.find("measures"))
    spec.measures = read_measures(*measures, diagnostics);
  else
    diagnostics.error(document.where, "campaign needs 'measures'");
  // each is a column of a table, of which SQLite takes 2000
  constexpr std::size_t kMostColumns = 1900;
  if (spec.measures.columns.size() > kMostColumns)
    diagnostics.error(document.where_of("measures"), "measures: {} columns, at most {} fit a table",
                      spec.measures.columns.size(), kMostColumns);
  if (spec.factors.size() > kMostColumns)
    diagnostics.error(document.where_of("factors"), "factors: here are {}, at most {} fit a table",
                      spec.factors.size(), kMostColumns);
  return spec;
}

Spec parse_spec(std::string text, const std::string& file) {
  Diagnostics diagnostics;
  const Value document = parse_yaml(text, file, diagnostics);
  diagnostics.throw_if_any();
  if (const Value* search = document.find("optimize"))
    throw ConfigError(search->where, "this is a search: eyrie optimize " + quote_path(file));
  static constexpr std::array<std::string_view, 2> kAlso{"design", "stop"};
  Spec spec = bind_spec(document, file, kAlso, diagnostics);
  for (std::size_t i = 0; i < spec.sets.size() && diagnostics.ok(); ++i)
    for (const Factor& factor : spec.factors)
      if (undoes(factor, spec.sets[i]))
        diagnostics.error(spec.sets_where[i], "set: {} is set by {} in each cell, too",
                          quoted_path(spec.sets[i]), factor.name);
  if (const Value* design = document.find("design"))
    spec.design = read_design(*design, diagnostics);
  if (diagnostics.ok())
    if (const auto problem = problem_of(spec.design, spec.factors))
      diagnostics.error(problem->where.line > 0 ? problem->where : document.where_of("design"),
                        "design: " + problem->message);
  if (const Value* stop = document.find("stop")) {
    spec.stop = read_stop(*stop, spec.measures, diagnostics);
    if (document.find("replicates"))
      diagnostics.error(document.where_of("replicates"),
                        "'stop' says how many replicates there are; leave out 'replicates'");
  }
  diagnostics.throw_if_any();
  spec.text = std::move(text);
  return spec;
}

std::string read_text(const std::string& file) {
  disk::FileRead read = disk::read_file(file, scenario::Source::kLargest);
  if (!read.problem.empty())
    throw ConfigError({file, 0, 0}, read.problem);
  return std::move(read.bytes);
}

Spec read_spec(const std::string& file) {
  return parse_spec(read_text(file), file);
}

void check_parts(const Spec& spec) {
  Diagnostics diagnostics;
  const Value document = parse_yaml(spec.text, spec.file, diagnostics);
  const Value* const budget = document.find("budget");
  if (spec.stop)
    diagnostics.error(
        document.where_of("stop"),
        "stop: needs the results of all parts; without it, 'replicates' says how many are flown");
  if (spec.budget.replicates)
    diagnostics.error(budget->where_of("replicates"),
                      "budget: replicates: a part does not know how many the others have flown");
  diagnostics.throw_if_any();
}

std::vector<Cell> cells_of(const Spec& spec) {
  return cells_of(spec.design, spec.factors);
}

std::vector<std::string> sets_of(const Spec& spec, const Cell& cell) {
  std::vector<std::string> own;
  for (std::size_t f = 0; f < spec.factors.size(); ++f)
    for (std::string& set : spec.factors[f].sets_of(cell.values[f]))
      own.push_back(std::move(set));
  std::vector<std::string> sets;
  for (const std::string& set : spec.sets)
    if (std::ranges::none_of(own, [&](const auto& later) { return scenario::covers(later, set); }))
      sets.push_back(set);
  sets.insert(sets.end(), own.begin(), own.end());
  return sets;
}

std::string cell_text(const Spec& spec, const Cell& cell) {
  std::vector<std::string> parts;
  for (std::size_t f = 0; f < cell.values.size(); ++f)
    parts.push_back(spec.factors[f].name + " " + cell.values[f]);
  return fmt::format("{}", fmt::join(parts, ", "));
}

void check(const Spec& spec, const Load& load) {
  const std::vector<Cell> cells = cells_of(spec);
  Diagnostics all;
  try_it(spec, cells.front(), load, all,
         [&](const Diagnostics& wrong) { return setter_of(wrong, spec, cells.front()); });
  all.throw_if_any();  // else every other cell would say it, too
  for (std::size_t f = 0; f < spec.factors.size(); ++f) {
    const Factor& factor = spec.factors[f];
    std::vector<std::pair<std::string, Location>> values;
    for (const Level& level : factor.levels)
      values.emplace_back(level.name, level.where);
    if (factor.distribution) {
      // of numbers the least and the greatest
      const auto less = [&](const Cell& a, const Cell& b) {
        return std::strtod(a.values[f].c_str(), nullptr) <
               std::strtod(b.values[f].c_str(), nullptr);
      };
      const auto [least, most] = std::ranges::minmax_element(cells, less);
      values = {{least->values[f], factor.where}, {most->values[f], factor.where}};
    }
    for (const auto& [value, where] : values) {
      Cell cell = cells.front();
      if (std::exchange(cell.values[f], value) == value)
        continue;
      try_it(spec, cell, load, all, [&](const auto&) {
        return Diagnostic{where, refuses(factor.name, value)};
      });
    }
  }
  all.throw_if_any();
}

void check_cells(const Spec& spec, std::span<const Cell> cells, const Load& load) {
  constexpr std::size_t kMost = 2000;
  Diagnostics wrong;
  for (std::size_t c = 0; c < std::min(cells.size(), kMost) && wrong.ok(); ++c)
    try_it(spec, cells[c], load, wrong, [&](const auto&) {
      return Diagnostic{
          {spec.file, 0, 0},
          fmt::format("the scenario refuses cell {} ({})", c, cell_text(spec, cells[c]))};
    });
  wrong.throw_if_any();
}

}  // namespace eyrie::campaign
