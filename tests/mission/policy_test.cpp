// SPDX-License-Identifier: MIT
/// \file  Whole flights by a learned behavior: the file goes with the run, and the bits are the
/// same.
#include <gtest/gtest.h>

#include "core/text.hpp"
#include "record/run_file.hpp"
#include "scenario/mission.hpp"
#include "support/pilot/networks.hpp"
#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

using scenario::Source;

std::string flown_by_policy(const std::string& file) {
  return changed_scenario(
      {{"until: 2 s", "until: 30 s"},
       {"navigate: {vote: 10, speed: 480 kt}", "policy: {file: " + file + ", vote: 50}"}});
}

std::shared_ptr<const scenario::Scenario> loaded(const TempFolder& folder) {
  folder.write("small.safetensors", pilot::testing::small_policy_file());
  const std::string file = folder.write("small.yaml", flown_by_policy("small.safetensors"));
  Source source = Source::disk(".");
  source.confine_to_folder_of(file);
  return scenario::load({file, {}}, source);
}

std::uint64_t flown(const std::shared_ptr<const scenario::Scenario>& scenario, unsigned workers) {
  scenario::Mission mission(scenario, 1, scenario->spec.until, {.workers = workers});
  mission.fly();
  return mission.run().world().hash();
}

TEST(Policies, FlyToTheSameBitsForAnyWorkersAndFromTheRunFile) {
  const TempFolder folder;
  const auto scenario = loaded(folder);
  const std::uint64_t hash = flown(scenario, 1);
  EXPECT_EQ(hash_text(hash), "0x5439dff471f264bf") << "a change of behavior says why";
  for (const unsigned workers : {2U, 8U})
    EXPECT_EQ(flown(scenario, workers), hash) << workers;
  const auto run = record::run_file_of(*scenario, 1, "test");
  for (const auto& [name, text] : run.files)
    EXPECT_EQ(text_problem(text.substr(0, text.find('\n'))), std::nullopt) << name;
  EXPECT_EQ(flown(scenario::load({run.scenario, run.sets}, Source::bundle(run.files)), 1), hash);
}

TEST(Policies, AreReadLikeOtherFiles) {
  const TempFolder folder;
  const auto mistakes = [&](const std::string& name) -> std::string {
    const std::string file = folder.write("small.yaml", flown_by_policy(name));
    Source source = Source::disk(".");
    source.confine_to_folder_of(file);
    try {
      static_cast<void>(scenario::load({file, {}}, source));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(mistakes("small.safetensor").find("cannot read"), std::string::npos);
  EXPECT_NE(mistakes("/etc/hostname").find("is outside the folder of the scenario"),
            std::string::npos);
  folder.write("cut.safetensors", pilot::testing::small_policy_file().substr(0, 3000));
  EXPECT_NE(mistakes("cut.safetensors").find("tensor '"), std::string::npos);
  folder.write("large.safetensors", std::string(Source::kLargestBytes + 1, 'x'));
  EXPECT_NE(mistakes("large.safetensors").find("is larger than 12 MB"), std::string::npos);
}

}  // namespace
}  // namespace eyrie::test
