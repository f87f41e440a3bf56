// SPDX-License-Identifier: MIT
#include "record/events_csv.hpp"

#include <iterator>

#include "record/csv.hpp"

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
                   info.time() + info.dt, info.step, csv_text(known ? known->name : "?"),
                   csv_text(scenario_.roster.name(e.who)), e.who.value,
                   csv_text(scenario_.roster.name(e.whom)), e.whom.value, e.place.x, e.place.y,
                   e.place.z, e.detail);
    std::string values;
    for (std::size_t i = 0; known && i < known->values.size(); ++i)
      fmt::format_to(std::back_inserter(values), "{}{}={:g}", i ? " " : "", known->values[i].name,
                     e.values[i]);
    fmt::format_to(std::back_inserter(out_), "{}\n", csv_text(values));
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
