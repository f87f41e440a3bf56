// SPDX-License-Identifier: MIT
#pragma once
/// \file  The run file: everything that a run was made from, and the hashes that it went through.
#include <deque>

#include "core/hash.hpp"
#include "disk/sink.hpp"
#include "scenario/plugin_file.hpp"
#include "scenario/scenario.hpp"
#include "sim/event.hpp"
#include "sim/system.hpp"
#include "sim/trail.hpp"

namespace eyrie::record {

/// Version of the format, the only one that is read.
inline constexpr std::uint32_t kRunFileVersion = 3;

/// Enough to fly a run again on any machine and to tell where it differs. The texts of all files
/// are inside, so nothing on the disk of the replaying machine matters but plug-ins.
struct RunFile {
  // known before the flight
  std::string build;                         ///< of the program that recorded it
  std::string scenario;                      ///< the file that was flown, a key of `files`
  std::map<std::string, std::string> files;  ///< name -> text: scenario, includes and data
  std::vector<std::string> sets;             ///< overrides, as given
  std::uint64_t seed = 0;
  std::uint64_t layout_hash = 0;  ///< of the schema
  std::vector<scenario::PluginFile> plugins;
  // known after it
  sim::HashTrail trail;
  std::vector<sim::Order> orders;
  std::string outcome;  ///< one line for people

  friend bool operator==(const RunFile& a, const RunFile& b);
};

/// What is known of a run before it is flown by a program that calls itself `build`.
[[nodiscard]] RunFile run_file_of(const scenario::Scenario& scenario, std::uint64_t seed,
                                  std::string build);

/// The bytes of a run file, part by part, so that it can be written while the run is being flown:
/// magic "EYRIERUN", version, byte-order mark and what is known before; the trail in chunks, each
/// behind its size, up to a chunk of size 0; what is known afterwards; XXH3 of all that.
class RunEncoder {
 public:
  [[nodiscard]] std::string head(const RunFile& run);
  /// Whole spans, at least one.
  [[nodiscard]] std::string chunk(std::string_view spans);
  [[nodiscard]] std::string tail(std::uint32_t steps_per_second, std::span<const sim::Order> orders,
                                 std::string_view outcome);

 private:
  std::string hashed(std::string bytes);
  Hasher hasher_;
};

/// All of it at once.
[[nodiscard]] std::string encode(const RunFile& run);

/// A run, or why there is none: `error` is empty exactly if `run` is good.
struct Decoded {
  RunFile run;
  std::string error;
};

/// Never throws for bad bytes and never allocates more than they could hold. The error says whether
/// they are foreign, of another version or byte order, cut, or corrupt.
[[nodiscard]] Decoded decode(std::string_view bytes);

/// Reads and decodes; the error then also covers what is missing, unreadable, larger than 1 GB or
/// no file at all.
[[nodiscard]] Decoded read_run_file(const std::string& path);

// The run file written while the run is being flown.

/// Writes into a sink, which must outlive it: what is known before the flight when it is made, the
/// trail as it comes, a chunk at a time, and the rest on close(). Keeps no more than a chunk.
class RunFileWriter final : public sim::Observer {
 public:
  /// Of `run` only what is known before the flight.
  RunFileWriter(disk::Sink& sink, const RunFile& run);

  void begin(const sim::World& world, double dt) override { trail_.begin(world, dt); }
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;
  /// The run ends here, wherever that is.
  void finish(const sim::World& world) override { trail_.finish(world); }

  /// After finish(): the file is whole then. To be called once; the sink says whether it worked. If
  /// not everything could be written, the run ends where there is room for its end, and the words
  /// for that are given; else "".
  [[nodiscard]] std::string close(std::span<const sim::Order> orders, std::string_view outcome);
  /// After that: s, where the run ends in the file if that is not where it ended.
  [[nodiscard]] std::optional<double> kept_until() const { return kept_until_; }

 private:
  /// Where the run could end in the file.
  struct End {
    std::uint64_t size = 0;
    RunEncoder encoder;
    std::uint64_t step = 0;
  };
  void write_chunk();

  disk::Sink& sink_;
  RunEncoder encoder_;
  sim::TrailRecorder trail_;
  std::optional<double> kept_until_;
  std::deque<End> ends_;  ///< the last ones that were written, or will be if nothing fails
};

// Every name that Eyrie gives to a file in the folder of a run. A folder that has another
// one is not replaced.

inline constexpr const char* kRunFileName = "run.eyrie";
inline constexpr const char* kEventsName = "events.csv";
inline constexpr const char* kFlightName = "flight.acmi";
inline constexpr const char* kPageName = "debrief.html";
inline constexpr const char* kPageOfTwoName = "debrief-two.html";
inline constexpr const char* kCzmlName = "run.czml";
inline constexpr const char* kGeojsonName = "run.geojson";
inline constexpr const char* kDecisionsName = "decisions.csv.gz";
inline constexpr const char* kAnswersName = "answers.csv.gz";
inline constexpr const char* kDatabaseName = "run.sqlite";
inline constexpr const char* kPcapName = "run.pcap";

inline constexpr std::array kRunFolderNames{
    kRunFileName, kEventsName,    kFlightName,  kPageName,     kPageOfTwoName, kCzmlName,
    kGeojsonName, kDecisionsName, kAnswersName, kDatabaseName, kPcapName,      "decisions.csv"};

}  // namespace eyrie::record
