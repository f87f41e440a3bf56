// SPDX-License-Identifier: MIT
/// \file  How a plug-in is opened: the part of Plugins that needs a system with shared libraries.
#include <cxxabi.h>
#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <set>

#include "core/text.hpp"
#include "scenario/data.hpp"
#include "scenario/end_guard.hpp"
#include "scenario/plugin_file.hpp"
#include "scenario/plugins.hpp"

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
    if (std::ranges::find(kinds, model.kind) == kinds.end())
      problems.push_back(fmt::format("there is no kind of model {}{}", quote(model.kind),
                                     did_you_mean(model.kind, kinds)));
    else if (!is_identifier(model.name))
      problems.push_back(fmt::format("{} is no name for a model", quote(model.name)));
    else if (std::ranges::binary_search(names->second, model.name))
      problems.push_back(fmt::format("there is already a model {} ({})", quote(model.name),
                                     source.data_name(model.kind, model.name)));
    else if (!before.emplace(model.kind, model.name).second)
      problems.push_back(fmt::format("it adds the model {} twice", quote(model.name)));
  }
  return problems;
}

std::string demangled(const std::string& symbol) {
  int failed = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &failed), &std::free);
  return failed == 0 && name ? name.get() : symbol;
}

/// What the dynamic linker says begins with the file it speaks of: ours, or one that ours needs.
std::string words_for(std::string_view said, const std::string& path) {
  if (said.starts_with(path + ": "))
    said.remove_prefix(path.size() + 2);
  else if (const auto colon = said.find(": "); said.find("cannot open shared") != said.npos)
    return fmt::format("it needs {}, which is not there", said.substr(0, colon));
  constexpr std::string_view kUndefined = "undefined symbol: ";
  if (said.starts_with(kUndefined)) {
    const std::string symbol(said.substr(kUndefined.size(), said.find(',') - kUndefined.size()));
    return fmt::format("it uses {}, which is nowhere; eyrie_add_plugin links what it needs",
                       quote(demangled(symbol)));
  }
  if (said == "file too short" || said == "invalid ELF header")
    return "it is not a shared library";
  return std::string(said);
}

/// Why a plug-in does not fit this program; empty if it does.
std::string misfit(const PluginInfo& info) {
  if (info.magic != kPluginMagic)
    return "its eyrie_plugin was not made by EYRIE_PLUGIN";
  if (info.format != kPluginFormat)
    return "it was built for another version of Eyrie; build it again";
  if (std::string_view(info.version) != kVersion)
    return fmt::format("it was built for Eyrie {}, this is {}; build it again", info.version,
                       kVersion);
  if (info.layout != plugin_layout())
    return "it was built with other headers of Eyrie than this program; build it again";
  return info.add ? "" : "it has nothing to add";
}

/// Opens the file at an absolute path and, if it was made for this program, lets it add; otherwise
/// gives why not, and of its code only the constructors of its static objects have run.
std::string open_plugin(const std::string& path, Registrar& registrar) {
  // all symbols now: what is missing is found here and not in the middle of a step
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library)
    return words_for(::dlerror(), path);
  const auto* info = static_cast<const PluginInfo*>(::dlsym(library, "eyrie_plugin"));
  if (!info)
    return "it is not a plug-in: there is no EYRIE_PLUGIN in it";
  std::string problem = misfit(*info);
  if (problem.empty())
    info->add(registrar);
  return problem;
}

}  // namespace

std::vector<std::string> Plugins::load(const std::string& path, Source& source,
                                       const PluginPermission* permission) {
  std::error_code failed;
  const fs::path file = fs::weakly_canonical(path, failed);
  if (failed || !fs::exists(file, failed))
    return {"there is no such file" + (permission ? "" : disk::nearest_file(path))};
  for (const PluginFile& known : files_)
    if (known.path == file)
      return {};
  const disk::FileRead read = read_allowed(file, permission, path);
  if (!read.problem.empty())
    return {read.problem};
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
  try {  // some systems let through what a static object throws
    if (std::string problem = open_plugin(file, registrar); !problem.empty())
      return {std::move(problem)};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return {fmt::format("it failed while it was adding: {}", e.what())};
  } catch (...) {
    return {"it failed while it was adding"};
  }
  std::vector<std::string> problems = registrar.problems();
  std::ranges::move(name_problems(registries, origin), std::back_inserter(problems));
  std::ranges::move(model_problems(registrar, source), std::back_inserter(problems));
  if (!problems.empty())
    return problems;
  registries_ = std::make_shared<const Registries>(std::move(registries));
  for (const ModelText& model : registrar.models())
    source.add_model(model.kind, model.name, origin, model.yaml);
  files_.push_back({file, hash_of(read.bytes)});
  return {};
}

}  // namespace eyrie::scenario
