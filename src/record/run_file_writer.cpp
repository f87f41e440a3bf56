// SPDX-License-Identifier: MIT
#include "record/run_file_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace eyrie::record {
namespace {
constexpr std::size_t kChunk = 1 << 12;
constexpr std::size_t kEnds = 32;  // more than a sink holds back
}  // namespace

RunFileWriter::RunFileWriter(disk::Sink& sink, const RunFile& run) : sink_(sink) {
  sink_.write(encoder_.head(run));
}

void RunFileWriter::observe(const sim::World& world, const sim::StepInfo& info,
                            std::span<const sim::Event> events) {
  trail_.observe(world, info, events);
  if (trail_.spans().size() >= kChunk)
    write_chunk();
}

std::string RunFileWriter::close(std::span<const sim::Order> orders, std::string_view outcome) {
  write_chunk();
  sink_.write(encoder_.tail(trail_.steps_per_second(), orders, outcome));
  std::string lost;
  for (; !sink_.flush() && !ends_.empty(); ends_.pop_back()) {
    End& end = ends_.back();
    const std::string error = sink_.error();
    if (!sink_.cut(end.size))
      continue;
    const auto later = std::find_if(orders.begin(), orders.end(),
                                    [&](const sim::Order& o) { return o.step >= end.step; });
    sink_.write(end.encoder.tail(trail_.steps_per_second(), {orders.begin(), later}, outcome));
    lost =
        fmt::format("{}; the run is kept up to {} s", error, end.step / trail_.steps_per_second());
  }
  return sink_.error().empty() ? lost : "";
}

void RunFileWriter::write_chunk() {
  const std::string spans = trail_.take();
  if (spans.empty())
    return;
  sink_.write(encoder_.chunk(spans));
  if (!sink_.error().empty())
    return;
  ends_.push_back({sink_.size(), encoder_, trail_.last_step()});
  if (ends_.size() > kEnds)
    ends_.pop_front();
}

}  // namespace eyrie::record
