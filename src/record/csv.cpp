// SPDX-License-Identifier: MIT
#include "record/csv.hpp"

#include <fmt/format.h>

#include <iterator>

#include "core/text.hpp"

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
    : table_(scenario), sink_(sink) {
  for (const EventColumn& column : event_columns())
    fmt::format_to(std::back_inserter(out_), "{}{}", out_.empty() ? "" : ",", column.name);
  out_ += '\n';
}

void EventsCsv::observe(const sim::World&, const sim::StepInfo& info,
                        std::span<const sim::Event> events) {
  for (const sim::Event& e : events) {
    const std::vector<Cell> row = table_.row(e, info);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0)
        out_ += ',';
      if (const auto* number = std::get_if<double>(&row[i]))
        out_ += without_minus_zero(fmt::format(fmt::runtime(event_columns()[i].format), *number));
      else if (const auto* text = std::get_if<std::string>(&row[i]))
        out_ += csv_text(*text);
    }
    out_ += '\n';
  }
  if (out_.size() > 1 << 16) {
    sink_.write(out_);
    out_.clear();
  }
}

void EventsCsv::finish(const sim::World&) {
  sink_.write(out_);
  out_.clear();
}

}  // namespace eyrie::record
