// SPDX-License-Identifier: MIT
/// \file  How a plug-in is opened: the part of Plugins that needs a system with shared libraries.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <new>
#include <set>
#include <string_view>
#include <utility>

#include "core/text.hpp"
#include "scenario/data.hpp"
#include "scenario/end_guard.hpp"
#include "scenario/plugins.hpp"
#include "scenario/shared_library.hpp"
#include "scenario/shared_object.hpp"

namespace eyrie::scenario {
namespace {
namespace fs = std::filesystem;

/// Every reason why a model of a plug-in cannot be taken.
std::vector<std::string> model_problems(const Registrar& added, const Source& source) {
  std::vector<std::string> problems;
  const auto kinds = DataLoader::kinds();
  std::map<std::string, std::vector<std::string>> there;           // by kind, sorted
  std::set<std::pair<std::string_view, std::string_view>> before;  // of this plug-in
  for (const ModelText& model : added.models()) {
    const auto [names, first] = there.try_emplace(model.kind);
    if (first)
      names->second = source.data_names(model.kind);
    if (std::find(kinds.begin(), kinds.end(), model.kind) == kinds.end())
      problems.push_back(fmt::format("there is no kind of model {}{}", quote(model.kind),
                                     did_you_mean(model.kind, kinds)));
    else if (!is_identifier(model.name))
      problems.push_back(fmt::format("{} is no name for a model", quote(model.name)));
    else if (std::binary_search(names->second.begin(), names->second.end(), model.name))
      problems.push_back(fmt::format("there is already a model {} ({})", quote(model.name),
                                     source.data_name(model.kind, model.name)));
    else if (!before.emplace(model.kind, model.name).second)
      problems.push_back(fmt::format("it adds the model {} twice", quote(model.name)));
  }
  return problems;
}

/// The nearest shared library in the folder of one that is not there.
std::string nothing_there(const fs::path& path) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(path.parent_path(), ignored))
    if (entry.path().extension() == ".so")
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return "there is no such file" + did_you_mean(path.filename().string(), names);
}

}  // namespace

std::vector<std::string> Plugins::load(const std::string& path, Source& source,
                                       const PluginPermission* permission) {
  std::error_code failed;
  const fs::path file = fs::weakly_canonical(path, failed);
  if (failed || !fs::exists(file, failed))
    return {nothing_there(fs::absolute(path, failed))};
  for (const PluginFile& known : files_)
    if (known.path == file)
      return {};
  const FileBytes read = read_plugin_file(file);
  if (!read.problem.empty())
    return {read.problem};
  if (permission)
    if (const std::string why = refusal(*permission, file, read.bytes); !why.empty())
      return {not_opened(why, path)};
  if (std::string problem = shared_object_problem(read.bytes); !problem.empty())
    return {std::move(problem)};
  // whoever ends the program in there is named
  const EndGuard guard(2, [&](const std::string& done) {
    fmt::print(stderr, "{}: {} while it was being opened\n", shell_word(path), done);
  });
  note_plugin(file);
  // into a copy, so that of a plug-in that is refused nothing stays
  const std::string origin = file.filename();
  Registries registries = *registries_;
  Registrar registrar(registries, origin);
  OpenedPlugin opened;
  try {
    opened = open_plugin(file);  // some systems let through what a static object throws
    if (!opened.info)
      return {opened.problem};
    opened.info->add(registrar);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return {fmt::format("it failed while it was adding: {}", e.what())};
  } catch (...) {
    return {"it failed while it was adding"};
  }
  std::vector<std::string> problems = registrar.problems();
  for (std::string& problem : model_problems(registrar, source))
    problems.push_back(std::move(problem));
  if (!problems.empty())
    return problems;
  registries_ = std::make_shared<const Registries>(std::move(registries));
  for (const ModelText& model : registrar.models())
    source.add_model(model.kind, model.name, origin, model.yaml);
  files_.push_back({file, hash_of(read.bytes)});
  return {};
}

}  // namespace eyrie::scenario
