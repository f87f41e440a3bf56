// SPDX-License-Identifier: MIT
#include "scenario/plugins.hpp"

#include <algorithm>
#include <iterator>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "disk/sink.hpp"
#include "driver/behaviors.hpp"
#include "pilot/catalog.hpp"

namespace eyrie::scenario {
namespace {

/// A name is a key of files and, unless a file has another, a label.
std::optional<std::string> word_problem(std::string_view name) {
  const auto fits = [](char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '-'; };
  if (name.empty() || !is_letter(name.front()) || !std::ranges::all_of(name, fits))
    return quote(name) + " is no word: a letter, then letters, digits, '_' and '-'";
  if (std::ranges::find(kReservedWords, name) != kReservedWords.end())
    return quote(name) + " means something else in a scenario";
  return ubf::label_problem(name);
}

/// What is wrong with the names that nodes and their parameters have.
template <class State, class Action>
void check_names(const ubf::Registry<State, Action>& registry, std::string_view origin,
                 std::vector<std::string>& problems) {
  for (const ubf::NodeInfo& node : registry.catalog()) {
    if (node.origin != origin)
      continue;
    if (const auto problem = word_problem(node.name))
      problems.push_back("the name of a node: " + *problem);
    for (const ubf::StateField<State>& field : ubf::StateFields<State>::all())
      if (field.info.name == node.name && field.info.kind == ubf::FieldKind::flag)
        problems.push_back(
            fmt::format("{} is no name for a node: alone it is the condition that this field of "
                        "the state is true",
                        quote(node.name)));
    std::vector<std::string> taken{std::string(ubf::kLabelKey), "children", "child"};
    taken.insert(taken.end(), node.child_keys.begin(), node.child_keys.end());
    for (const ParamInfo& parameter : node.parameters) {
      if (std::ranges::find(taken, parameter.name) != taken.end())
        problems.push_back(fmt::format("node {}: {} is no name for a parameter, it is taken",
                                       quote(node.name), quote(parameter.name)));
      taken.push_back(parameter.name);
    }
  }
}

}  // namespace

std::vector<std::string> name_problems(const Registries& registries, std::string_view origin) {
  std::vector<std::string> problems;
  check_names(registries.pilots, origin, problems);
  check_names(registries.drivers, origin, problems);
  return problems;
}

Plugins::Plugins() {
  static const auto own = std::make_shared<const Registries>(
      Registries{.pilots = pilot::make_registry(), .drivers = driver::make_registry()});
  registries_ = own;
}

std::vector<std::string> Plugins::add(const AddNodes& nodes) {
  Registries registries = *registries_;
  const std::string origin = "this program";
  Registrar registrar(registries, origin);
  nodes(registrar);
  std::vector<std::string> problems = registrar.problems();
  std::ranges::move(name_problems(registries, origin), std::back_inserter(problems));
  if (problems.empty())
    registries_ = std::make_shared<const Registries>(std::move(registries));
  added_ = true;
  return problems;
}

void Plugins::tell(Scenario& scenario) const {
  scenario.plugins.assign(files_.begin(), files_.end());
  scenario.has_foreign_nodes = added_ || !files_.empty();
}

void load_plugins(const LoadRequest& request, Plugins& plugins, Source& source,
                  Diagnostics& diagnostics) {
  for (const std::string& path : request.plugins)
    for (std::string& problem : plugins.load(path, source))
      diagnostics.error({"--plugin " + path, 0, 0}, std::move(problem));
  if (request.add)
    for (std::string& problem : plugins.add(request.add))
      diagnostics.error({}, std::move(problem));
}

void load_plugins(const Value& key, const PluginPermission& permission, Plugins& plugins,
                  Source& source, Diagnostics& diagnostics) {
  if (!key.is_list() && !key.is_scalar())
    diagnostics.error(key.where, "plugins: expected a file or a list of files, got " + key.shown());
  else
    for (const Value& item : key.as_list()) {
      if (!item.is_scalar())
        diagnostics.error(item.where, "plugins: expected a file, got {}", item.shown());
      else if (!source.is_bundle())
        for (const std::string& problem : plugins.load(file_named(item), source, &permission))
          diagnostics.error(item.where, "plug-in {}: {}", quote(item.text), problem);
    }
}

disk::FileRead read_plugin_file(const std::string& path) {
  disk::FileRead read = disk::read_file(path, kLargestPlugin);
  if (!read.problem.empty() && !read.missing)
    read.problem = "it " + read.problem;
  return read;
}

std::uint64_t hash_of(std::string_view bytes) {
  return hash_bytes(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

std::string shell_word(std::string_view path) {
  const auto plain = [](char c) {
    return is_letter(c) || is_digit(c) ||
           std::string_view("/._-+:@%=,").find(c) != std::string_view::npos;
  };
  const auto shown = [](char c) { return c >= ' ' && c <= '~'; };
  if (!path.empty() && std::ranges::all_of(path, plain))
    return std::string(path);
  const bool all_shown = std::ranges::all_of(path, shown);
  std::string word = all_shown ? "'" : "$'";
  for (const char c : path) {
    if (all_shown && c == '\'')
      word += "'\\''";
    else if (!all_shown && (c == '\'' || c == '\\'))
      (word += '\\') += c;
    else if (shown(c))
      word += c;
    else
      fmt::format_to(std::back_inserter(word), "\\x{:02x}", static_cast<unsigned char>(c));
  }
  return word + "'";
}

}  // namespace eyrie::scenario
