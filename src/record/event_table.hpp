// SPDX-License-Identifier: MIT
#pragma once
/// \file  Events as rows of a table, with names instead of numbers: for whoever wants cells, as
/// CSV, and the page that describes them.
#include <variant>

#include "disk/sink.hpp"
#include "record/names.hpp"
#include "sim/system.hpp"

namespace eyrie::record {

struct EventColumn {
  std::string_view name;  ///< "range_m"
  std::string_view help;
  std::string_view format = "";  ///< of its numbers in a text, such as "{:.3f}"; "": words
};
/// As its name ends: "m", "s", "deg", "kg", or "" for none.
[[nodiscard]] std::string_view unit_of(const EventColumn& column);

/// Nothing, a number or words.
using Cell = std::variant<std::monostate, double, std::string>;

/// The columns of every table of events: when, what, who, whom, which missile and where, then each
/// value that an event of any kind carries.
[[nodiscard]] const std::vector<EventColumn>& event_columns();

/// Makes the rows of one run, event after event.
class EventTable {
 public:
  explicit EventTable(const scenario::Scenario& scenario)
      : scenario_(scenario), missiles_(scenario) {}

  /// To be told every event that no row is made of: who a missile was.
  void note(const sim::Event& e) { missiles_.note(e); }
  /// A cell for each column. Words are as files gave them.
  [[nodiscard]] std::vector<Cell> row(const sim::Event& e, const sim::StepInfo& info);
  /// One of its values: a number as in that column, or what it stands for.
  [[nodiscard]] Cell value(const sim::Event& e, const model::EventValue& what, float number) const;

 private:
  const scenario::Scenario& scenario_;
  Missiles missiles_;
};

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

/// docs/events.md
[[nodiscard]] std::string events_markdown();

}  // namespace eyrie::record
