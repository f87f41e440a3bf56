// SPDX-License-Identifier: MIT
#pragma once
#include "disk/sink.hpp"
#include "record/event_table.hpp"
#include "sim/system.hpp"

namespace eyrie::record {

/// A text as a cell of a CSV file (RFC 4180). Control characters and invalid UTF-8 become
/// \x1b-like escapes, so that a row is a line. A text that a spreadsheet would take for a formula,
/// as it begins with = + - @ (also full-width, also behind blanks), gets a ' in front.
[[nodiscard]] std::string csv_text(std::string_view text);
/// The same, always in quotes: a text where other rows have a number.
[[nodiscard]] std::string csv_quoted(std::string_view text);

/// Every committed event, a row each: docs/events.md describes the columns.
class EventsCsv final : public sim::Observer {
 public:
  EventsCsv(const scenario::Scenario& scenario, disk::Sink& sink);

  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;
  void finish(const sim::World& world) override;

 private:
  EventTable table_;
  disk::Sink& sink_;
  std::string out_;
};

}  // namespace eyrie::record
