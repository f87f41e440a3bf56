// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "model/events.hpp"
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
      text.starts_with("time_s,step,event,who,who_id,whom,whom_id,north_m,east_m,down_m,"
                       "detail,values\n"));
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
    EXPECT_EQ(row.at("whom").empty(), row.at("whom_id") == "0");
    for (const char* number : {"who_id", "north_m", "east_m", "down_m", "detail"})
      EXPECT_NO_THROW(static_cast<void>(acmi_number(row.at(number))));
    if (!row.at("values").empty())
      for (const std::string& pair : split(row.at("values"), ' ')) {
        const auto parts = split(pair, '=');
        ASSERT_EQ(parts.size(), 2U) << pair;
        EXPECT_NO_THROW(static_cast<void>(acmi_number(parts[1]))) << pair;
      }
    ++count[row.at("who").substr(0, 5)][row.at("event")];
    if (row.at("event") == "launch")  // detail: the shooter
      ++count[acmi_number(row.at("detail")) <= 4 ? "eagle" : "bogey"]["shot"];
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

}  // namespace
}  // namespace eyrie::test
