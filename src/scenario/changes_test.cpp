// SPDX-License-Identifier: MIT
/// \file  What a scenario says of another that it extends, and of what it includes.
#include "scenario/changes.hpp"

#include <gtest/gtest.h>

#include "scenario/source.hpp"

namespace eyrie::scenario {
namespace {

using Texts = std::map<std::string, std::string>;

constexpr const char* kBase =
    "name: base\n"
    "seed: 1\n"
    "include: pack.yaml\n"
    "trees:\n"
    "  wall:\n"
    "    winner_takes_all: [evade, follow_lead, {navigate: {vote: 10}}]\n"
    "  voted:\n"
    "    winner_takes_all: {vote: 3, children: [evade, {navigate: {vote: 10}}]}\n"
    "blue:\n"
    "  home: {north: 0}\n"
    "  flights:\n"
    "    eagle: {tree: wall, players: [eagle1, eagle2], route: [{north: 1}, {north: 2}]}\n";

/// Lists and maps as flow text.
std::string flow(const Value& v) {
  std::string s;
  for (const Value& item : v.items)
    s += (s.empty() ? "" : ", ") + flow(item);
  for (const Value::Entry& e : v.entries)
    s += (s.empty() ? "" : ", ") + e.key + ": " + flow(e.value);
  return v.is_list() ? "[" + s + "]" : v.is_map() ? "{" + s + "}" : v.is_null() ? "~" : v.text;
}

struct Made {
  Value document;
  std::string mistakes;
  std::vector<Removed> removed;

