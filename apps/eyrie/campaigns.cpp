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
    const std::array parts{
        page::part_of("campaign",
                      texts.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)),
        page::part_of("zones", launch_zones())};
    return {base64(page::deflated(page::page_with(shell.bytes, parts))), {}};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return none(words_for(e));
  }
}

}  // namespace eyrie::app
