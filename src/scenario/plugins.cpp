// SPDX-License-Identifier: MIT
#include "scenario/plugins.hpp"

#include "core/hash.hpp"
#include "core/text.hpp"
#include "disk/sink.hpp"
#include "driver/behaviors.hpp"
#include "pilot/catalog.hpp"

namespace eyrie::scenario {

Plugins::Plugins() {
  static const auto own = std::make_shared<const Registries>(
      Registries{.pilots = pilot::make_registry(), .drivers = driver::make_registry()});
  registries_ = own;
}

std::vector<std::string> Plugins::add(const AddNodes& nodes) {
  Registries registries = *registries_;
  Registrar registrar(registries, "this program");
  nodes(registrar);
  if (registrar.problems().empty())
    registries_ = std::make_shared<const Registries>(std::move(registries));
  added_ = true;
  return registrar.problems();
}

void Plugins::tell(Scenario& scenario) const {
  scenario.plugins.assign(files_.begin(), files_.end());
  scenario.has_foreign_nodes = added_ || !files_.empty();
}

void load_plugins(const LoadRequest& request, Plugins& plugins, Source& source,
                  Diagnostics& diagnostics) {
  load_plugins(request.plugins, plugins, source, diagnostics);
  if (request.add)
    for (std::string& problem : plugins.add(request.add))
      diagnostics.error({}, std::move(problem));
}

void load_plugins(std::span<const std::string> paths, Plugins& plugins, Source& source,
                  Diagnostics& diagnostics) {
  for (const std::string& path : paths)
    for (std::string& problem : plugins.load(path, source))
      diagnostics.error({"--plugin " + path, 0, 0}, std::move(problem));
}

void load_plugins(const Value& key, const PluginPermission& permission, Plugins& plugins,
                  Source& source, Diagnostics& diagnostics) {
  const auto load = [&](const Value& item) {
    if (!item.is_scalar())
      return diagnostics.error(item.where, "plugins: expected a file, got " + item.shown());
    if (source.is_bundle())
      return;
    // what --set names is meant as it was typed
    const bool typed = item.where.file.text().starts_with("--set ");
    const std::string path = typed ? item.text : relative_to(item.where.file.text(), item.text);
    for (const std::string& problem : plugins.load(path, source, &permission))
      diagnostics.error(item.where, fmt::format("plug-in {}: {}", quote(item.text), problem));
  };
  if (key.is_list())
    std::for_each(key.items.begin(), key.items.end(), load);
  else if (key.is_scalar())
    load(key);
  else if (!key.is_null())
    diagnostics.error(key.where, "plugins: expected a file or a list of files, got " + key.shown());
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
  if (!path.empty() && std::all_of(path.begin(), path.end(), plain))
    return std::string(path);
  const bool all_shown = std::all_of(path.begin(), path.end(), shown);
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
