// SPDX-License-Identifier: MIT
#pragma once
/// \file  The run file written while the run is being flown.
#include <deque>
#include <string>
#include <string_view>

#include "disk/sink.hpp"
#include "record/run_file.hpp"
#include "sim/system.hpp"

namespace eyrie::record {

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
  std::deque<End> ends_;  ///< the last ones that were written, or will be if nothing fails
};

}  // namespace eyrie::record
