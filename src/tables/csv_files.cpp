// SPDX-License-Identifier: MIT
#include "tables/csv_files.hpp"

#include <zlib.h>

#include <iterator>

#include "record/event_table.hpp"

namespace eyrie::tables {

struct TextFile::Stream {
  z_stream z{};
  std::string out = std::string(std::size_t{1} << 16, '\0');

  void pump(std::string_view text, int how, disk::Sink& sink) {
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    z.avail_in = static_cast<uInt>(text.size());
    do {
      z.next_out = reinterpret_cast<Bytef*>(out.data());
      z.avail_out = static_cast<uInt>(out.size());
      deflate(&z, how);
      sink.write({out.data(), out.size() - z.avail_out});
    } while (z.avail_out == 0);
  }
};

TextFile::TextFile(disk::Sink& sink, bool compressed) : sink_(sink) {
  constexpr int kGzip = 15 + 16, kMemory = 8;
  if (!compressed)
    return;
  stream_ = std::make_unique<Stream>();
  if (deflateInit2(&stream_->z, Z_BEST_COMPRESSION, Z_DEFLATED, kGzip, kMemory,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
}

TextFile::~TextFile() {
  if (stream_)
    deflateEnd(&stream_->z);
}

void TextFile::write(std::string_view text) {
  if (stream_)
    stream_->pump(text, Z_NO_FLUSH, sink_);
  else
    sink_.write(text);
}

void TextFile::finish() {
  if (stream_)
    stream_->pump({}, Z_FINISH, sink_);
}

namespace {

void put(const Cell& cell, std::string& row) {
  row += ',';
  if (const auto* number = std::get_if<double>(&cell))
    fmt::format_to(std::back_inserter(row), "{}", *number);
  else if (const auto* words = std::get_if<std::string>(&cell))
    row += record::csv_text(*words);
}

void put_names(std::span<const ActionColumn> columns, std::string& row) {
  for (const ActionColumn& column : columns)
    row += "," + record::csv_text(column.column);
  row += '\n';
}

std::string path_of(const debrief::Decision& d, ubf::NodeIndex node) {
  return node < d.nodes.size() ? record::csv_text(d.nodes[node].path) : "";
}

}  // namespace

bool write_decisions(const debrief::Recorded& recorded, const Selection& selection, TextFile& file,
                     const std::function<bool()>& stop) {
  const scenario::Scenario& scenario = *recorded.scenario;
  const std::vector<ActionColumn> columns = action_columns(scenario);
  std::string row(kDecisionColumns[0].name);
  for (const DecisionColumn& column : std::span(kDecisionColumns).subspan(1))
    row += fmt::format(",{}", column.name);
  put_names(columns, row);
  file.write(row);
  debrief::Reflight flight(recorded);
  Chooser chooser(selection, columns);
  const bool whole = each_decision(flight, scenario, chooser, stop, [&](const auto& d) {
    row = fmt::format("{:.3f},{},{},{},{},{},{},{},{}", d.time, d.step,
                      record::csv_text(scenario.roster.name(d.player)), record::csv_text(d.tree),
                      ubf::to_text(d.status), d.vote,
                      d.leader == ubf::kNone ? "" : record::csv_text(d.nodes[d.leader].label),
                      path_of(d, d.leader), record::csv_text(scenario.roster.name(d.attacks)));
    for (const Cell& cell : action_of(d, columns))
      put(cell, row);
    file.write(row += '\n');
  });
  file.finish();
  return whole;
}

bool write_answers(const debrief::Recorded& recorded, const Selection& selection, TextFile& file,
                   const std::function<bool()>& stop) {
  const scenario::Scenario& scenario = *recorded.scenario;
  const std::vector<ActionColumn> columns = action_columns(scenario);
  const double dt = scenario.simulation->dt();
  std::string row = "from_s,to_s,from_step,to_step,player,tree,node,status,vote,halts,why,hands_on";
  put_names(columns, row);
  file.write(row);
  struct Named {
    AnswerRow answer;
    std::string tree, node, hands_on;
    bool operator==(const Named&) const = default;
  };
  Intervals<std::pair<PlayerId, std::size_t>, Named> intervals;
  const auto done = [&](const auto& key, const auto& interval) {
    const AnswerRow& a = interval.row.answer;
    row = fmt::format(
        "{:.3f},{:.3f},{},{},{},{},{},{},{},{},{},{}", static_cast<double>(interval.from) * dt,
        static_cast<double>(interval.to) * dt, interval.from, interval.to,
        record::csv_text(scenario.roster.name(key.first)), interval.row.tree, interval.row.node,
        a.status, a.vote, a.halts, record::csv_text(a.why), interval.row.hands_on);
    for (const Cell& cell : a.action)
      put(cell, row);
    file.write(row += '\n');
  };
  struct Last {
    std::uint64_t step = 0;
    std::string tree;
    Answers answers;
  };
  std::map<PlayerId, Last> lasts;
  debrief::Reflight flight(recorded);
  Chooser chooser(selection, columns);
  const bool whole = each_decision(flight, scenario, chooser, stop, [&](const auto& d) {
    Last& last = lasts[d.player];
    const bool same_tree = last.tree == d.tree && last.answers.size() == d.nodes.size();
    Answers answers = answers_of(d, columns, same_tree ? &last.answers : nullptr);
    for (std::size_t i = 0; i < answers.size(); ++i)
      if (answers[i])
        intervals.see({d.player, i}, last.step, d.step,
                      {*answers[i], record::csv_text(d.tree), record::csv_text(d.nodes[i].path),
                       path_of(d, answers[i]->hands_on)},
                      done);
    last = {d.step, d.tree, std::move(answers)};
  });
  intervals.finish(done);
  file.finish();
  return whole;
}

}  // namespace eyrie::tables
