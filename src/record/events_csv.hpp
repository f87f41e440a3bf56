// SPDX-License-Identifier: MIT
#pragma once
/// \file  events.csv: every committed event, one row each.
#include <fmt/format.h>

#include "disk/sink.hpp"
#include "scenario/scenario.hpp"
#include "sim/system.hpp"

namespace eyrie::record {

/// Columns: time_s, step, event, who, who_id, whom, whom_id, north_m, east_m, down_m, detail,
/// values. `values` holds `name=value` pairs separated by blanks, named as the schema names them.
class EventsCsv final : public sim::Observer {
 public:
  EventsCsv(const scenario::Scenario& scenario, disk::Sink& sink);

  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;
  void finish(const sim::World& world) override;

 private:
  const scenario::Scenario& scenario_;
  disk::Sink& sink_;
  fmt::memory_buffer out_;
};

}  // namespace eyrie::record
