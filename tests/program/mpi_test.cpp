// SPDX-License-Identifier: MIT
/// \file  Campaigns over processes by real MPI, where it is installed.
#include <gtest/gtest.h>

#include <regex>

#include "support/program.hpp"

namespace eyrie::test {
namespace {

class Mpi : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v mpirun >/dev/null") != 0)
      GTEST_SKIP() << "there is no mpirun: Debian's openmpi-bin";
    const auto library = std::filesystem::path(program_path()).replace_filename("libeyrie_mpi.so");
    if (!std::filesystem::exists(library))
      GTEST_SKIP() << "the program was built without MPI: Debian's libopenmpi-dev";
    write(60);
  }
  void write(int replicates) const {
    folder.write("c.yaml", R"(eyrie: 1
name: merges
scenario: merge
factors:
  speed: {path: blue.flights.viper.start.speed, values: [400 kt, 480 kt]}
replicates: )" + std::to_string(replicates) +
                               R"(
measures:
  end: {what: end_time}
)");
  }
  /// A line of the shell, in the folder; $EYRIE is the program, $MPIRUN starts it in three
  /// processes.
  Ran shell(const std::string& line) const {
    const std::string whole = "cd " + folder.path().string() +
                              "; export EYRIE_HOME=" + source_root() + " EYRIE=" + program_path() +
                              " MPIRUN='mpirun --allow-run-as-root --oversubscribe -n 3'; { " +
                              line + "; } >out 2>err </dev/null";
    const int status = std::system(whole.c_str());
    return {WEXITSTATUS(status), read_text(folder / "out"), read_text(folder / "err")};
  }
  [[nodiscard]] std::string table(const std::string& out) const {
    return read_text(folder / out + "/results.csv");
  }
  TempFolder folder;
};

TEST_F(Mpi, GivesTheTableOfOneProcess) {
  const Ran alone = shell("$EYRIE campaign c.yaml --out alone --workers 1");
  ASSERT_EQ(alone.code, 0) << alone.err;
  const Ran ranks = shell("$MPIRUN $EYRIE campaign c.yaml --out ranks");
  ASSERT_EQ(ranks.code, 0) << ranks.err;
  EXPECT_EQ(table("ranks"), table("alone"));
  std::smatch hash;
  ASSERT_TRUE(std::regex_search(alone.out, hash, std::regex("campaign hash 0x[0-9a-f]{16}")));
  EXPECT_NE(ranks.out.find(hash[0]), std::string::npos) << ranks.out;
}

TEST_F(Mpi, GoesOnAfterARankWasKilled) {
  write(400);
  const Ran killed = shell(
      "$MPIRUN $EYRIE campaign c.yaml --out killed & until [ -s killed/results.db ]; do sleep "
      "0.05; "
      "done; for p in /proc/[0-9]*; do [ \"$(readlink $p/cwd)\" = $PWD ] && "
      "grep -q OMPI_COMM_WORLD_RANK=2 $p/environ && kill -9 ${p#/proc/}; done; wait $!");
  EXPECT_NE(killed.code, 0);
  const Ran resumed = shell("$MPIRUN $EYRIE campaign c.yaml --out killed --resume");
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  ASSERT_EQ(shell("$EYRIE campaign c.yaml --out alone").code, 0);
  EXPECT_EQ(table("killed"), table("alone"));
}

TEST_F(Mpi, SaysAMistakeOnce) {
  folder.write("c.yaml", "eyrie: 1\nnme: x\n");
  const Ran ran = shell("$MPIRUN $EYRIE campaign c.yaml");
  EXPECT_EQ(ran.code, 2);
  const auto first = ran.err.find("did you mean 'name'?");
  EXPECT_NE(first, std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.find("did you mean 'name'?", first + 1), std::string::npos) << ran.err;
}

TEST_F(Mpi, SaysWhatIsMissing) {
  const Ran ran = shell("OMPI_COMM_WORLD_RANK=0 EYRIE_MPI=/nowhere.so $EYRIE campaign c.yaml");
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(ran.err.starts_with(
      "eyrie: mpirun has started this (OMPI_COMM_WORLD_RANK is set), but /nowhere.so: "))
      << ran.err;
}

}  // namespace
}  // namespace eyrie::test
