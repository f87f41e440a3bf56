// SPDX-License-Identifier: MIT
/// \file  Any text as a scenario, with the data and packages of this source tree at hand: it is
/// loaded and its first world is built, or it is refused by a ConfigError that a terminal can show.
/// Nothing else. A line "#set PATH=VALUE" is also an override. Run it in the root of the source
/// tree, or say where that is by EYRIE_HOME.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnostics.hpp"
#include "fuzz/line_mutator.hpp"
#include "scenario/data.hpp"
#include "scenario/scenario.hpp"
#include "scenario/yaml.hpp"

namespace {

using namespace eyrie;

constexpr const char* kFile = "scenarios/fuzzed.yaml";
constexpr const char* kPackage = "scenarios/packages/pilots.yaml";
constexpr std::string_view kSet = "#set ";

std::shared_ptr<const std::map<std::string, std::string>> g_files;

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
  std::map<std::string, std::string> files;
  scenario::Source disk = scenario::Source::disk(root);
  for (const std::string_view kind : scenario::DataLoader::kinds())
    for (const std::string& name : disk.data_names(kind))
      files[disk.data_name(kind, name)] = disk.read(disk.data_name(kind, name)).value();
  const auto package = disk.read(root + "/" + kPackage);
  if (files.empty() || !package) {
    std::fprintf(stderr, "no data and packages in '%s': set EYRIE_HOME\n", root.c_str());
    std::exit(2);
  }
  files[kPackage] = *package;
  g_files = std::make_shared<const std::map<std::string, std::string>>(std::move(files));
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  Diagnostics diagnostics;
  const Value document = scenario::parse_yaml(text, kFile, diagnostics);
  demand(diagnostics.ok() || document.is_null());

  scenario::Source source = scenario::Source::shared(g_files);
  source.add(kFile, text);
  try {
    const auto loaded = scenario::load({kFile, sets_in(text)}, std::move(source));
    demand(loaded->start.has_value() && !loaded->roster.players.empty());
  } catch (const ConfigError& refusal) {
    check_refusal(refusal);
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

/// Every second time lines, otherwise bytes.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  if (seed % 2 == 0)
    return LLVMFuzzerMutate(data, size, most);
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  fuzz::LineMutator lines(text, seed / 2);
  const std::string mutated = lines.mutated(fuzz::LineMutator(text, seed));
  std::memcpy(data, mutated.data(), std::min(mutated.size(), most));
  return std::min(mutated.size(), most);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* left, std::size_t left_size,
                                                 const std::uint8_t* right, std::size_t right_size,
                                                 std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  fuzz::LineMutator lines({reinterpret_cast<const char*>(left), left_size}, seed);
  const std::string mutated =
      lines.mutated(fuzz::LineMutator({reinterpret_cast<const char*>(right), right_size}, seed));
  std::memcpy(out, mutated.data(), std::min(mutated.size(), most));
  return std::min(mutated.size(), most);
}
