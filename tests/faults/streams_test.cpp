// SPDX-License-Identifier: MIT
/// \file  Streams, signals and places as a shell gives them to the real program.
#include <gtest/gtest.h>
#include <signal.h>

#include "faults/ground.hpp"

namespace eyrie::test {
namespace {

using List = std::vector<std::string>;

/// A script for sh, in which $E is the program.
Ran shell(const Ground& ground, const std::string& script, const RunOptions& options = {}) {
  const TempFolder streams;
  const std::string all = "cd '" + ground.path().string() + "' && E='" + program_path() +
                          "' && export EYRIE_HOME='" + options.home + "' EYRIE_VIEWER='" +
                          options.viewer + "' && (" + script + ") >'" + (streams / "out") +
                          "' 2>'" + (streams / "err") + "'";
  const int status = std::system(all.c_str());
  return {WEXITSTATUS(status), read_text(streams / "out"), read_text(streams / "err")};
}

TEST(Streams, OutputThatCannotBeWrittenIsAnErrorOfEveryCommand) {
  const Ground ground;
  for (const char* command :
       {"fly truck.yaml --out made", "fly truck.yaml --out json --json", "validate truck.yaml",
        "replay run", "replay run --json", "explain run --player truck1",
        "explain run --player truck1 --csv", "diff run run", "catalog", "export run --to czml",
        "debrief run", "--help", "--version", "fly --help",
        "whatif run --player truck1 --set root/navigate.speed='20 km/h'"})
    for (const auto& [to, why] : {std::pair(">/dev/full", "No space left on device"),
                                  std::pair(">&-", "Bad file descriptor")}) {
      const Ran ran = shell(ground, std::string("rm -rf made json; $E ") + command + " " + to);
      EXPECT_EQ(ran.code, 1) << command << to;
      EXPECT_NE(ran.err.find("eyrie: cannot write to standard output: "), std::string::npos)
          << command << to << ran.err;
      const std::string_view words = command;
      if (!words.starts_with("-") && !words.ends_with("--help")) {
        EXPECT_NE(ran.err.find(why), std::string::npos) << command << to << ran.err;
      }
      if (words.starts_with("fly truck")) {
        EXPECT_TRUE(std::filesystem::exists(ground / "made/run.eyrie") ||
                    std::filesystem::exists(ground / "json/run.eyrie"))
            << command << to;
      }
    }
}

/// No file that is opened becomes standard output.
TEST(Streams, ClosedOnesStayClosed) {
  const Ground ground;
  const Ran ran = shell(ground, "$E fly truck.yaml --out made <&- >&- 2>&-");
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(read_text(ground / "made/run.eyrie").substr(0, 5), "EYRIE");
  EXPECT_EQ(shell(ground, "$E replay made").code, 0);
  EXPECT_EQ(read_text(ground / "made/events.csv").substr(0, 7), "time_s,");
}

TEST(Streams, AReaderWhoGoesDoesNotEndAFlight) {
  const Ground ground;
  const Ran ran = shell(ground, "{ $E fly truck.yaml --out made; echo $? >code; } | true");
  EXPECT_EQ(read_text(ground / "code"), "141\n");
  EXPECT_EQ(ran.err, "");
  EXPECT_TRUE(read_text(ground / "made/run.eyrie") == read_text(ground / "run/run.eyrie"));
}

/// Whoever follows a flight reads each line when it is told: it is there although the process was
/// killed before it came to its end.
TEST(Streams, TheStoryComesLineByLine) {
  const Try fly = every_try().front();
  const Ground ground;
  Fault fault;
  fault.files.at = done(fly).ended.calls / 2;
  fault.files.signal = SIGKILL;
  const Ended ended = Child(ground.path(), fly.command, fault).wait();
  EXPECT_TRUE(ended.ran.out.starts_with("truck\nseed 2")) << ended.ran.out;
}

TEST(Streams, SignalsThatWereIgnoredStayIgnored) {
  const Ground ground;
  const Try fly = every_try().front();
  for (const int signal : {SIGHUP, SIGINT}) {
    Fault fault;
    fault.files.at = done(fly).ended.calls / 3;
    fault.files.signal = signal;
    ::signal(signal, SIG_IGN);
    const Ended ended = Child(ground.path(), fly.command, fault).wait();
    ::signal(signal, SIG_DFL);
    EXPECT_EQ(ended.ran.code, 0) << ended.ran.err;
    std::filesystem::remove_all(ground / "deep");
  }
}

/// A flight that succeeded is kept, whatever becomes of what stands beside it.
TEST(Streams, AFlightIsKeptWithoutItsPage) {
  const Ground ground;
  ASSERT_EQ(::mkfifo((ground / "pipe").c_str(), 0600), 0);
  for (const char* viewer : {"/etc/passwd", "/dev/zero", "/", "pipe"}) {
    const Ran ran =
        shell(ground, "rm -rf made; $E fly truck.yaml --quiet --out made", {.viewer = viewer});
    EXPECT_EQ(ran.code, 1) << viewer;
    EXPECT_TRUE(ran.err.starts_with("eyrie: ")) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_NE(ran.out.find("written to made: run.eyrie, events.csv, flight.acmi\n"),
              std::string::npos)
        << ran.out;
    EXPECT_EQ(shell(ground, "$E replay made").code, 0) << viewer;
  }
}

TEST(Streams, AFlightOfAFileWithAStrangeNameIsKept) {
  const Ground ground;
  const Ran ran =
      shell(ground, "f=$(printf 'bad\\377.yaml'); cp truck.yaml $f; $E fly $f --quiet --out made");
  EXPECT_LE(ran.code, 1);
  EXPECT_EQ(ran.err.find("json"), std::string::npos) << ran.err;
  EXPECT_EQ(shell(ground, "$E replay made").code, 0);
}

TEST(Streams, OnlyFilesAreReplacedByFiles) {
  const Ground ground;
  ASSERT_EQ(::mkfifo((ground / "pipe").c_str(), 0600), 0);
  const Tree before = ground.tree();
  for (const char* target :
       {"pipe", "empty", "link", "/dev/null", "none/file", "important/below", "."})
    for (const char* command : {"export run --to czml", "debrief run"}) {
      const Ran ran = shell(ground, std::string("$E ") + command + " --force --out " + target);
      EXPECT_EQ(ran.code, 2) << command << target;
      EXPECT_TRUE(ran.err.starts_with("eyrie: ")) << ran.err;
      EXPECT_NE(ran.err.find(target), std::string::npos) << ran.err;
    }
  EXPECT_TRUE(ground.tree() == before);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(Streams, OnlyTheFolderOfARunIsReplacedByOne) {
  const Ground ground;
  ground.write("run/thesis.tex", "kept");
  const Tree before = ground.tree();
  for (const char* target : {".", "..", "/", "other", "important", "link", "run", "run/.", "run/..",
                             "important/below"}) {
    const Ran ran = shell(ground, std::string("$E fly truck.yaml --force --out ") + target);
    EXPECT_EQ(ran.code, 2) << target;
    EXPECT_EQ(ran.out, "") << "nothing is flown that could not be written";
    EXPECT_NE(ran.err.find(target), std::string::npos) << ran.err;
  }
  EXPECT_TRUE(ground.tree() == before);
}

}  // namespace
}  // namespace eyrie::test
