// SPDX-License-Identifier: MIT
/// \file  Any text as a scenario, with the data and packages of this source tree at hand: it is
/// loaded and its first world is built, or it is refused by a ConfigError that a terminal can show.
/// Nothing else. A line "#set PATH=VALUE" is also an override. Run it in the root of the source
/// tree, or say where that is by EYRIE_HOME.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "scenario/data.hpp"
#include "scenario/scenario.hpp"
#include "scenario/yaml.hpp"

namespace {

using namespace eyrie;

constexpr const char* kFile = "scenarios/fuzzed.yaml";
constexpr const char* kPackage = "scenarios/packages/pilots.yaml";
constexpr std::string_view kSet = "#set ";

std::map<std::string, std::string> g_files;

void demand(bool condition) {
  if (!condition)
    std::abort();
}

std::vector<std::string> sets_in(const std::string& text) {
  std::vector<std::string> sets;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(kSet))
      sets.push_back(line.substr(kSet.size()));
  return sets;
}

void check_refusal(const ConfigError& refusal) {
  demand(!refusal.diagnostics().ok());
  for (const Diagnostic& one : refusal.diagnostics().sorted()) {
    demand(!one.message.empty());
    for (const char c : one.text())
      demand(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* home = std::getenv("EYRIE_HOME");
  const std::string root = home ? home : ".";
  scenario::Source disk = scenario::Source::disk(root);
  for (const std::string_view kind : scenario::DataLoader::kinds())
    for (const std::string& name : disk.data_names(kind))
      g_files[disk.data_name(kind, name)] = disk.read(disk.data_name(kind, name)).value();
  const auto package = disk.read(root + "/" + kPackage);
  if (g_files.empty() || !package) {
    std::fprintf(stderr, "no data and packages in '%s': set EYRIE_HOME\n", root.c_str());
    std::exit(2);
  }
  g_files[kPackage] = *package;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  Diagnostics diagnostics;
  const Value document = scenario::parse_yaml(text, kFile, diagnostics);
  demand(diagnostics.ok() || document.is_null());

  auto files = g_files;
  files[kFile] = text;
  try {
    const auto loaded =
        scenario::load({kFile, sets_in(text)}, scenario::Source::bundle(std::move(files)));
    demand(loaded->start.has_value() && !loaded->roster.players.empty());
  } catch (const ConfigError& refusal) {
    check_refusal(refusal);
  }
  return 0;
}
