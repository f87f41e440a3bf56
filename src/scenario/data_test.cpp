// SPDX-License-Identifier: MIT
#include "scenario/data.hpp"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/units.hpp"
#include "core/yaml.hpp"

namespace eyrie::scenario {
namespace {

using Files = std::map<std::string, std::string>;

/// A data loader over these files and this `data:` map.
class Loading {
 public:
  explicit Loading(Files files, std::string_view data = "")
      : source_(Source::bundle(std::move(files))) {
    if (!data.empty())
      inline_ = parse_yaml(data, "s", diagnostics_);
    EXPECT_TRUE(diagnostics_.ok()) << diagnostics_.text();
    loader_.emplace(library, data.empty() ? nullptr : &inline_, source_, diagnostics_);
  }
  /// From the folder data/ of this source tree.
  static Files shipped() {
    Files files;
    Source disk = Source::disk(".");
    for (const std::string_view kind : DataLoader::kinds())
      for (const std::string& name : disk.data_names(kind))
        files[disk.data_name(kind, name)] = *disk.read(disk.data_name(kind, name));
    return files;
  }
  DataLoader& operator*() { return *loader_; }
  DataLoader* operator->() { return &*loader_; }
  [[nodiscard]] std::string mistakes() const { return diagnostics_.text(); }

  model::Library library;

