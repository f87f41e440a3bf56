// SPDX-License-Identifier: MIT
#include "scenario/source.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace eyrie::scenario {
namespace {
namespace fs = std::filesystem;

/// A folder of this test alone, removed at the end.
class SourceOnDisk : public testing::Test {
 protected:
  SourceOnDisk()
      : folder_(fs::path(testing::TempDir()) /
                ("eyrie_source_" +
                 std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "data/radars");
  }
  ~SourceOnDisk() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }

  fs::path folder_;
};

TEST_F(SourceOnDisk, ReadsAndRemembers) {
  const std::string file = write("a.yaml", "one: 1\n");
  Source source = Source::disk(folder_.string());
  EXPECT_TRUE(source.files().empty());
  EXPECT_EQ(source.read(file), "one: 1\n");
  write("a.yaml", "changed");
  EXPECT_EQ(source.read(file), "one: 1\n") << "a run is made from one reading of each file";
  EXPECT_EQ(source.files(), (std::map<std::string, std::string>{{file, "one: 1\n"}}));
}

TEST_F(SourceOnDisk, LooksUpDataBelowHomeWhateverTheWorkingFolder) {
  write("data/radars/x.yaml", "r: 1\n");
  Source source = Source::disk(folder_.string());
  EXPECT_EQ(source.data_name("radars", "x"), "data/radars/x.yaml");
  EXPECT_EQ(source.read("data/radars/x.yaml"), "r: 1\n");
  EXPECT_EQ(source.files().count("data/radars/x.yaml"), 1u) << "no folder of this machine in a run";
  ASSERT_TRUE(fs::exists("data/radars/apg63.yaml"));
  EXPECT_EQ(source.read("data/radars/apg63.yaml"), std::nullopt) << "of the working folder";
}

/// The working folder has this file, too.
TEST_F(SourceOnDisk, TakesAFileThatTheUserNamesFromHisOwnFolder) {
  const std::string name = "data/aircraft/f15c.yaml";
  fs::create_directories(folder_ / "data/aircraft");
  write(name, "trees: {home: navigate}\n");
  Source source = Source::disk(folder_.string());
  Diagnostics diagnostics;
  const Value own = load_document(name, source, diagnostics);
  EXPECT_TRUE(own.find("airframe"));
  EXPECT_EQ(own.where.file, FileName("./" + name));
  EXPECT_EQ(source.read(name), "trees: {home: navigate}\n") << "what is found by name";
  Source bundle = Source::bundle(source.files());
  EXPECT_TRUE(load_document(name, bundle, diagnostics).find("airframe"));
  source.add("eyrie:scenarios/s.yaml", "include: ../" + name + "\n");
  const Value shipped = load_document("eyrie:scenarios/s.yaml", source, diagnostics);
  EXPECT_TRUE(shipped.find("trees")) << "Eyrie's own scenarios include Eyrie's";
  EXPECT_EQ(diagnostics.text(), "");
}

TEST_F(SourceOnDisk, GivesNothingForWhatIsNoFile) {
  Source source = Source::disk(folder_.string());
  EXPECT_EQ(source.read((folder_ / "nothing.yaml").string()), std::nullopt);
  EXPECT_EQ(source.read((folder_ / "data").string()), std::nullopt);
  EXPECT_EQ(source.read(""), std::nullopt);
  const std::string file = write("a.yaml", "x");
  EXPECT_EQ(source.read(file + '\0' + ".yaml"), std::nullopt) << "a name must not be cut at a NUL";
  EXPECT_TRUE(source.files().empty());
}

TEST_F(SourceOnDisk, SaysWhyAFileIsNotRead) {
  const Source source = Source::disk(folder_.string());
  const std::string folder = (folder_ / "data").string();
  EXPECT_EQ(source.why_unread(folder, ""),
            "cannot read '" + folder + "': it is a folder, not a file");
  EXPECT_EQ(source.why_unread("/proc/self/mem", ""),
            "cannot read '/proc/self/mem': Input/output error");
  write("near.yaml", "x");
  const std::string missing = (folder_ / "neer.yaml").string();
  EXPECT_EQ(source.why_unread(missing, ""),
            "cannot read '" + missing + "'; did you mean 'near.yaml'?");
  fs::create_directories(folder_ / "sub");
  write("sub/deep.yaml", "x");
  const std::string deep = (folder_ / "sub/dep.yaml").string();
  EXPECT_EQ(source.why_unread(deep, (folder_ / "mine.yaml").string()),
            "cannot read '" + deep + "'; did you mean 'sub/deep.yaml'?");
}

