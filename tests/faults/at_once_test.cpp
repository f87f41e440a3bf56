// SPDX-License-Identifier: MIT
/// \file  Several processes want one place at the same moment: each run is kept, in a place of its
/// own that its process names, and what was there before is replaced by one of them at most.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "commands.hpp"
#include "faults/ground.hpp"
#include "record/run_file.hpp"

namespace eyrie::test {
namespace {

/// Processes that wait for each other when each is about to put its run in its place.
std::vector<Ran> fly_at_once(const Ground& ground, int count, const std::string& out, bool force) {
  int ready[2], go[2];
  EXPECT_EQ(::pipe(ready) + ::pipe(go), 0);
  std::vector<std::unique_ptr<Child>> children;
  for (int i = 0; i < count; ++i) {
    Fault fault;
    fault.files.before_first_move = [=] {
      char byte = 0;
      ::close(go[1]);
      EXPECT_EQ(::write(ready[1], &byte, 1), 1);
      EXPECT_EQ(::read(go[0], &byte, 1), 0);
    };
    children.push_back(std::make_unique<Child>(
        ground.path(),
        [=] {
          return app::fly({.scenario = "truck.yaml",
                           .seed = 100,
                           .sets = {"until=" + std::to_string(i + 1) + " s"},
                           .out = out,
                           .force = force});
        },
        fault));
  }
  ::close(ready[1]);
  char byte = 0;
  for (int i = 0; i < count; ++i)
    EXPECT_EQ(::read(ready[0], &byte, 1), 1);
  for (const int end : {ready[0], go[0], go[1]})
    ::close(end);
  std::vector<Ran> ran;
  for (const auto& child : children)
    ran.push_back(child->wait().ran);
  return ran;
}

/// Where each says that its run is; each is there, and its own.
std::set<std::string> places(const Ground& ground, const std::vector<Ran>& ran) {
  std::set<std::string> all;
  for (std::size_t i = 0; i < ran.size(); ++i) {
    std::smatch said;
    if (!std::regex_search(ran[i].out, said, std::regex("written to ([^:]*): run.eyrie"))) {
      ADD_FAILURE() << ran[i].out << ran[i].err;
      continue;
    }
    const std::string place = said[1];
    EXPECT_TRUE(all.insert(place).second) << place << " twice";
    const record::Decoded run = record::read_run_file(ground / (place + "/run.eyrie"));
    EXPECT_EQ(run.error, "");
    EXPECT_EQ(run.run.sets.at(0), "until=" + std::to_string(i + 1) + " s") << place;
  }
  return all;
}

std::ptrdiff_t with_code(const std::vector<Ran>& ran, int code) {
  return std::count_if(ran.begin(), ran.end(), [&](const Ran& r) { return r.code == code; });
}

class AtOnce : public testing::TestWithParam<int> {};

TEST_P(AtOnce, InOneNewPlace) {
  const Ground ground;
  const auto ran = fly_at_once(ground, GetParam(), "place", false);
  EXPECT_TRUE(places(ground, ran).contains("place"));
  EXPECT_EQ(with_code(ran, 0), 1);
  EXPECT_EQ(with_code(ran, 1), GetParam() - 1);
  for (const Ran& r : ran)
    EXPECT_EQ(r.code == 1,
              r.err.find("'place' has been taken or changed in the meantime; the new one is '") !=
                  std::string::npos)
        << r.err;
}

TEST_P(AtOnce, InOneEmptyFolder) {
  const Ground ground;
  const auto ran = fly_at_once(ground, GetParam(), "empty", false);
  EXPECT_TRUE(places(ground, ran).contains("empty"));
  EXPECT_EQ(with_code(ran, 0), 1);
}

TEST_P(AtOnce, OverOneRun) {
  const Ground ground;
  const auto ran = fly_at_once(ground, GetParam(), "run", true);
  EXPECT_TRUE(places(ground, ran).contains("run"));
  EXPECT_EQ(with_code(ran, 0), 1);
  EXPECT_EQ(with_code(ran, 1), GetParam() - 1);
}

TEST_P(AtOnce, InTheNextNumber) {
  const Ground ground;
  const auto ran = fly_at_once(ground, GetParam(), "", false);
  EXPECT_EQ(places(ground, ran).size(), static_cast<std::size_t>(GetParam()));
  EXPECT_EQ(with_code(ran, 0), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Processes, AtOnce, testing::Values(2, 4));

}  // namespace
}  // namespace eyrie::test
