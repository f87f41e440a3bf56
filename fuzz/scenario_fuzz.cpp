// SPDX-License-Identifier: MIT
/// \file  Any text as a scenario, with the data and packages of this source tree at hand (short
/// ones for the two kinds that are long, fuzz/data): it is loaded and its first world is built, or
/// it is refused by a ConfigError that a terminal can show. Nothing else. A line "#set PATH=VALUE"
/// is also an override. Run it in the root of the source tree, or say where that is by EYRIE_HOME.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnostics.hpp"
#include "fuzz/demand.hpp"
#include "fuzz/line_mutator.hpp"
#include "scenario/data.hpp"
#include "scenario/scenario.hpp"

namespace {

using namespace eyrie;
using fuzz::demand;

constexpr const char* kFile = "scenarios/fuzzed.yaml";
constexpr const char* kPackage = "scenarios/packages/pilots.yaml";
constexpr const char* kShipped = "scenarios/sweep_phases.yaml";  ///< what may be extended
constexpr std::string_view kSet = "#set ";

std::map<std::string, std::string> g_files;

std::vector<std::string> sets_in(const std::string& text) {
  std::vector<std::string> sets;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(kSet))
      sets.push_back(line.substr(kSet.size()));
  return sets;
}

/// What a reader of YAML passes over costs time in every load.
std::string without_comments(const std::string& text) {
  std::string kept;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (const std::size_t comment = line.find("  #"); comment != line.npos)
      line.resize(comment);
    if (!line.starts_with('#'))
      kept += line + '\n';
  }
  return kept;
}

void check_refusal(const ConfigError& refusal) {
  demand(!refusal.diagnostics().ok());
  for (const char* c = refusal.what(); *c; ++c)
    demand(*c == '\n' || (static_cast<unsigned char>(*c) >= 0x20 && *c != 0x7f));
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* home = std::getenv("EYRIE_HOME");
  const std::string root = home ? home : ".";
  std::map<std::string, std::string> files;
  scenario::Source disk = scenario::Source::disk(root);
  for (const std::string_view kind : scenario::DataLoader::kinds()) {
    const auto small = disk.read(root + "/fuzz/data/" + std::string(kind) + ".yaml");
    for (const std::string& name : disk.data_names(kind)) {
      const std::string file = disk.data_name(kind, name);
      files[file] = without_comments(small ? *small : disk.read(file).value());
    }
  }
  const auto package = disk.read(root + "/" + kPackage), shipped = disk.read(root + "/" + kShipped);
  if (files.empty() || !package || !shipped) {
    std::fprintf(stderr, "no data and packages in '%s': set EYRIE_HOME\n", root.c_str());
    std::exit(2);
  }
  files[kPackage] = without_comments(*package);
  files[kShipped] = without_comments(*shipped);
  g_files = std::move(files);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  scenario::Source source = scenario::Source::bundle(g_files);
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
