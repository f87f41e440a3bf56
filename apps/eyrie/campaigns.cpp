// SPDX-License-Identifier: MIT
#include "campaigns.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "campaign/again.hpp"
#include "campaign/store.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "locate.hpp"
#include "page/page.hpp"
#include "record/json_text.hpp"
#include "say.hpp"
#include "scenario/plugin_file.hpp"

namespace eyrie::app {
namespace {

namespace fs = std::filesystem;
using campaign::Spec;

/// Whether one of them is that file, however it is written.
bool has_file(const std::vector<std::string>& files, const std::string& wanted) {
  return std::ranges::any_of(files, [&](const std::string& file) {
    std::error_code ignored;
    return file == wanted || fs::equivalent(file, wanted, ignored);
  });
}

/// Plug-ins that the campaign names are opened as those that a scenario names: if they are trusted.
void demand_trust(const Spec& spec, const std::vector<std::string>& typed) {
  for (std::size_t i = 0; i < spec.plugins.size(); ++i) {
    const std::string& plugin = spec.plugins[i];
    if (has_file(typed, plugin))
      continue;
    std::error_code ignored;
    const std::string path = fs::weakly_canonical(plugin, ignored).string();
    if (!fs::exists(path, ignored))
      continue;
    const scenario::PluginPermission may_open = trusted();
    if (const disk::FileRead read = scenario::read_allowed(path, &may_open, plugin);
        !read.problem.empty())
      throw ConfigError(spec.plugins_where[i], "plug-in {}: {}", quote_path(plugin), read.problem);
  }
}

/// Texts in columns, the first row above the others.
void print_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], columns(printable(row[i])));
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += fmt::format("{:<{}}  ", printable(row[i]), widths[i]);
    say("{}\n", Composed{line.substr(0, line.find_last_not_of(' ') + 1)});
  }
}

}  // namespace

CampaignSource::CampaignSource(Spec& spec, const std::vector<std::string>& typed,
                               const std::vector<std::string>& includes) {
  const std::string file = locate(spec.scenario, includes, spec.scenario_where).file;
  demand_trust(spec, typed);
  for (const std::string& plugin : typed)
    if (!has_file(spec.plugins, plugin))
      spec.plugins.push_back(plugin);
  plugins_ = spec.plugins;
  spec.includes = includes;
  check(spec, [&](const std::vector<std::string>& sets) {
    auto loaded = load_scenario(file, sets, spec.plugins, spec.includes);
    scenario_ = loaded->file;
    files_.insert(loaded->files.begin(), loaded->files.end());
    for (const scenario::PluginFile& plugin : loaded->plugins)
      origin_[fs::path(plugin.path).filename()] = hash_text(plugin.hash);
    return loaded;
  });
  // named from the folder of the scenario, wherever that is seen from
  const fs::path folder = fs::path(scenario_).remove_filename();
  for (const auto& [name, text] : files_) {
    const fs::path from_there = fs::path(name).lexically_relative(folder);
    const bool is_ours = name.starts_with("data/") || name.starts_with(scenario::Source::kOwn);
    origin_[is_ours || from_there.empty() ? name : from_there.string()] = text;
  }
  origin_[campaign::kCampaignText] = spec.text;
  origin_[campaign::kProgramText] = version_text();
}

std::uint64_t CampaignSource::hash() const {
  Hasher hash;
  for (const auto& [name, text] : origin_)
    for (const std::string& part : {name, text}) {
      hash.word(part.size());
      hash.bytes(part.data(), part.size());
    }
  return hash.value();
}

campaign::Load CampaignSource::load() const {
  return [this](const std::vector<std::string>& sets) {
    return scenario::load(
        {.file = scenario_, .sets = sets, .plugins = plugins_, .may_open = trusted()}, files());
  };
}

CampaignDebrief campaign_debrief(const std::string& folder,
                                 const std::vector<std::string>& plugins) {
  const auto none = [](std::string problem) { return CampaignDebrief{{}, std::move(problem)}; };
  const disk::FileRead shell = read_page(viewer_file(), "the debrief page was not built");
  if (!shell.problem.empty())
    return none(shell.problem);
  if (!page::has_engine(shell.bytes))
    return none("the debrief page was built without its engine");
  try {
    campaign::Database database = campaign::open_results(folder);
    campaign::Again again(database, plugins, 1);
    const auto sets = again.sets();
    if (sets.empty() || !again.scenario(0)->plugins.empty())
      return none("it needs plug-ins, which a page cannot open");
    nlohmann::ordered_json texts{{"scenario", again.file()}, {"sets", sets}};
    for (const auto& [name, text] : again.files())
      if (name != campaign::kCampaignText && name != campaign::kProgramText)
        texts["files"][name] = text;
    const std::array parts{page::part_of("campaign", record::json_text(texts)),
                           page::part_of("zones", launch_zones())};
    return {base64(page::deflated(page::page_with(shell.bytes, parts))), {}};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return none(words_for(e));
  }
}