 private:
  Source source_;
  Value inline_;
  Diagnostics diagnostics_;
  std::optional<DataLoader> loader_;
};

const Location kAsker{"s", 9, 3};

TEST(Data, OfAnyKindIsKnownByItsWords) {
  Diagnostics none;
  for (const auto& [name, text] : Loading::shipped())
    each_kind_of_model([&, &name = name, &text = text](const auto& kind) {
      if (name.starts_with(fmt::format("data/{}/", kind.folder))) {
        EXPECT_EQ(model_in(parse_yaml(text, name, none)), kind.singular) << name;
      }
    });
  EXPECT_EQ(model_in(parse_yaml("extends: sweep\nlabel: F\n", "s", none)), "");
  EXPECT_EQ(model_in(parse_yaml("name: x\nblue: {}\nlabel: F\n", "s", none)), "");
}

TEST(Data, PutsAnAircraftWithAllItsPartsOnTheShelves) {
  Loading data(Loading::shipped());
  const auto index = data->load<model::AircraftType>("f15c", kAsker);
  ASSERT_TRUE(index) << data.mistakes();
  const model::AircraftType& type = data.library.aircraft[*index];
  EXPECT_EQ(data.library.aircraft.name(*index), "f15c");
  EXPECT_EQ(data.library.airframes.name(type.index.airframe), type.airframe);
  ASSERT_TRUE(type.index.radar && type.index.gun && type.index.tracker && type.index.datalink);
  EXPECT_EQ(data.library.radars.name(*type.index.radar), *type.radar);
  EXPECT_EQ(data.library.guns.name(*type.index.gun), *type.gun);
  for (const model::StationFit& station : type.stations)
    EXPECT_TRUE(data.library.missiles.find(station.store)) << station.store;
  EXPECT_EQ(data->load<model::AircraftType>("f15c", kAsker), index) << "one model under one name";
  EXPECT_EQ(data.library.aircraft.size(), 1u);
}

TEST(Data, ReadsEveryShippedFile) {
  Loading data(Loading::shipped(),
               "aircraft: {towing: {base: mig29, dispenser: towed_decoys}}\n");  // as duel_defense
  Source disk = Source::disk(".");
  EXPECT_TRUE(data->load<model::AircraftType>("towing", kAsker)) << data.mistakes();
  for (const std::string& name : disk.data_names("aircraft"))
    EXPECT_TRUE(data->load<model::AircraftType>(name, kAsker)) << data.mistakes();
  for (const std::string& name : disk.data_names("missiles"))
    EXPECT_TRUE(data->load<model::MissileType>(name, kAsker)) << data.mistakes();
  for (const std::string& name : disk.data_names("vehicles"))
    EXPECT_TRUE(data->load<model::VehicleType>(name, kAsker)) << data.mistakes();
  // nothing lies about that no aircraft and no vehicle is made of
  for (const auto& [kind, shelf] :
       std::map<std::string_view, std::size_t>{{"airframes", data.library.airframes.size()},
                                               {"radars", data.library.radars.size()},
                                               {"irsts", data.library.irsts.size()},
                                               {"rwr", data.library.rwrs.size()},
                                               {"visual", data.library.visuals.size()},
                                               {"iff", data.library.iffs.size()},
                                               {"datalinks", data.library.datalinks.size()},
                                               {"trackers", data.library.trackers.size()},
                                               {"guns", data.library.guns.size()},
                                               {"countermeasures", data.library.dispensers.size()}})
    EXPECT_EQ(shelf, disk.data_names(kind).size()) << kind;
}

TEST(Data, TakesFromItsBaseWhatAModelDoesNotSay) {
  Loading data(Loading::shipped(),
               "aircraft: {mine: {base: f15c, label: Mine, radar: far}}\n"
               "radars: {far: {base: apg63, gimbal: 50 deg}}\n");
  const auto mine = data->load<model::AircraftType>("mine", kAsker);
  ASSERT_TRUE(mine) << data.mistakes();
  const auto f15c = data->load<model::AircraftType>("f15c", kAsker);
  const auto& shelf = data.library.aircraft;
  EXPECT_EQ(shelf[*mine].label, "Mine");
  EXPECT_EQ(shelf[*mine].airframe, shelf[*f15c].airframe);
  EXPECT_EQ(shelf[*mine].signature.rcs_front, shelf[*f15c].signature.rcs_front);
  const model::Radar& far = data.library.radars[*shelf[*mine].index.radar];
  const model::Radar& apg63 = data.library.radars[*shelf[*f15c].index.radar];
  EXPECT_EQ(far.gimbal, radians(50));
  EXPECT_NE(apg63.gimbal, far.gimbal);
  EXPECT_EQ(far.reference_range, apg63.reference_range);
}

TEST(Data, MergesGroupsKeyByKeyAndReplacesLists) {
  Loading data(Loading::shipped(),
               "aircraft: {mine: {base: f15c, signature: {rcs_front: 1 m2}, stations: []}}\n");
  const auto mine = data->load<model::AircraftType>("mine", kAsker);
  const auto f15c = data->load<model::AircraftType>("f15c", kAsker);
  ASSERT_TRUE(mine && f15c) << data.mistakes();
  const auto& shelf = data.library.aircraft;
  EXPECT_EQ(shelf[*mine].signature.rcs_front, 1);
  EXPECT_EQ(shelf[*mine].signature.rcs_side, shelf[*f15c].signature.rcs_side);
  EXPECT_TRUE(shelf[*mine].stations.empty());
  EXPECT_FALSE(shelf[*f15c].stations.empty());
}

TEST(Data, PrefersTheScenariosOwnModelOverAFile) {
  Loading data(Loading::shipped(), "aircraft: {f15c: {base: f16c, label: Other}}\n");
  const auto index = data->load<model::AircraftType>("f15c", kAsker);
  ASSERT_TRUE(index) << data.mistakes();
  EXPECT_EQ(data.library.aircraft[*index].label, "Other");
}

TEST(Data, NamesTheNearestModelItKnows) {
  Loading data(Loading::shipped(), "aircraft: {my_jet: {base: f15c}}\n");
  EXPECT_FALSE(data->load<model::AircraftType>("f51c", kAsker));
  EXPECT_FALSE(data->load<model::AircraftType>("my_jat", {"s", 10, 3}));
  EXPECT_FALSE(data->load<model::MissileType>("sparrow", {"s", 11, 3}));
  EXPECT_EQ(data.mistakes(),
            "s:9:3: unknown aircraft 'f51c'; did you mean 'f15c'?\n"
            "s:10:3: unknown aircraft 'my_jat'; did you mean 'my_jet'?\n"
            "s:11:3: unknown missile 'sparrow', only aim120, aim9, r73, r77");
}

TEST(Data, NeverLeavesItsFolder) {
  Loading data(Files{{"data/aircraft/../radars/apg63.yaml", "label: x\n"}});
  EXPECT_FALSE(data->load<model::AircraftType>("../radars/apg63", kAsker));
  EXPECT_FALSE(data->load<model::AircraftType>("", {"s", 10, 3}));
  EXPECT_EQ(data.mistakes(),
            "s:9:3: unknown aircraft '../radars/apg63'\n"
            "s:10:3: unknown aircraft ''");
}

TEST(Data, SaysAMistakeInAModelOnce) {
  Files files = Loading::shipped();
  files["data/radars/apg63.yaml"] += "gimbl: 3 deg\n";
  Loading data(files, "aircraft: {a: {base: f15c, radar: apg63}, b: {base: f15c, radar: apg63}}\n");
  const std::string said = data.mistakes();
  EXPECT_EQ(said.find('\n'), said.npos) << said;
  EXPECT_NE(said.find("radar has no parameter 'gimbl'; did you mean 'gimbal'?"), said.npos) << said;
}

TEST(Data, RefusesModelsThatAreBasedOnThemselves) {
  EXPECT_EQ(Loading(Files{}, "radars: {a: {base: b}, b: {base: c}, c: {base: b}}\n").mistakes(),
            "s:1:48: radar 'b' is based on itself: b -> c -> b");
  EXPECT_EQ(
      Loading(Files{{"data/radars/apg63.yaml", "base: apg63\n"}}, "radars: {a: {base: apg63}}\n")
          .mistakes(),
      "data/radars/apg63.yaml:1:7: radar 'apg63' is based on itself: apg63 -> apg63");
}

TEST(Data, RefusesNamesThatAreTaken) {
  const Files files{{"data/radars/apg63.yaml", "label: x\n"}};
  const std::string there =
      "radar 'apg63' is there already (data/radars/apg63.yaml): give yours another name; 'base: "
      "apg63' takes over what it does not say";
  EXPECT_EQ(Loading(files, "radars: {apg63: {base: apg63}}\n").mistakes(), "s:1:10: " + there);
  EXPECT_EQ(Loading(files, "radars: {a: {base: apg63}, apg63: {base: a}}\n").mistakes(),
            "s:1:28: " + there);
  EXPECT_EQ(Loading(Loading::shipped(), "missiles: {none: {base: aim9}}\n").mistakes(),
            "s:1:12: data.missiles: 'none' means an empty station; give the missile another name");
}

TEST(Data, RefusesLongChainsOfBases) {
  std::string text = "guns:\n  g0: {base: m61}\n";
  for (int i = 1; i < 40; ++i)
    text += "  g" + std::to_string(i) + ": {base: g" + std::to_string(i - 1) + "}\n";
  const std::string said = Loading(Loading::shipped(), text).mistakes();
  EXPECT_TRUE(said.starts_with("s:2:14: gun 'g20' has more than 20 bases below one another\n"))
      << said;
}

TEST(Data, RefusesMoreModelsThanAStationCanTellApart) {
  std::string text = "missiles:\n";
  for (int i = 0; i < 201; ++i)
    text += "  m" + std::to_string(i) + ": {base: aim9}\n";
  EXPECT_EQ(Loading(Loading::shipped(), text).mistakes(),
            "s:1:1: data.missiles: 201 models; a scenario has at most 200 of a kind");
}

TEST(Data, RefusesMoreStationsThanAnAircraftMayHave) {
  std::string stations;
  for (int i = 0; i < 13; ++i)
    stations += "{store: aim9}, ";
  EXPECT_EQ(
      Loading(Loading::shipped(), "aircraft: {truck: {base: f15c, stations: [" + stations + "]}}\n")
          .mistakes(),
      "s:1:42: stations: expected at most 12 items, got 13");
}

TEST(Data, ReadsModelsThatNobodyFlies) {
  EXPECT_EQ(
      Loading(Loading::shipped(), "radars: {mine: {base: apg63, gimbl: 50 deg}}\n").mistakes(),
      "s:1:30: radar has no parameter 'gimbl'; did you mean 'gimbal'?");
}

TEST(Data, RefusesKindsAndShapesThatThereAreNot) {
  EXPECT_EQ(Loading(Files{}, "[1]\n").mistakes(),
            "s:1:1: data: expected a map of kinds, got a list");
  EXPECT_EQ(Loading(Files{}, "radar: {}\n").mistakes(),
            "s:1:1: data has no kind 'radar'; did you mean 'radars'?");
  EXPECT_EQ(Loading(Files{}, "radars: [x]\n").mistakes(),
            "s:1:9: data.radars: expected a map of names, got a list");
  EXPECT_EQ(Loading(Files{}, "guns: {a: 5}\n").mistakes(), "s:1:11: gun: expected a map, got '5'");
  EXPECT_EQ(Loading(Files{}, "guns: {a: {base: [m61]}}\n").mistakes(),
            "s:1:18: base: expected a name, got a list");
  EXPECT_EQ(Loading(Files{{"data/guns/bad.yaml", "a: [1\n"}}, "guns: {a: {base: bad}}\n")
                .mistakes()
                .substr(0, 31),
            "data/guns/bad.yaml:2:1: not YAM");
}

}  // namespace
}  // namespace eyrie::scenario
