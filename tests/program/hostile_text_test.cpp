// SPDX-License-Identifier: MIT
/// \file  Texts that other programs could take for more than texts, through every command: each
/// output is read by a reader of its format that shares nothing with the writer.
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/text.hpp"
#include "record/run_file.hpp"
#include "support/acmi_reader.hpp"
#include "support/plugin.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

using nlohmann::json;

/// What a scenario calls its things.
struct Texts {
  std::string help, model, phase, node;
};
/// Nothing in them cannot be printed.
const Texts kPrintable{.help = "one, \"two\"; C:\\data\\",
                       .model = "=HYPERLINK(\"http://x\",\"F-15\")|\\",
                       .phase = "=1+1,\"in\"|-2",
                       .node = "@SUM(1;2),\xE9\xB7\xB2\\"};
const Texts kControls{.help = "\x1b]0;PWNED\a\x1b[2Jhelp\n#9\n-1\\",
                      .model = "\x1b[31mF-15\r\n0,Title=forged",
                      .phase = "p\n-1\n#5\x7f\t",
                      .node =
                          "\xE2\x80\xAEnode\xC2\x9B"
                          "2J\x1b[8m"};

std::string quoted(const std::string& text) {
  return json(text).dump(-1, ' ', true);  // YAML knows the same escapes
}

std::string scenario_of(const Texts& t) {
  return "eyrie: 1\nname: hostile\nhelp: " + quoted(t.help) +
         "\nreference: {latitude: 33 deg, longitude: -68 deg}\nuntil: 4 s\n"
         "data: {aircraft: {odd: {base: f15c, label: " +
         quoted(t.model) +
         "}}}\ntrees:\n  pilot:\n    sequencer:\n      start: " + quoted(t.phase) +
         "\n      trees:\n        " + quoted(t.phase) +
         ": {selector: [{navigate: {vote: 10, name: " + quoted(t.node) +
         "}}]}\n        then: {navigate: {vote: 20}}\n"
         "      transitions: [{from: any, to: then, when: time > 2 s}]\n"
         "blue:\n  flights:\n    eagle:\n      aircraft: odd\n      tree: pilot\n"
         "      players: [eagle1, eagle2]\n"
         "      start: {north: 0 nmi, east: 0 nmi, altitude: 20000 ft, heading: 90 deg, "
         "speed: 450 kt}\n"
         "      route: [{north: 0 nmi, east: 90 nmi, altitude: 20000 ft}]\n";
}

/// Every command that shows anything of a run or a scenario.
const std::vector<std::vector<std::string>> kCommands{
    {"validate", "hostile.yaml"},
    {"fly", "hostile.yaml", "--no-debrief", "--out", "again"},
    {"fly", "hostile.yaml", "--no-debrief", "--out", "json", "--json"},
    {"replay", "run"},
    {"replay", "run", "--json"},
    {"explain", "run", "--player", "eagle1"},
    {"explain", "run", "--player", "eagle1", "--json"},
    {"explain", "run", "--player", "eagle1", "--at", "1"},
    {"explain", "run", "--player", "eagle1", "--from", "1", "--to", "3"},
    {"explain", "run", "--player", "eagle1", "--from", "1", "--to", "3", "--json"},
    {"explain", "run", "--player", "eagle1", "--from", "1", "--to", "3", "--csv"},
    {"explain", "run", "--player", "eagle1", "--event", "phase"},
    {"explain", "run", "--player", "nobody"},
    {"whatif", "run", "--player", "eagle1", "--set",
     "trees.pilot.sequencer.trees.then.navigate.vote=5"},
    {"whatif", "run", "--player", "eagle1", "--set",
     "trees.pilot.sequencer.trees.then.navigate.vote=5", "--branch", "--seeds", "2", "--json"},
    {"whatif", "run", "--player", "eagle1", "--set", "root/nowhere.vote=5"},
    {"diff", "run", "again"},
    {"diff", "run", "again", "--json"},
    {"debrief", "run", "--out", "page.html", "--force"},
    {"export", "run", "--to", "czml", "--out", "run.czml", "--force"},
    {"export", "run", "--to", "geojson", "--out", "run.geojson", "--force"},
    {"export", "run", "--to", "decisions", "--out", "decisions.csv", "--force"},
    {"export", "run", "--to", "answers", "--out", "answers.csv", "--force"},
    {"export", "run", "--to", "sqlite", "--out", "run.sqlite", "--force"},
    {"export", "run", "--to", "pcap", "--out", "run.pcap", "--force"},
};

void expect_clean(const std::string& output, const std::string& what) {
  for (const std::string& line : split(output, '\n'))
    EXPECT_TRUE(printable(line) == line) << what << ": " << printable(line);
}

/// What Python says of it: another reader of the format.
std::string python(const std::string& program, const std::vector<std::string>& arguments) {
  std::string command = "python3 -c '" + program + "'";
  for (const std::string& argument : arguments)
    command += " '" + argument + "'";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"),
                                                             ::pclose);
  std::string said;
  for (int c = 0; (c = std::fgetc(pipe.get())) != EOF;)
    said += static_cast<char>(c);
  return said;
}