std::string duration_text(double seconds) {
  if (seconds < 90)
    return fmt::format("{:.0f} s", seconds);
  if (seconds < 90 * 60)
    return fmt::format("{:.0f} min", seconds / 60);
  const auto minutes = static_cast<std::uint64_t>(seconds / 60 + 0.5);
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

void print_cells(const campaign::Summary& summary) {
  constexpr std::size_t kMostRows = 50, kMostFaults = 5;
  std::vector<std::vector<std::string>> rows(1, {"cell"});
  rows[0].insert(rows[0].end(), summary.factors.begin(), summary.factors.end());
  rows[0].push_back("n");
  for (std::size_t m = 0; m < summary.measures.size(); ++m)
    rows[0].push_back(summary.measures[m].name +
                      (summary.units[m].empty() ? "" : ", " + summary.units[m]));
  for (std::size_t c = 0; c < std::min(summary.cells.size(), kMostRows); ++c) {
    const auto& cell = summary.cells[c];
    auto& row = rows.emplace_back(1, std::to_string(c));
    row.insert(row.end(), cell.values.begin(), cell.values.end());
    row.push_back(std::to_string(cell.replicates));
    for (std::size_t m = 0; m < summary.measures.size(); ++m) {
      const campaign::Estimate& e = cell.estimates[m];
      row.push_back(estimate_text(e, summary.measures[m].kind));
      if (e.value && e.n != cell.replicates - cell.faults)
        row.back() += fmt::format(" of {}", e.n);  // to so many it applies
    }
  }
  print_table(rows);
  if (summary.cells.size() > kMostRows)
    say("... and {}\n", counted(summary.cells.size() - kMostRows, "more cell"));
  for (std::size_t i = 0; i < std::min(summary.faults.size(), kMostFaults); ++i)
    say("fault in cell {}: {}\n  {}\n", summary.faults[i].cell, summary.faults[i].what,
        summary.faults[i].command);
  if (summary.faults.size() > kMostFaults)
    say("... and more faults: see the table `faults`\n");
}

void print_comparisons(const campaign::Summary& summary,
                       const std::vector<campaign::Comparison>& comparisons, std::size_t most) {
  if (comparisons.empty())
    return;
  std::vector<campaign::Comparison> surest = comparisons;
  std::ranges::stable_sort(surest, {},
                           [](const campaign::Comparison& c) { return std::pair(c.holm, c.p); });
  std::vector<std::vector<std::string>> rows{{"measure", "cell", "less cell", "difference",
                                              summary.paired ? "pairs" : "replicates", "p",
                                              "p (Holm)"}};
  for (std::size_t i = 0; i < std::min(surest.size(), most); ++i) {
    const auto& c = surest[i];
    rows.push_back({summary.measures[c.measure].name, std::to_string(c.cell),
                    std::to_string(c.than),
                    estimate_text({c.n, c.value, c.interval}, summary.measures[c.measure].kind),
                    summary.paired ? std::to_string(c.n) : fmt::format("{} and {}", c.n, c.n_than),
                    fmt::format("{:.2g}", c.p), fmt::format("{:.2g}", c.holm)});
  }
  say("\ncells against each other, {}, the surest first\n",
      summary.paired ? "replicate by replicate" : "of other seeds");
  print_table(rows);
  if (surest.size() > most)
    say("... and {}\n", counted(surest.size() - most, "more comparison"));
}

void print_effects(const campaign::Summary& summary, const std::vector<campaign::Effect>& effects,
                   const std::vector<campaign::Interaction>& interactions) {
  if (effects.empty())
    return;
  std::vector<std::vector<std::string>> rows{{"measure", "factor", "part", "means"}};
  for (const auto& effect : effects) {
    std::string means;
    for (const auto& level : effect.levels)
      means += fmt::format("{}{}: {:.4g}", means.empty() ? "" : ", ", level.name, level.mean);
    rows.push_back({summary.measures[effect.measure].name, summary.factors[effect.factor],
                    fmt::format("{:.0f} %", 100 * effect.part), means});
  }
  for (const auto& both : interactions)
    rows.push_back({summary.measures[both.measure].name,
                    fmt::format("{} x {}", summary.factors[both.one], summary.factors[both.other]),
                    fmt::format("{:.0f} %", 100 * both.part), ""});
  say("\nwhich factor goes with the variance between cells, and the mean of each of its levels\n");
  print_table(rows);
}

}  // namespace eyrie::app
