// SPDX-License-Identifier: MIT
#include "record/run_file_writer.hpp"

namespace eyrie::record {
namespace {
constexpr std::size_t kChunk = 1 << 16;
}

RunFileWriter::RunFileWriter(disk::Sink& sink, const RunFile& run) : sink_(sink) {
  sink_.write(encoder_.head(run));
}

void RunFileWriter::observe(const sim::World& world, const sim::StepInfo& info,
                            std::span<const sim::Event> events) {
  trail_.observe(world, info, events);
  if (trail_.spans().size() >= kChunk)
    write_chunk();
}

void RunFileWriter::close(std::span<const sim::Order> orders, std::string_view outcome) {
  write_chunk();
  sink_.write(encoder_.tail(trail_.steps_per_second(), orders, outcome));
}

void RunFileWriter::write_chunk() {
  if (const std::string spans = trail_.take(); !spans.empty())
    sink_.write(encoder_.chunk(spans));
}

}  // namespace eyrie::record
