// SPDX-License-Identifier: MIT
#include "campaign_source.hpp"

#include <filesystem>

#include "commands.hpp"
#include "core/hash.hpp"
#include "locate.hpp"
#include "scenario/plugin_file.hpp"

namespace eyrie::app {
namespace {

namespace fs = std::filesystem;
using campaign::Spec;

/// Plug-ins that the campaign names are opened as those that a scenario names: if they are trusted.
void demand_trust(const Spec& spec, const std::vector<std::string>& typed) {
  for (std::size_t i = 0; i < spec.plugins.size(); ++i) {
    const std::string& plugin = spec.plugins[i];
    std::error_code ignored;
    const auto same = [&](const std::string& other) {
      return fs::equivalent(plugin, other, ignored);
    };
    if (std::ranges::any_of(typed, same))
      continue;
    const disk::FileRead read = scenario::read_plugin_file(plugin);
    const std::string why =
        scenario::refusal(trusted(), fs::weakly_canonical(plugin, ignored).string(), read.bytes);
    if (read.problem.empty() && !why.empty())
      throw ConfigError(spec.plugins_where[i], "plug-in {}: {}", quote_path(plugin),
                        scenario::not_opened(why, plugin));
  }
}

}  // namespace

CampaignSource::CampaignSource(Spec& spec, const std::vector<std::string>& typed,
                               const std::vector<std::string>& includes) {
  static_cast<void>(locate(spec.scenario, includes, spec.scenario_where));
  demand_trust(spec, typed);
  spec.plugins.insert(spec.plugins.end(), typed.begin(), typed.end());
  plugins_ = spec.plugins;
  spec.includes = includes;
  check(spec, [&](const std::vector<std::string>& sets) {
    auto loaded = load_scenario(spec.scenario, sets, spec.plugins, spec.includes);
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

}  // namespace eyrie::app
