// SPDX-License-Identifier: MIT
#include "scenario/shared_library.hpp"

#include <cxxabi.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <string_view>

namespace eyrie::scenario {
namespace {

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

}  // namespace

OpenedPlugin open_plugin(const std::string& path) {
  // all symbols now: what is missing is found here and not in the middle of a step
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library)
    return {nullptr, words_for(::dlerror(), path)};
  const auto* info = static_cast<const PluginInfo*>(::dlsym(library, "eyrie_plugin"));
  if (!info)
    return {nullptr, "it is not a plug-in: there is no EYRIE_PLUGIN in it"};
  std::string problem = misfit(*info);
  return {problem.empty() ? info : nullptr, std::move(problem)};
}

}  // namespace eyrie::scenario
