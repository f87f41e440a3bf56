// SPDX-License-Identifier: MIT
/// \file  No file runs code: a plug-in that a scenario or a run file names is opened only if the
/// user has typed it or trusts it.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "record/run_file.hpp"
#include "scenario/plugin_file.hpp"
#include "support/plugin.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {
namespace fs = std::filesystem;

const std::string kScenario = R"(eyrie: 1
name: small
plugins: [libgood.so]
reference: {latitude: 33 deg, longitude: -68 deg}
until: 2 s
trees: {pilot: {last_word: [navigate, hold_course]}}
blue:
  flights:
    eagle:
      aircraft: f16c
      tree: pilot
      players: [eagle1]
      start: {north: 0 nmi, east: 0 nmi, altitude: 20000 ft, heading: 90 deg, speed: 450 kt}
)";

class Trust : public testing::Test {
 protected:
  Trust() {
    folder.write("small.yaml", kScenario);
    fs::copy(plugin("good"), folder / "libgood.so");
  }
  [[nodiscard]] Ran run(const std::vector<std::string>& arguments) const {
    return run_program(folder, arguments, {.config = config.path()});
  }
  void fly() const {
    const Ran ran = run(
        {"fly", "small.yaml", "--plugin", "libgood.so", "--out", "run", "--quiet", "--no-debrief"});
    ASSERT_EQ(ran.code, 0) << ran.err;
  }
  [[nodiscard]] std::string library() const { return fs::canonical(folder / "libgood.so"); }
  [[nodiscard]] std::string list() const { return config / "eyrie/trusted-plugins"; }

  TempFolder folder, config;
};

std::string words(const std::string& why, const std::string& path) {
  return "it was not opened: " + why + "; add '--plugin " + path +
         "', or trust it with 'eyrie trust " + path + "'\n";
}

/// Everything that opens a recorded run.
const std::vector<std::vector<std::string>> kReaders{
    {"replay", "run"},
    {"explain", "run", "--player", "eagle1", "--at", "1"},
    {"whatif", "run", "--player", "eagle1", "--set", "root.vote=3"},
    {"debrief", "run", "--out", "page.html"},
    {"export", "run", "--to", "czml", "--out", "x.czml"},
    {"diff", "run", "run"}};

TEST_F(Trust, NoRunFileRunsCode) {
  fly();
  const auto before = folder.everything();
  for (const auto& reader : kReaders) {
    const Ran ran = run(reader);
    EXPECT_EQ(ran.code, 2) << reader[0];
    EXPECT_EQ(ran.out, "") << reader[0];
    EXPECT_TRUE(ran.err.starts_with("run/run.eyrie: the run needs the plug-in " + library() + ": " +
                                    words("it is not trusted", library())))
        << ran.err;
    EXPECT_EQ(folder.everything(), before);
  }
}

TEST_F(Trust, EveryReaderOfRunsOpensWhatWasTypedOrIsTrusted) {
  fly();
  for (auto reader : kReaders) {
    reader.insert(reader.end(), {"--plugin", "libgood.so"});
    EXPECT_NE(run(reader).code, 2) << reader[0] << run(reader).err;
    for (const char* made : {"page.html", "x.czml"})
      fs::remove(folder / made);
  }
  ASSERT_EQ(run({"trust", "libgood.so"}).code, 0);
  for (const auto& reader : kReaders)
    EXPECT_EQ(run(reader).err.find("not opened"), std::string::npos) << reader[0];
  EXPECT_EQ(run({"replay", "run"}).code, 0);
}

TEST_F(Trust, NoScenarioRunsCode) {
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"validate", "small.yaml"}, {"fly", "small.yaml"}}) {
    const Ran ran = run(command);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err,
              "small.yaml:3:11: plug-in 'libgood.so': " + words("it is not trusted", "libgood.so"));
    EXPECT_FALSE(fs::exists(folder / "runs"));
  }
  ASSERT_EQ(run({"trust", "libgood.so"}).code, 0);
  EXPECT_EQ(run({"validate", "small.yaml"}).code, 0);
}

TEST_F(Trust, IsForAPathAndItsContent) {
  fly();
  const Ran trusted = run({"trust", "libgood.so"});
  EXPECT_EQ(trusted.out, "trusted: " + library() + "\n");
  EXPECT_EQ(run({"replay", "run"}).code, 0);
  // the same bytes elsewhere
  folder.write("other/small.yaml", kScenario);
  fs::copy(library(), folder / "other/libgood.so");
  EXPECT_EQ(run({"validate", "other/small.yaml"}).code, 2);
  // other bytes there
  std::ofstream(library(), std::ios::binary | std::ios::app) << "x";
  EXPECT_EQ(run({"replay", "run"}).err,
            "run/run.eyrie: the run needs the plug-in " + library() + ": " +
                words("it has other bytes than when it was trusted", library()));
  EXPECT_EQ(run({"validate", "small.yaml"}).code, 2);
  EXPECT_NE(run({"trust", "--list"}).out.find("  (has changed)\n"), std::string::npos);
  ASSERT_EQ(run({"trust", "libgood.so"}).code, 0) << "as it is now";
  EXPECT_EQ(run({"validate", "small.yaml"}).code, 0);
  const std::string line = read_text(list());
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1) << line;
}