TEST(SourceInABundle, NamesWhatTheAskerCouldWrite) {
  const Source source = Source::bundle({{"scenarios/mine.yaml", ""},
                                        {"scenarios/packages/pilots.yaml", "trees: {}"},
                                        {"eyrie:scenarios/packages/drivers.yaml", "trees: {}"}});
  EXPECT_EQ(source.why_unread("scenarios/packages/pilot.yaml", "scenarios/mine.yaml"),
            "cannot read 'scenarios/packages/pilot.yaml'; did you mean 'packages/pilots.yaml'?");
  EXPECT_EQ(source.why_unread("eyrie:scenarios/packages/driver.yaml", "scenarios/mine.yaml"),
            "cannot read 'eyrie:scenarios/packages/driver.yaml'; did you mean "
            "'eyrie:scenarios/packages/drivers.yaml'?");
  EXPECT_EQ(source.why_unread("eyrie:scenarios/packages/driver.yaml", "eyrie:scenarios/sweep.yaml"),
            "cannot read 'eyrie:scenarios/packages/driver.yaml'; did you mean "
            "'packages/drivers.yaml'?");
}

TEST_F(SourceOnDisk, NamesWhatACopyOfOurScenarioMeant) {
  fs::create_directories(folder_ / "scenarios/packages");
  write("scenarios/packages/pilots.yaml", "trees: {}\n");
  const Source source = Source::disk(folder_.string());
  const std::string copy = (folder_ / "mine/sweep.yaml").string();
  const std::string missing = (folder_ / "mine/packages/pilots.yaml").string();
  EXPECT_EQ(source.why_unread(missing, copy),
            "cannot read '" + missing + "'; did you mean 'eyrie:scenarios/packages/pilots.yaml'?");
  EXPECT_EQ(source.why_unread("packages/pilots.yaml", "sweep.yaml"),
            "cannot read 'packages/pilots.yaml'; did you mean "
            "'eyrie:scenarios/packages/pilots.yaml'?");
  const std::string other = (folder_ / "mine/packages/drivers.yaml").string();
  EXPECT_EQ(source.why_unread(other, copy), "cannot read '" + other + "'");
}

TEST_F(SourceOnDisk, ReadsNoMoreOfAHugeFileThanAParserNeedsToRefuseIt) {
  const std::string file = write("huge.yaml", "x");
  fs::resize_file(file, Source::kLargest * 4);
  Source source = Source::disk(folder_.string());
  EXPECT_EQ(source.read(file)->size(), Source::kLargest + 1);
  const std::string largest = write("largest.yaml", "x");
  fs::resize_file(largest, Source::kLargest);
  EXPECT_EQ(source.read(largest)->size(), Source::kLargest);
}

TEST_F(SourceOnDisk, ListsDataInOrder) {
  for (const char* name : {"b.yaml", "a.yaml", "notes.txt"})
    write(std::string("data/radars/") + name, "x: 1\n");
  const Source source = Source::disk(folder_.string());
  EXPECT_EQ(source.data_names("radars"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(source.data_names("guns"), std::vector<std::string>{});
}

TEST(SourceBundle, ServesItsTextsAndNothingElse) {
  Source source =
      Source::bundle({{"data/guns/m61.yaml", "a"}, {"s.yaml", "b"}, {"data/guns/x", "c"}});
  EXPECT_EQ(source.read("s.yaml"), "b");
  EXPECT_EQ(source.read("/etc/hostname"), std::nullopt);
  EXPECT_EQ(source.read("CMakeLists.txt"), std::nullopt) << "a replay must not read the disk";
  EXPECT_EQ(source.data_names("guns"), std::vector<std::string>{"m61"});
  EXPECT_EQ(source.files().size(), 3u);
}

TEST(Source, ServesTheModelsOfPluginsUnderNamesThatSayWhoseTheyAre) {
  Source source = Source::bundle({{"data/guns/m61.yaml", "a"}});
  source.add_model("guns", "bb_gun", "libtoys.so", "rate: 1");
  EXPECT_EQ(source.data_name("guns", "bb_gun"), "plugin:libtoys.so/guns/bb_gun.yaml");
  EXPECT_EQ(source.data_name("guns", "m61"), "data/guns/m61.yaml");
  EXPECT_EQ(source.data_names("guns"), (std::vector<std::string>{"bb_gun", "m61"}));
  EXPECT_EQ(source.origin("guns", "bb_gun"), "libtoys.so");
  EXPECT_EQ(source.origin("guns", "m61"), std::nullopt);
  EXPECT_EQ(source.files().size(), 1u) << "only what was read goes into a recording";
  EXPECT_EQ(source.read("plugin:libtoys.so/guns/bb_gun.yaml"), "rate: 1");
  EXPECT_EQ(source.files().size(), 2u);
}

TEST(RelativeTo, FollowsTheFolderOfTheFile) {
  EXPECT_EQ(relative_to("scenarios/a.yaml", "packages/b.yaml"), "scenarios/packages/b.yaml");
  EXPECT_EQ(relative_to("scenarios/a.yaml", "../b.yaml"), "b.yaml");
  EXPECT_EQ(relative_to("a.yaml", "b.yaml"), "b.yaml");
  EXPECT_EQ(relative_to("/x/a.yaml", "./b.yaml"), "/x/b.yaml");
  EXPECT_EQ(relative_to("x/a.yaml", "/y/b.yaml"), "/y/b.yaml");
}

}  // namespace
}  // namespace eyrie::scenario
