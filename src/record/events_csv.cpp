// SPDX-License-Identifier: MIT
#include "record/events_csv.hpp"

#include <iterator>

namespace eyrie::record {

EventsCsv::EventsCsv(const scenario::Scenario& scenario, disk::Sink& sink)
    : scenario_(scenario), sink_(sink) {
  sink_.write("time_s,step,event,who,who_id,whom,whom_id,north_m,east_m,down_m,detail,values\n");
}

void EventsCsv::observe(const sim::World& world, const sim::StepInfo& info,
                        std::span<const sim::Event> events) {
  for (const sim::Event& e : events) {
    const sim::EventInfo* known = world.schema().event(e.kind);
    fmt::format_to(std::back_inserter(out_), "{:.2f},{},{},{},{},{},{},{:.2f},{:.2f},{:.2f},{},",
                   info.time() + info.dt, info.step, known ? known->name : "?",
                   scenario_.roster.name(e.who), e.who.value, scenario_.roster.name(e.whom),
                   e.whom.value, e.place.x, e.place.y, e.place.z, e.detail);
    for (std::size_t i = 0; known && i < known->values.size(); ++i)
      fmt::format_to(std::back_inserter(out_), "{}{}={:g}", i ? " " : "", known->values[i].name,
                     e.values[i]);
    out_.push_back('\n');
  }
  if (out_.size() > 1 << 16) {
    sink_.write({out_.data(), out_.size()});
    out_.clear();
  }
}

void EventsCsv::finish(const sim::World&) {
  sink_.write({out_.data(), out_.size()});
  out_.clear();
}

}  // namespace eyrie::record