TEST_F(Trust, IsShownAndTakenBack) {
  EXPECT_EQ(run({"trust", "--list"}).out, "");
  ASSERT_EQ(run({"trust", "libgood.so", plugin("greet")}).code, 0);
  const Ran shown = run({"trust", "--list"});
  EXPECT_EQ(shown.out, read_text(list()));
  EXPECT_NE(shown.out.find("  " + library() + "\n"), std::string::npos) << shown.out;
  const std::string was = library();
  const Ran none = run({"trust", "--remove", "libgoo.so"});
  EXPECT_EQ(none.code, 2);
  EXPECT_EQ(none.err, "eyrie: trust --remove 'libgoo.so': it is not trusted; did you mean '" +
                          library() + "'?\n");
  fs::rename(library(), folder / "gone.so");  // what is not there any more can be taken back, too
  EXPECT_EQ(run({"trust", "--remove", "libgood.so"}).out, "no longer trusted: " + was + "\n");
  fs::rename(folder / "gone.so", was);
  EXPECT_EQ(run({"validate", "small.yaml"}).code, 2);
  EXPECT_EQ(read_text(list()).find("libgood"), std::string::npos);
}

TEST_F(Trust, TakesAllOrNothing) {
  folder.write("half.so", read_text(library()).substr(0, 5000));
  const std::string foreign = plugin("foreign"), huge(5000, 'x');
  for (const auto& wrong :
       std::vector<std::string>{"nowhere.so", "half.so", "small.yaml", ".", foreign, huge}) {
    const Ran ran = run({"trust", "libgood.so", wrong});
    EXPECT_EQ(ran.code, 2) << wrong;
    EXPECT_TRUE(ran.err.starts_with("eyrie: trust " + quote_path(wrong) + ": ")) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_FALSE(fs::exists(list()));
  }
  EXPECT_EQ(run({"trust"}).code, 2);
  EXPECT_EQ(run({"trust", "libgood.so", "--list"}).code, 2);
  const Ran homeless = run_program(folder, {"trust", "libgood.so"});
  EXPECT_EQ(homeless.code, 2);
  EXPECT_EQ(homeless.err,
            "eyrie: neither XDG_CONFIG_HOME nor HOME is an absolute path: there is no list\n");
}

TEST_F(Trust, BelievesNoListThatOthersMayHaveWrittenOrThatIsDamaged) {
  ASSERT_EQ(run({"trust", "libgood.so"}).code, 0);
  const std::string good = read_text(list());
  const auto refused = [&](const std::string& why) {
    const Ran ran = run({"validate", "small.yaml"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("not opened: " + list() + why), std::string::npos) << ran.err;
    for (const std::string ask : {"--list", "libgood.so"}) {
      const Ran said = run({"trust", ask});
      EXPECT_EQ(said.code, 2);
      EXPECT_TRUE(said.err.starts_with(list() + why)) << said.err;
    }
  };
  ASSERT_EQ(::chmod(list().c_str(), 0620), 0);
  refused(": others may write to it; what it trusts is not trusted (chmod go-w " + list() + ")");
  ASSERT_EQ(::chmod(list().c_str(), 0600), 0);
  const auto damaged = [&](const std::string& text, const std::string& why) {
    std::ofstream(list(), std::ios::binary) << text;
    refused(why);
    EXPECT_EQ(read_text(list()), text) << "left as it is";
  };
  const std::string form =
      "expected a SHA-256 (64 small hexadecimal digits), two spaces and a path";
  damaged(good + "libgood.so\n", ":2:1: " + form);
  damaged("X" + good.substr(1), ":1:1: " + form);
  damaged(good.substr(0, 65) + library() + "\n", ":1:1: " + form);
  damaged(good.substr(0, good.size() - 1), ":1:1: the line has no end");
  damaged(good + good, ":2:1: this path stands there twice");
  damaged(good.substr(0, 66) + "libgood.so\n", ":1:1: 'libgood.so' is not an absolute path");
  damaged(good.substr(0, 66) + "/a\x1b[2J.so\n", ":1:1: '/a\\x1b[2J.so' is not an absolute path");
  std::ofstream(list(), std::ios::binary) << good;
  EXPECT_EQ(run({"validate", "small.yaml"}).code, 0);
}

TEST_F(Trust, NeverLooksWhereOneStandsForWhatARunFileNames) {
  fly();
  ASSERT_EQ(run({"trust", "libgood.so"}).code, 0);
  record::RunFile file = record::read_run_file(folder / "run/run.eyrie").run;
  const auto refused = [&](const std::string& path, const std::string& why) {
    file.plugins[0].path = path;
    folder.write("other.eyrie", record::encode(file));
    const Ran ran = run({"replay", "other.eyrie"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, "other.eyrie: the run needs the plug-in " + why);
    EXPECT_EQ(run({"replay", "other.eyrie", "--plugin", "libgood.so"}).code, 0);
  };
  refused("libgood.so",
          "libgood.so, at no absolute path; --plugin (in Python plugins=) says where it is\n");
  refused("./x\x1b]0;/libgood.so",
          "$'./x\\x1b]0;/libgood.so', at no absolute path; --plugin (in Python plugins=) says "
          "where it is\n");
  refused("/nowhere/libgood.so",
          "/nowhere/libgood.so, which is not there; --plugin (in Python plugins=) says where it is "
          "now\n");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  fs::create_directory(folder / "sub");
  ASSERT_EQ(::mkfifo((folder / "sub/libgood.so").c_str(), 0600), 0);
  const std::string pipe = folder / "sub/libgood.so";
  refused(pipe, pipe + ": it was not opened: it is not trusted; add '--plugin " + pipe +
                    "', or trust it with 'eyrie trust " + pipe + "'\n");
}

TEST(ShellWord, MayBeTypedAndShown) {
  EXPECT_EQ(scenario::shell_word("/a/b-1.so"), "/a/b-1.so");
  EXPECT_EQ(scenario::shell_word("it's a file"), "'it'\\''s a file'");
  EXPECT_EQ(scenario::shell_word("a\n\x1b'\\"), "$'a\\x0a\\x1b\\'\\\\'");
  EXPECT_EQ(scenario::shell_word(""), "''");
}

}  // namespace
}  // namespace eyrie::test