  [[nodiscard]] std::string at(std::initializer_list<std::string_view> keys) const {
    const Value* found = &document;
    for (const std::string_view key : keys)
      found = found ? found->find(key) : nullptr;
    return found ? flow(*found) : "nothing";
  }
};

Made compose(Texts files, const std::string& file = "own.yaml") {
  files.emplace("scenarios/base.yaml", kBase);
  files.emplace("scenarios/pack.yaml", "trees: {press: {per_field: [{release: {zone: 1}}]}}\n");
  Source source = Source::bundle(std::move(files));
  Diagnostics diagnostics;
  Made made;
  made.document = load_document(file, source, diagnostics, &made.removed);
  made.mistakes = diagnostics.text();
  return made;
}
Made own(const std::string& words) {
  return compose({{"own.yaml", "extends: base\n" + words}});
}

TEST(Extends, IsTheSameDocumentIfNothingIsSaid) {
  const Made same = own(""), base = compose({}, "scenarios/base.yaml");
  EXPECT_EQ(same.mistakes, "");
  EXPECT_EQ(flow(same.document), flow(base.document));
  EXPECT_EQ(same.document.find("seed")->where, (Location{"scenarios/base.yaml", 2, 7}));
}

TEST(Extends, PutsItsOwnWordsInThePlaceOfOthersAndAddsItsTreesAndFlights) {
  const Made made =
      own("seed: 7\nuntil: 5 min\ntrees: {mine: navigate}\n"
          "blue: {home: {north: 5}, flights: {hawk: {tree: mine}}}\nred: {flights: {bogey: {}}}\n");
  EXPECT_EQ(made.mistakes, "");
  EXPECT_EQ(made.at({"seed"}), "7");
  EXPECT_EQ(made.at({"until"}), "5 min");
  EXPECT_EQ(made.at({"trees", "mine"}), "navigate");
  EXPECT_EQ(made.at({"blue", "home"}), "{north: 5}");
  EXPECT_EQ(made.at({"blue", "flights", "hawk"}), "{tree: mine}");
  EXPECT_EQ(made.at({"red", "flights", "bogey"}), "{}");
  EXPECT_NE(made.at({"blue", "flights", "eagle"}), "nothing");
}

TEST(Extends, TellsWhoDefinesANameAgainHowToChangeIt) {
  EXPECT_EQ(
      own("trees: {press: navigate}\nblue: {flights: {eagle: {tree: x}}}\n").mistakes,
      "own.yaml:2:9: 'trees.press' is defined already, at scenarios/pack.yaml:1:9; change that one "
      "by its path, as in 'replace: {trees.press: ...}', or with 'insert' and 'remove'\n"
      "own.yaml:3:18: 'blue.flights.eagle' is defined already, at scenarios/base.yaml:12:5; change "
      "that one by its path, as in 'replace: {blue.flights.eagle: ...}', or with 'insert' and "
      "'remove'");
}

TEST(Extends, GoesThroughFilesThatExtendOthers) {
  const Made made =
      compose({{"own.yaml", "extends: dir/next.yaml\nreplace: {trees.wall: egress}\n"},
               {"dir/next.yaml", "extends: base\nseed: 2\nremove: trees.voted\n"}});
  EXPECT_EQ(made.mistakes, "");
  EXPECT_EQ(made.at({"seed"}), "2");
  EXPECT_EQ(made.at({"trees"}), "{wall: egress, press: {per_field: [{release: {zone: 1}}]}}");
}

TEST(Extends, RefusesWhatIsNoScenario) {
  EXPECT_EQ(compose({{"own.yaml", "extends: bsae\n"}}).mistakes,
            "own.yaml:1:10: there is no scenario 'bsae' (a file is named with its ending, as in "
            "'bsae.yaml'); did you mean 'base'?");
  EXPECT_EQ(compose({{"own.yaml", "extends: bsae\ntrees: {lurk: navigate}\n"}}).mistakes,
            "own.yaml:1:10: there is no scenario 'bsae' (a file is named with its ending, as in "
            "'bsae.yaml'); did you mean 'base'?");
  EXPECT_EQ(compose({{"own.yaml", "extends: bas.yaml\n"}, {"base.yaml", ""}}).mistakes,
            "own.yaml:1:10: cannot read 'bas.yaml'; did you mean 'base.yaml'?");
  EXPECT_EQ(compose({{"own.yaml", "extends: scenarios/pack.yaml\n"}}).mistakes,
            "own.yaml:1:10: 'scenarios/pack.yaml' is no scenario but a package: 'include' it");
  EXPECT_EQ(compose({{"own.yaml", "extends: [base]\n"}}).mistakes,
            "own.yaml:1:10: extends: expected a scenario, got a list");
  EXPECT_EQ(compose({{"own.yaml", "extends:\n"}}).mistakes,
            "own.yaml:1:1: extends: expected a scenario, got nothing");
  EXPECT_EQ(compose({{"own.yaml", "extends: ''\n"}}).mistakes,
            "own.yaml:1:10: extends: expected a scenario, got ''");
  EXPECT_EQ(compose({{"own.yaml", "include: p.yaml\n"}, {"p.yaml", "extends: base\n"}}).mistakes,
            "p.yaml:1:1: an included file holds trees, data and plugins, not 'extends'");
}

TEST(Extends, RefusesCirclesAndChainsWithoutAnEnd) {
  EXPECT_EQ(
      compose({{"own.yaml", "extends: b.yaml\n"}, {"b.yaml", "extends: ./own.yaml\n"}}).mistakes,
      "b.yaml:1:10: 'own.yaml' extends itself: own.yaml -> b.yaml -> own.yaml");
  Texts files;
  for (int i = 0; i < 60; ++i)
    files["c" + std::to_string(i) + ".yaml"] =
        "seed: 1\nextends: c" + std::to_string(i + 1) + ".yaml\n";
  EXPECT_EQ(compose(files, "c0.yaml").mistakes,
            "c50.yaml:2:10: includes in includes, more than 50 deep: 'c0.yaml' -> 'c1.yaml' -> ... "
            "-> 'c51.yaml'");
}

TEST(Changes, InsertAtTheEndOfAListBesideAnItemOrUnderANewKey) {
  const Made made =
      own("insert:\n"
          "  trees.wall.winner_takes_all: [one, two]\n"
          "  before trees.wall.winner_takes_all.follow_lead: three\n"
          "  after trees.wall.winner_takes_all.2: four\n"
          "  trees.voted.winner_takes_all: five\n"
          "  before trees.voted.winner_takes_all.navigate: six\n"
          "  trees.voted.winner_takes_all.name: top\n"
          "  trees.voted.winner_takes_all.navigate.speed: 400 kt\n"
          "  blue.flights.eagle.players.eagle2.fuel: 900 kg\n"
          "  red: {flights: {}}\n");
  EXPECT_EQ(made.mistakes, "");
  EXPECT_EQ(
      made.at({"trees", "wall"}),
      "{winner_takes_all: [evade, three, follow_lead, {navigate: {vote: 10}}, four, one, two]}");
  EXPECT_EQ(made.at({"trees", "voted"}),
            "{winner_takes_all: {vote: 3, children: [evade, six, {navigate: {vote: 10, speed: 400 "
            "kt}}, five], name: top}}");
  EXPECT_EQ(made.at({"blue", "flights", "eagle", "players"}), "[eagle1, {eagle2: {fuel: 900 kg}}]");
  EXPECT_EQ(made.at({"red"}), "{flights: {}}");
}

TEST(Changes, ReplaceWholeNodesAndParametersAndRemoveWhatIsNamed) {
  const Made made = own(
      "replace:\n"
      "  trees.wall.winner_takes_all.navigate: egress\n"
      "  trees.voted.winner_takes_all.children.navigate.vote: 11\n"
      "  trees.press.per_field.release.zone: 2\n"
      "  seed: 9\n"
      "remove: [trees.wall.winner_takes_all.evade, blue.home, blue.flights.eagle.players.eagle2,\n"
      "         trees.voted.winner_takes_all.vote, blue.flights.eagle.route.0]\n");
  EXPECT_EQ(made.mistakes, "");
  EXPECT_EQ(
      made.at({"trees"}),
      "{wall: {winner_takes_all: [follow_lead, egress]}, voted: {winner_takes_all: {children: "
      "[evade, {navigate: {vote: 11}}]}}, press: {per_field: [{release: {zone: 2}}]}}");
  EXPECT_EQ(made.at({"blue"}),
            "{flights: {eagle: {tree: wall, players: [eagle1], route: [{north: 2}]}}}");
  EXPECT_EQ(made.at({"seed"}), "9");
  EXPECT_EQ(made.removed.size(), 5u);
}

TEST(Changes, MeanWhatIsThereWithoutThemWhateverTheirOrder) {
  const std::string path = "trees.wall.winner_takes_all.";
  const Made made = own("remove: [" + path + "0, " + path + "1]\ninsert: {before " + path +
                        "1: x, after " + path + "0: y, before " + path + "0: z}\n");
  EXPECT_EQ(made.mistakes, "");
  EXPECT_EQ(made.at({"trees", "wall"}), "{winner_takes_all: [z, x, y, {navigate: {vote: 10}}]}");
}

TEST(Changes, ReachOneNodeByNameAndByIndexInAnyOrder) {
  const std::string path = "  trees.wall.winner_takes_all.";
  const std::string name = path + "follow_lead.vote: 3\n";
  const std::string index = path + "1.follow_lead.name: x\n";
  for (const std::string& both : {name + index, index + name}) {
    const Made made = own("insert:\n" + both);
    EXPECT_EQ(made.mistakes, "");
    EXPECT_TRUE(made.at({"trees", "wall"}).find("vote: 3") != std::string::npos &&
                made.at({"trees", "wall"}).find("name: x") != std::string::npos)
        << made.at({"trees", "wall"});
  }
}

TEST(Changes, ChangeWhatAScenarioIncludesToo) {
  const Made made = compose({{"own.yaml",
                              "include: scenarios/pack.yaml\nseed: 1\ntrees: {a: egress}\n"
                              "replace: {trees.press.per_field.release.zone: 3}\n"}});
  EXPECT_EQ(made.mistakes, "");
  EXPECT_EQ(made.at({"trees"}), "{a: egress, press: {per_field: [{release: {zone: 3}}]}}");
}

TEST(Changes, SayWhatIsWrongWithTheirPaths) {
  const std::string in = "trees.wall.winner_takes_all";
  struct Case {
    std::string words, mistake;
  };
  for (const Case& c : {
           Case{"insert: {trees.wal.x: y}", "2:16: there is no 'wal' here; did you mean 'wall'?"},
           Case{"insert: {trees.wall.winner_takes_al: y}",
                "2:21: there is no 'winner_takes_al' here; did you mean 'winner_takes_all'?"},
           Case{"insert: {before " + in + ".evad: y}",
                "2:45: there is no 'evad' here; did you mean 'evade'?"},
           Case{"insert: {seed: 2}",
                "2:10: 'seed' is there already (scenarios/base.yaml:2:7), and no list; 'replace' "
                "puts something else in its place"},
           Case{"insert: {trees: {mine: navigate}}",
                "2:10: 'trees' is there already (scenarios/base.yaml:5:3), and no list; 'insert' "
                "each new key by its own path, which ends in 'trees.mine'"},
           Case{"insert: {after seed: 2}",
                "2:16: 'after' is for items of lists; in a map the order does not count"},
           Case{"insert: {seed.deep: 2}", "2:15: there is no 'deep' here, only '1'"},
           Case{"insert: [x]", "2:9: insert: expected a map from paths to values, got a list"},
           Case{"replace: {untl: 3 min}",
                "2:11: there is no 'untl' here ('insert' adds what is new), only name, seed, "
                "include, "
                "trees, blue"},
           Case{"replace: {" + in + ".7: x}",
                "2:39: there is no item 7 here: the list has 3, counted from 0"},
           Case{"replace: {a..b: x}", "2:13: an empty name in the path"},
           Case{"insert: {befor trees.wall.winner_takes_all.evade: x}",
                "2:10: 'befor' is no place to insert at; did you mean 'before'?"},
           Case{"replace: {before seed: x}",
                "2:11: there is no 'before seed' here ('insert' adds what is new), only name, "
                "seed, include, "
                "trees, blue"},
           Case{"remove: blue.flights.eagel",
                "2:22: there is no 'eagel' here; did you mean 'eagle'?"},
           Case{"remove: [include]", "2:10: 'include' is carried out before anything is changed"},
           Case{"insert: {extends: x}",
                "2:10: 'extends' is carried out before anything is changed"},
           Case{"replace: {include.0: x}",
                "2:11: 'include' is carried out before anything is changed"},
           Case{"remove: [{a: b}]", "2:10: remove: expected a path or a list of paths, got a map"},
           Case{"remove:", "2:1: remove: expected a path or a list of paths, got nothing"},
           Case{"remove: [seed, seed]", "2:16: 'seed' is changed twice (also at own.yaml:2:10)"},
           Case{"remove: trees.wall\nreplace: {" + in + ".evade: x}",
                "3:11: 'trees.wall.winner_takes_all.evade' is inside of what another change takes "
                "away (at own.yaml:2:9)"},
           Case{"until: 3 s\nremove: until",
                "3:9: 'until' stands in this file, at own.yaml:2:8: change it there"},
           Case{"insert: {" + in + ".navigate.x: 1, " + in + ".2.navigate.x: 1}",
                "2:53: 'trees.wall.winner_takes_all.2.navigate.x' is inserted twice"},
       })
    EXPECT_EQ(own(c.words + "\n").mistakes, "own.yaml:" + c.mistake) << c.words;
}

TEST(Changes, AreLimitedInNumber) {
  std::string words = "remove: [seed";
  for (int i = 0; i < 1000; ++i)
    words += ", trees.wall";
  EXPECT_NE(own(words + "]\n").mistakes.find("own.yaml:2:12"), std::string::npos);
  std::string many = "insert:\n";
  for (int i = 0; i < 1001; ++i)
    many += "  trees.t" + std::to_string(i) + ": navigate\n";
  EXPECT_EQ(own(many).mistakes, "own.yaml:1003:3: more than 1000 changes");
}

TEST(Changes, AreBlamedForWhatIsMissedLater) {
  const std::vector<Removed> removed{
      {"wall", {"own.yaml", 3, 5}, {"base.yaml", 4, 3}},
      {"", {"own.yaml", 4, 5}, {"base.yaml", 9, 9}},
      {"trees", {"own.yaml", 5, 5}, {"base.yaml", 1, 1}, {"egress"}}};
  Diagnostics found;
  found.error({"base.yaml", 7, 1}, "there is no tree 'wall'; did you mean 'well'?");
  found.error({"base.yaml", 8, 1}, "there is no tree 'wall'");
  found.error({"base.yaml", 9, 9}, "winner_takes_all needs at least one child");
  found.error({"base.yaml", 10, 1}, "something else");
  found.error({"own.yaml", 11, 1}, "there is no tree 'wall'");
  found.error({"base.yaml", 12, 1}, "there is no tree 'egress'");
  EXPECT_EQ(
      blame_removals(found, removed).text(),
      "own.yaml:3:5: 'wall' cannot be removed: base.yaml:7:1: there is no tree 'wall'\n"
      "own.yaml:4:5: it cannot be removed: base.yaml:9:9: winner_takes_all needs at least one "
      "child\n"
      "own.yaml:5:5: 'trees' cannot be removed: base.yaml:12:1: there is no tree 'egress'\n"
      "own.yaml:11:1: there is no tree 'wall'\n"
      "base.yaml:10:1: something else");
}

}  // namespace
}  // namespace eyrie::scenario