/// Rows as JSON; dies of a file that is not CSV or not UTF-8.
json csv_rows(const std::string& file) {
  return json::parse(python(R"(
import csv, json, sys
with open(sys.argv[1], newline="", encoding="utf-8") as file:
    print(json.dumps(list(csv.reader(file, strict=True)))))",
                            {file}));
}

bool is_number(const std::string& text) {
  try {
    return std::isfinite(acmi_number(text));
  } catch (const std::runtime_error&) {
    return false;
  }
}

void expect_table(const json& rows) {
  ASSERT_GT(rows.size(), 5u);
  for (const json& row : rows) {
    EXPECT_EQ(row.size(), rows[0].size()) << row;
    for (const json& cell : row) {
      const auto text = cell.get<std::string>();
      EXPECT_TRUE(text.find_first_of("=+-@\t\r") != 0 || is_number(text)) << text;
    }
  }
}

/// Whether any text of a JSON value is or holds `wanted`.
bool holds(const json& value, const std::string& wanted) {
  if (value.is_string())
    return value.get<std::string>().find(wanted) != std::string::npos;
  return value.is_structured() && std::any_of(value.begin(), value.end(), [&](const json& inner) {
           return holds(inner, wanted);
         });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}
/// As docs/formats.md states it.
std::string in_acmi(const std::string& text, bool event = false) {
  const std::string fit = replaced(text, "\\", "\xEF\xBC\xBC");
  return event ? replaced(fit, "|", "\xEF\xBD\x9C") : fit;
}

class HostileTexts : public testing::Test {
 protected:
  Ran fly(const Texts& texts) {
    folder.write("hostile.yaml", scenario_of(texts));
    return run_program(folder, {"fly", "hostile.yaml", "--no-debrief", "--out", "run"});
  }
  TempFolder folder;
};

TEST_F(HostileTexts, AreReadBackFromTacviewAsTheyAre) {
  const Ran ran = fly(kPrintable);
  ASSERT_EQ(ran.code, 0) << ran.err;
  const Acmi file(read_text(folder / "run/flight.acmi"));
  EXPECT_EQ(file.globals.at("Comments"), in_acmi(kPrintable.help));
  EXPECT_EQ(acmi_number(file.globals.at("ReferenceLongitude")), -68);
  ASSERT_EQ(file.objects.size(), 2u);
  for (const auto& [id, object] : file.objects) {
    EXPECT_EQ(object.last("Name"), in_acmi(kPrintable.model));
    EXPECT_EQ(object.updates[1].properties.at("UbfWinner"), in_acmi(kPrintable.node));
    EXPECT_EQ(object.last("UbfWinner"), "then");
    EXPECT_FALSE(object.removed);
  }
  std::size_t phases = 0;
  for (const AcmiEvent& e : file.events)
    phases += e.type == "Message" && e.parts.size() == 2 &&
              e.parts[1] == "eagle1: " + in_acmi(kPrintable.phase, true);
  EXPECT_EQ(phases, 1u);
}

TEST_F(HostileTexts, AreReadBackFromTablesAndAreNoFormulas) {
  const Ran ran = fly(kPrintable);
  ASSERT_EQ(ran.code, 0) << ran.err;
  expect_table(csv_rows(folder / "run/events.csv"));
  for (const char* format : {"decisions", "answers"})
    ASSERT_EQ(run_program(folder, {"export", "run", "--to", format, "--out",
                                   folder / (std::string("run/") + format + ".csv")})
                  .code,
              0);
  folder.write("explained.csv",
               run_program(folder, {"explain", "run", "--player", "eagle1", "--csv"}).out);
  for (const char* name : {"run/decisions.csv", "run/answers.csv", "explained.csv"}) {
    const json rows = csv_rows(folder / name);
    expect_table(rows);
    EXPECT_TRUE(holds(rows, "/" + kPrintable.phase + "/" + kPrintable.node)) << name;
  }
}

/// By Python, which refuses what is no UTF-8.
TEST_F(HostileTexts, AreReadBackFromTheDatabase) {
  const Ran ran = fly(kPrintable);
  ASSERT_EQ(ran.code, 0) << ran.err;
  ASSERT_EQ(run_program(folder, {"export", "run", "--to", "sqlite"}).code, 0);
  const json read = json::parse(python(R"(
import json, sqlite3, sys
run = sqlite3.connect(sys.argv[1])
tables = [name for (name,) in run.execute("SELECT name FROM sqlite_schema WHERE sql IS NOT NULL")]
print(json.dumps([run.execute(f"SELECT * FROM {name}").fetchall() for name in tables])))",
                                       {folder / "run/run.sqlite"}));
  EXPECT_TRUE(holds(read, "root/" + kPrintable.phase + "/" + kPrintable.node));
  EXPECT_TRUE(holds(read, kPrintable.model));
}

