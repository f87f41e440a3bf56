// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "record/event_table.hpp"
#include "support/acmi_reader.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

using Row = std::map<std::string, std::string>;

/// Plain comma-separated text: no field of ours holds a comma, a quote or a line end.
std::vector<Row> read_csv(const std::string& text) {
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (const std::string& line : split(text, '\n')) {
    if (line.empty())
      continue;
    const auto fields = split(line, ',');
    if (names.empty()) {
      names = fields;
      continue;
    }
    EXPECT_EQ(fields.size(), names.size()) << line;
    Row row;
    for (std::size_t i = 0; i < std::min(fields.size(), names.size()); ++i)
      row[names[i]] = fields[i];
    rows.push_back(std::move(row));
  }
  return rows;
}

TEST(EventsCsv, HoldsEveryEventAndCountsAsTheReportDoes) {
  const TempFolder folder;
  const Ran ran = run_program(folder, {"fly", "sweep", "--out", "run", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto report = nlohmann::json::parse(ran.out);
  const std::string text = read_text(folder / "run/events.csv");
  ASSERT_TRUE(
      text.starts_with("time_s,step,event,who,who_id,whom,whom_id,weapon,shooter,missile_id,"
                       "north_m,east_m,latitude_deg,longitude_deg,altitude_m,range_m,"));
  ASSERT_TRUE(text.ends_with('\n'));
  EXPECT_EQ(text.find('"'), std::string::npos);
  const auto rows = read_csv(text);
  ASSERT_FALSE(rows.empty());

  std::map<std::string, std::map<std::string, int>> count;  // side letter of who -> event
  double last = 0;
  for (const Row& row : rows) {
    bool known = false;
    for (std::uint16_t kind = 1; kind < static_cast<std::uint16_t>(model::EventKind::count); ++kind)
      known |= row.at("event") == model::event_name(static_cast<model::EventKind>(kind));
    EXPECT_TRUE(known) << row.at("event");
    const double time = acmi_number(row.at("time_s")), step = acmi_number(row.at("step"));
    EXPECT_NEAR(time, (step + 1) * 0.02, 1e-6) << "the time at the end of the step";
    EXPECT_GE(time, last);
    last = time;
    EXPECT_EQ(row.at("whom").empty(), row.at("whom_id").empty());
    for (const auto& [name, cell] : row) {
      EXPECT_FALSE(cell.starts_with("player ") || cell.starts_with("?")) << name << ": " << cell;
      if (name.ends_with("_m") || name.ends_with("_deg") || name.ends_with("_id")) {
        EXPECT_TRUE(cell.empty() || std::isfinite(acmi_number(cell))) << name;
      }
    }
    if (row.at("event") == "launch") {
      EXPECT_EQ(row.at("who"),
                row.at("weapon") + " #" + row.at("who_id") + " of " + row.at("shooter"));
      EXPECT_EQ(row.at("missile_id"), row.at("who_id"));
    }
    ++count[row.at("who").substr(0, 5)][row.at("event")];
    if (row.at("event") == "launch")
      ++count[row.at("shooter").substr(0, 5)]["shot"];
    if (row.at("event") == "kill")
      ++count[row.at("whom").substr(0, 5)]["killed"];
  }
  EXPECT_LE(last, report["sim_time_s"].get<double>() + 1e-6);
  for (const auto& [side, name] : {std::pair{"blue", "eagle"}, std::pair{"red", "bogey"}}) {
    auto& c = count[name];
    const auto& r = report["sides"][side];
    EXPECT_EQ(c["shot"] + c["gun_burst"], r["shots"]) << side;
    EXPECT_EQ(c["kill"], r["kills"]) << side;
    EXPECT_EQ(c["killed"] + c["crash"], r["losses"]) << side;
    EXPECT_EQ(c["home"], r["home"]) << side;
  }
  EXPECT_GT(count["eagle"]["shot"], 0);
  EXPECT_GT(count["eagle"]["phase"], 4);
  EXPECT_GT(count["eagle"]["in_charge"], 4);
  EXPECT_GT(count["eagle"]["contact"], 0);
}

TEST(EventsCsv, HasNoEndOfTheBurstThatEndsTheRunWhichCountsAsAShot) {
  const TempFolder folder;
  const Ran ran = run_program(
      folder, {"fly", "merge", "--seed", "4", "--no-debrief", "--out", "run", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  std::map<std::string, int> count;
  for (const Row& row : read_csv(read_text(folder / "run/events.csv"))) {
    const std::string& by = row.at("event") == "launch" ? row.at("shooter") : row.at("who");
    count[row.at("event")] += by == "bandit1";
    count[row.at("event") + " by " + row.at("weapon")] += 1;
  }
  EXPECT_EQ(count["kill by gun"], 1);
  EXPECT_EQ(nlohmann::json::parse(ran.out)["sides"]["red"]["shots"],
            count["launch"] + count["gun_burst"] + 1);
}

TEST(EventsCsv, HasNoColumnThatSqlKeepsForItself) {
  // reserved in SQL:2016, PostgreSQL 16 or MySQL 8, of the words that a simulation might use
  const std::set<std::string> reserved{
      "values", "order",  "from",  "to",    "group", "end",    "range", "time",   "timestamp",
      "rank",   "table",  "index", "by",    "where", "when",   "set",   "select", "value",
      "user",   "window", "row",   "rows",  "as",    "on",     "at",    "case",   "check",
      "column", "key",    "limit", "match", "of",    "offset", "out",   "over",   "primary",
      "start",  "system", "union", "using", "with",  "year",   "both",  "lead",   "lag"};
  for (const record::EventColumn& column : record::event_columns())
    EXPECT_FALSE(reserved.contains(std::string(column.name))) << column.name;
}

TEST(EventsPage, IsWhatTheProgramSays) {
  EXPECT_EQ(read_text("docs/events.md"), record::events_markdown())
      << "eyrie catalog --events > docs/events.md";
}

TEST(EventsPage, DescribesEveryKindAndEveryColumn) {
  const std::string page = record::events_markdown();
  for (const model::EventInfo& info : model::event_infos())
    EXPECT_NE(page.find(fmt::format("| `{}` | ", info.name)), page.npos) << info.name;
  for (const record::EventColumn& column : record::event_columns())
    EXPECT_NE(page.find(fmt::format("`{}`", column.name)), page.npos) << column.name;
}

}  // namespace
}  // namespace eyrie::test
