// SPDX-License-Identifier: MIT
/// \file  Any texts as names in tables: a reader of RFC 4180 finds as many cells in every row, each
/// text as a terminal shows it, and none that a spreadsheet takes for a formula.
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.hpp"
#include "debrief/decision.hpp"
#include "fuzz/memory_file.hpp"
#include "fuzz/recorded_flight.hpp"
#include "record/event_table.hpp"
#include "tables/csv_files.hpp"

namespace {

using namespace eyrie;
using fuzz::demand, fuzz::demand_same;
using Row = std::vector<std::string>;

/// RFC 4180, and stricter: rows end with LF, quotes stand at the ends of a cell or are doubled.
std::vector<Row> read(std::string_view text) {
  std::vector<Row> rows;
  while (!text.empty()) {
    Row row;
    for (char end = ','; end == ',';) {
      std::string cell;
      std::size_t i = 0;
      if (text[0] == '"') {
        for (i = 1; text.at(i) != '"' || (i + 1 < text.size() && text[i + 1] == '"'); ++i)
          cell += text[text[i] == '"' ? i++ : i];
        ++i;
      } else {
        for (; text.at(i) != ',' && text[i] != '\n'; ++i) {
          demand(text[i] != '"' && text[i] != '\r');
          cell += text[i];
        }
      }
      end = text.at(i);
      demand(end == ',' || end == '\n');
      text.remove_prefix(i + 1);
      row.push_back(std::move(cell));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

bool is_number(const std::string& text) {
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failed == std::errc{} && end == text.data() + text.size();
}

std::vector<Row> expect_table(const std::string& text) {
  const std::vector<Row> rows = read(text);
  demand(rows.size() > 1);
  for (const Row& row : rows) {
    demand(row.size() == rows[0].size());
    for (const std::string& cell : row)
      demand(printable(cell) == cell &&
             (cell.empty() || cell.find_first_of("=+-@") != 0 || is_number(cell)));
  }
  return rows;
}

void expect_text(const std::string& cell, const std::string& text) {
  const std::string shown = printable(text);
  demand_same(cell, cell.starts_with('\'') ? '\'' + shown : shown);
}

struct Tables {
  std::vector<Row> events, decisions, answers;
};
Tables written_with(fuzz::Texts texts) {
  fuzz::flight().rename(texts);
  const debrief::Recorded recorded = fuzz::recorded(texts);
  const auto table = [&](auto write) {
    return expect_table(fuzz::written_by([&](disk::Sink& sink) {
      tables::TextFile file(sink, false);
      write(recorded, tables::Selection{}, file, [] { return false; });
    }));
  };
  return {expect_table(fuzz::written<record::EventsCsv>()), table(tables::write_decisions),
          table(tables::write_answers)};
}

void expect_same(const std::vector<Row>& rows, const std::vector<Row>& plain,
                 const fuzz::Texts& texts) {
  demand(rows.size() == plain.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t cell = 0; cell < rows[i].size(); ++cell)
      expect_text(fuzz::without_numbers(rows[i][cell]),
                  fuzz::without_numbers(texts.in(plain[i].at(cell))));
}

debrief::Decision decision_of(fuzz::Texts& texts) {
  debrief::Decision d;
  d.player = PlayerId{1};
  d.tree = texts.next();
  for (int i = 0; i < 3; ++i) {
    debrief::Answer answer;
    answer.label = texts.next();
    answer.path = texts.next();
    answer.why = texts.next();
    answer.asked = true;
    answer.action.push_back({.name = "mode", .unit = "", .number = {}, .text = texts.next()});
    d.nodes.push_back(std::move(answer));
  }
  return d;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  static_cast<void>(fuzz::flight());
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Tables plain = written_with({});
  fuzz::Texts texts(data, size);
  const Tables tables = written_with(texts);
  demand(tables.events.size() == 1 + fuzz::flight().events());
  expect_same(tables.events, plain.events, texts);
  expect_same(tables.decisions, plain.decisions, texts);
  // nodes of one name may answer the same for longer
  if (tables.answers.size() == plain.answers.size())
    expect_same(tables.answers, plain.answers, texts);
  demand(tables.answers.size() <= plain.answers.size());

  const scenario::Roster& roster = fuzz::flight().scenario().roster;
  const debrief::Decision decision = decision_of(texts);
  const std::vector<Row> rows =
      expect_table(std::string(debrief::kDecisionCsv) + debrief::decision_csv(decision, roster));
  demand(rows.size() == 1 + decision.nodes.size());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const debrief::Answer& node = decision.nodes[i - 1];
    expect_text(rows[i][2], roster.players[0].name);
    expect_text(rows[i][3], decision.tree);
    expect_text(rows[i][4], node.path);
    if (node.action[0].text != "-")
      expect_text(rows[i][8], node.action[0].text);
  }
  // and what people read of it
  for (const std::string& text :
       {debrief::decision_text(decision, roster), debrief::decision_line(decision)})
    demand(printable_lines(text) == text);
  return 0;
}