TEST_F(HostileTexts, AreReadBackFromJson) {
  const Ran ran = fly(kPrintable);
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const char* format : {"czml", "geojson"}) {
    const std::string file = folder / (std::string("run.") + format);
    ASSERT_EQ(run_program(folder, {"export", "run", "--to", format, "--out", file}).code, 0);
    const json read = json::parse(python(
        R"(import json, sys; print(json.dumps(json.load(open(sys.argv[1], encoding="utf-8")))))",
        {file}));
    EXPECT_TRUE(holds(read, kPrintable.node)) << format;
    EXPECT_TRUE(holds(read, kPrintable.model)) << format;
  }
  const Ran said = run_program(
      folder, {"explain", "run", "--player", "eagle1", "--from", "1", "--to", "3", "--json"});
  EXPECT_TRUE(holds(json::parse(said.out), "root/" + kPrintable.phase + "/" + kPrintable.node));
}

/// They may be refused when the scenario is loaded; then that is said as cleanly.
TEST_F(HostileTexts, ReachNoTerminal) {
  for (const Texts& texts : {kPrintable, kControls}) {
    const Ran flown = fly(texts);
    EXPECT_TRUE(flown.code == 0 || flown.code == 2) << flown.code;
    for (const auto& command : kCommands) {
      const Ran ran = run_program(folder, command);
      std::string what;
      for (const std::string& word : command)
        what += word + ' ';
      EXPECT_TRUE(ran.code >= 0 && ran.code <= 2) << what;
      expect_clean(ran.out, what);
      expect_clean(ran.err, what);
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
      std::filesystem::remove_all(entry.path());
  }
}

TEST_F(HostileTexts, OfARunFileReachNoTerminalAndStopNoDebrief) {
  ASSERT_EQ(fly(kPrintable).code, 0);
  record::RunFile run = record::read_run_file(folder / "run/run.eyrie").run;
  run.build = "eyrie \x1b[2J\n9.9 \xff";
  run.outcome = "\x1b]0;x\a \xC3 lost";
  run.layout_hash += 1;
  std::filesystem::create_directory(folder / "other");
  folder.write("other/run.eyrie", record::encode(run));
  const Ran refused = run_program(folder, {"replay", "other"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("another layout"), std::string::npos) << refused.err;
  expect_clean(refused.err, "replay");
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;

  run.layout_hash -= 1;
  folder.write("other/run.eyrie", record::encode(run));
  for (auto command : kCommands) {
    std::replace(command.begin(), command.end(), std::string("run"), std::string("other"));
    const Ran ran = run_program(folder, command);
    EXPECT_TRUE(ran.code >= 0 && ran.code <= 2) << command[0] << ": " << ran.err;
    EXPECT_EQ(ran.err.find("json"), std::string::npos) << ran.err;
    expect_clean(ran.out + ran.err, command[0]);
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "page.html"));
}

TEST_F(HostileTexts, OfAPluginReachNoTerminal) {
  const auto clean = [&](std::vector<std::string> command, bool flown = true) {
    const Ran ran = run_program(folder, command);
    EXPECT_TRUE(ran.code == 0 || (!flown && ran.code == 2)) << command[0] << ": " << ran.err;
    expect_clean(ran.out + ran.err, command[0]);
    return ran;
  };
  const std::string library = plugin("hostile");
  for (const char* format : {"", "--markdown", "--json-schema"}) {
    std::vector<std::string> command{"catalog", "--plugin", library};
    if (*format)
      command.push_back(format);
    clean(std::move(command));
  }
  folder.write("odd.yaml", replaced(replaced(scenario_of(kPrintable), "{navigate: {vote: 20}}",
                                             "{selector: [odd, {navigate: {vote: 20}}]}"),
                                    "aircraft: odd\n", "aircraft: f16c\n"));
  clean({"fly", "odd.yaml", "--plugin", library, "--out", "run"});
  const Ran why = clean({"explain", "run", "--player", "eagle1", "--at", "3", "--plugin", library});
  EXPECT_NE(why.out.find(R"(failed: \x1b[31mbecause,\x0a=1+1)"), std::string::npos) << why.out;
  clean({"explain", "run", "--player", "eagle1", "--at", "3", "--json", "--plugin", library});
  // its model has a label that no scenario may have
  folder.write("odd.yaml",
               replaced(scenario_of(kPrintable), "aircraft: odd\n", "aircraft: odd_fighter\n"));
  clean({"fly", "odd.yaml", "--plugin", plugin("hostile_model"), "--out", "odd"}, false);
}

/// The column in which the answers of a tree begin.
TEST_F(HostileTexts, LeaveTheTablesStraight) {
  Texts wide = kPrintable;
  wide.node = "\xE9\xB7\xB2\xE9\xB7\xB2 \xC3\xA9t\xC3\xA9";
  ASSERT_EQ(fly(wide).code, 0);
  const std::string out =
      run_program(folder, {"explain", "run", "--player", "eagle1", "--at", "1"}).out;
  std::set<std::size_t> begins;
  for (const std::string& line : split(out.substr(out.find("\ntree\n")), '\n'))
    if (const auto at = line.find("  running, votes"); at != line.npos)
      begins.insert(columns(line.substr(0, at)));
  EXPECT_EQ(begins.size(), 1u) << out;
  EXPECT_NE(out.find(wide.node), std::string::npos);
}

}  // namespace
}  // namespace eyrie::test
