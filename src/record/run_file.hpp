// SPDX-License-Identifier: MIT
#pragma once
/// \file  The run file: everything that a run was made from, and the hashes that it went through.
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/plugin_file.hpp"
#include "sim/order.hpp"
#include "sim/trail.hpp"

namespace eyrie::record {

/// Version of the format that encode() writes: that of a run without plug-ins, and of one with
/// them. decode() accepts both.
inline constexpr std::uint32_t kRunFileVersion = 1, kRunFileWithPlugins = 2;

/// Enough to fly a run again on any machine and to tell where it differs. The texts of all files
/// are inside, so nothing on the disk of the replaying machine matters but plug-ins.
struct RunFile {
  std::string build;                         ///< of the program that recorded it
  std::string scenario;                      ///< the file that was flown, a key of `files`
  std::map<std::string, std::string> files;  ///< name -> text: scenario, includes and data
  std::vector<std::string> sets;             ///< overrides, as given
  std::uint64_t seed = 0;
  double until = 0;               ///< s, the hard end that was in force
  std::uint64_t layout_hash = 0;  ///< of the schema
  std::vector<sim::Order> orders;
  sim::HashTrail trail;
  std::string outcome;  ///< one line for people
  std::vector<scenario::PluginFile> plugins;

  friend bool operator==(const RunFile& a, const RunFile& b);
};

/// The bytes of a run file: magic "EYRIERUN", version, byte-order mark, sections, XXH3 of all that.
[[nodiscard]] std::string encode(const RunFile& run);

/// A run, or why there is none: `error` is empty exactly if `run` is good.
struct Decoded {
  RunFile run;
  std::string error;
};

/// Never throws for bad bytes and never allocates more than they could hold. The error says whether
/// they are foreign, of another version or byte order, cut, or corrupt.
[[nodiscard]] Decoded decode(std::string_view bytes);

/// Reads and decodes; the error then also covers a file that is missing or unreadable.
[[nodiscard]] Decoded read_run_file(const std::string& path);

}  // namespace eyrie::record
