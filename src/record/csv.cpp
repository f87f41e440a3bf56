// SPDX-License-Identifier: MIT
#include "record/csv.hpp"

#include <iterator>

#include "core/text.hpp"
#include "model/events.hpp"

namespace eyrie::record {
namespace {

/// OWASP, "CSV injection" (2024); tabs and carriage returns are escapes already.
bool is_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  constexpr std::u32string_view kBegin = U"=+-@\uFF1D\uFF0B\uFF0D\uFF20";
  return !text.empty() && kBegin.find(first_character(text).point) != kBegin.npos;
}

std::string harmless(std::string_view text) {
  const std::string shown = printable(text);
  return is_formula(shown) ? '\'' + shown : shown;
}

std::string in_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text)
    quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace

std::string csv_text(std::string_view text) {
  std::string cell = harmless(text);
  return cell.find_first_of(",\";") == cell.npos ? cell : in_quotes(cell);
}

std::string csv_quoted(std::string_view text) {
  return in_quotes(harmless(text));
}

EventsCsv::EventsCsv(const scenario::Scenario& scenario, disk::Sink& sink)
    : scenario_(scenario), sink_(sink) {
  sink_.write("time_s,step,event,who,who_id,whom,whom_id,north_m,east_m,down_m,detail,values\n");
}

void EventsCsv::observe(const sim::World&, const sim::StepInfo& info,
                        std::span<const sim::Event> events) {
  for (const sim::Event& e : events) {
    const auto kind = static_cast<model::EventKind>(e.kind.value);
    const std::string_view name = model::event_name(kind);
    fmt::format_to(std::back_inserter(out_), "{:.2f},{},{},{},{},{},{},{:.2f},{:.2f},{:.2f},{},",
                   info.time() + info.dt, info.step, csv_text(name.empty() ? "?" : name),
                   csv_text(scenario_.roster.name(e.who)), e.who.value,
                   csv_text(scenario_.roster.name(e.whom)), e.whom.value, e.place.x, e.place.y,
                   e.place.z, e.detail);
    std::string values;
    for (const float* value = e.values.data();
         const std::string_view of : model::event_values(kind))
      fmt::format_to(std::back_inserter(values), "{}{}={:g}", values.empty() ? "" : " ", of,
                     *value++);
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
