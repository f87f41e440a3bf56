// SPDX-License-Identifier: MIT
#include "core/yaml.hpp"
#include "scenario/path.hpp"
#include "scenario/source.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace eyrie::scenario {
namespace {

using Files = std::map<std::string, std::string>;

struct Loaded {
  Value document;
  std::string mistakes;
};

Loaded load(const Files& files, const std::string& file = "dir/a.yaml") {
  Source source = Source::bundle(files);
  Diagnostics diagnostics;
  Loaded result;
  result.document = load_document(file, source, diagnostics);
  result.mistakes = diagnostics.text();
  return result;
}

/// Maps and lists as flow text, scalars as they are.
std::string text(const Value& v) {
  std::string s;
  for (const Value& item : v.items)
    s += (s.empty() ? "" : ", ") + text(item);
  for (const Value::Entry& e : v.entries)
    s += (s.empty() ? "" : ", ") + e.key + ": " + text(e.value);
  return v.is_null()     ? "null"
         : v.is_scalar() ? v.text
         : v.is_list()   ? "[" + s + "]"
                         : "{" + s + "}";
}

TEST(Document, MergesTreesAndDataOfWhatItIncludes) {
  const Loaded l =
      load({{"dir/a.yaml",
             "include: [p/b.yaml, c.yaml]\nname: x\ntrees: {one: navigate}\n"
             "data: {radars: {r1: {base: apg63}}}\n"},
            {"dir/p/b.yaml", "trees: {two: egress}\ndata: {radars: {r2: {base: apg68}}}\n"},
            {"dir/c.yaml", "data: {guns: {g: {base: m61}}}\n"}});
  EXPECT_EQ(l.mistakes, "");
  EXPECT_EQ(text(l.document),
            "{include: [p/b.yaml, c.yaml], name: x, trees: {one: navigate, two: egress}, data: "
            "{radars: {r1: {base: apg63}, r2: {base: apg68}}, guns: {g: {base: m61}}}}");
  EXPECT_EQ(l.document.find("trees")->find_entry("two")->where, (Location{"dir/p/b.yaml", 1, 9}));
}

TEST(Document, TakesWholeMapsThatItDoesNotHaveItself) {
  EXPECT_EQ(text(load({{"dir/a.yaml", "include: b.yaml\ntrees: {}\n"},
                       {"dir/b.yaml", "trees: {t: navigate}\ndata: {}\n"}})
                     .document),
            "{include: b.yaml, trees: {t: navigate}, data: {}}");
  EXPECT_EQ(load({{"dir/a.yaml", "include: b.yaml\n"}, {"dir/b.yaml", "trees:\n"}}).mistakes,
            "dir/b.yaml:1:1: trees: expected a map, got nothing");
}

TEST(Document, ReadsAFileOnceThatIsReachedInTwoWays) {
  const Loaded l = load({{"dir/a.yaml", "include: [b.yaml, c.yaml]\n"},
                         {"dir/b.yaml", "include: ./d.yaml\n"},
                         {"dir/c.yaml", "include: ../dir/d.yaml\n"},
                         {"dir/d.yaml", "trees: {t: navigate}\n"}});
  EXPECT_EQ(l.mistakes, "");
  EXPECT_EQ(text(*l.document.find("trees")), "{t: navigate}");
}

TEST(Document, RefusesFilesThatIncludeThemselves) {
  EXPECT_EQ(load({{"dir/a.yaml", "include: a.yaml\n"}}).mistakes,
            "dir/a.yaml:1:10: 'dir/a.yaml' includes itself: dir/a.yaml -> dir/a.yaml");
  EXPECT_EQ(load({{"dir/a.yaml", "include: b.yaml\n"},
                  {"dir/b.yaml", "include: c.yaml\n"},
                  {"dir/c.yaml", "trees: {}\ninclude: [b.yaml]\n"}})
                .mistakes,
            "dir/c.yaml:2:11: 'dir/b.yaml' includes itself: dir/b.yaml -> dir/c.yaml -> "
            "dir/b.yaml");
  // whatever way its name is written
  EXPECT_EQ(load({{"./dir/a.yaml", "include: ../dir/a.yaml\n"}}, "./dir/a.yaml").mistakes,
            "./dir/a.yaml:1:10: 'dir/a.yaml' includes itself: dir/a.yaml -> dir/a.yaml");
}

TEST(Document, NamesFilesThatAreMissing) {
  EXPECT_EQ(load({}).mistakes, "dir/a.yaml: cannot read 'dir/a.yaml'");
  EXPECT_EQ(load({{"dir/a.yaml", "include: [b.yaml, /abs/c.yaml]\n"}}).mistakes,
            "dir/a.yaml:1:11: cannot read 'dir/b.yaml'\n"
            "dir/a.yaml:1:19: cannot read '/abs/c.yaml'");
  EXPECT_EQ(load({{"dir/a.yaml", "include: \"\\e[2J\"\n"}}).mistakes,
            "dir/a.yaml:1:10: cannot read 'dir/\\x1b[2J'");
  EXPECT_EQ(load({{"dir/a.yaml", "include: p/pilot.yaml\n"}, {"dir/p/pilots.yaml", ""}}).mistakes,
            "dir/a.yaml:1:10: cannot read 'dir/p/pilot.yaml'; did you mean 'p/pilots.yaml'?");
}

TEST(Document, RefusesIncludesThatAreNoFileNames) {
  EXPECT_EQ(load({{"dir/a.yaml", "include: {b: c}\n"}}).mistakes,
            "dir/a.yaml:1:10: include: expected a file or a list of files, got a map");
  EXPECT_EQ(load({{"dir/a.yaml", "include:\n"}}).mistakes,
            "dir/a.yaml:1:1: include: expected a file or a list of files, got nothing");
  EXPECT_EQ(load({{"dir/a.yaml", "include: [[b.yaml]]\n"}}).mistakes,
            "dir/a.yaml:1:11: include: expected a file, got a list");
  EXPECT_EQ(load({{"dir/a.yaml", "include: ''\n"}}).mistakes,
            "dir/a.yaml:1:10: include: expected a file, got ''");
  EXPECT_EQ(load({{"dir/a.yaml", "- 1\n"}}).mistakes, "dir/a.yaml:1:1: expected a map, got a list");
}

TEST(Document, RefusesNamesThatAreDefinedTwice) {
  EXPECT_EQ(load({{"dir/a.yaml", "include: [b.yaml, c.yaml]\ntrees: {t: navigate}\n"},
                  {"dir/b.yaml", "trees: {t: egress, u: egress}\n"},
                  {"dir/c.yaml", "trees: {u: navigate}\n"}})
                .mistakes,
            "dir/a.yaml:2:9: 'trees.t' is defined already, at dir/b.yaml:1:9; change that one by "
            "its path, as in 'replace: {trees.t: ...}', or with 'insert' and 'remove'\n"
            "dir/c.yaml:1:9: 'trees.u' is defined twice (also at dir/b.yaml:1:20)");
  EXPECT_EQ(
      load({{"dir/a.yaml", "include: b.yaml\ndata: {guns: {g: {}}}\n"},
            {"dir/b.yaml", "data: {guns: {g: {}}, radars: {}, radars: {}}\n"}})
          .mistakes,
      "dir/b.yaml:1:35: 'radars' is given twice (first at line 1)\n"
      "dir/a.yaml:2:15: 'data.guns.g' is defined already, at dir/b.yaml:1:15; change that one "
      "by its path, as in 'replace: {data.guns.g: ...}', or with 'insert' and 'remove'");
  EXPECT_EQ(load({{"dir/a.yaml", "include: b.yaml\n"},
                  {"dir/b.yaml", "trees: {t: navigate}\ntrees: {u: navigate}\n"}})
                .mistakes,
            "dir/b.yaml:2:1: 'trees' is given twice (first at line 1)");
}

TEST(Document, RefusesWhatAnIncludedFileMayNotHold) {
  EXPECT_EQ(
      load({{"dir/a.yaml", "include: b.yaml\ntrees: {}\n"},
            {"dir/b.yaml", "tree: {}\nseed: 2\ntrees: [navigate]\n"}})
          .mistakes,
      "dir/b.yaml:1:1: an included file holds trees, data and plugins, not 'tree'; did you mean "
      "'trees'?\n"
      "dir/b.yaml:2:1: an included file holds trees, data and plugins, not 'seed'\n"
      "dir/b.yaml:3:8: trees: expected a map, got a list");
}

// --set

constexpr const char* kDocument =
    "seed: 1\n"
    "help:\n"
    "blue:\n"
    "  flights:\n"
    "    eagle:\n"
    "      tree: sweep\n"
    "      players: [eagle1, {eagle2: {fuel: 4000 kg}}, {eagle3: }, eagle4]\n"
    "      route: [{north: 1 nmi}, {north: 2 nmi}]\n"
    "      loadout: [aim120, aim9, aim9]\n";

struct Changed {
  std::string text, mistakes;
  Value document;
};

Changed with(const std::vector<std::string>& sets) {
  Source source = Source::bundle({{"a.yaml", kDocument}});
  Diagnostics diagnostics;
  Changed result;
  result.document = load_document("a.yaml", source, diagnostics);
  EXPECT_TRUE(diagnostics.ok()) << diagnostics.text();
  apply_overrides(result.document, sets, diagnostics);
  result.mistakes = diagnostics.text();
  result.text = text(result.document);
  return result;
}

const Value& eagle(const Changed& changed) {
  return *changed.document.find("blue")->find("flights")->find("eagle");
}

TEST(Overrides, ReplaceByKey) {
  const Changed c = with({"seed=7", "blue.flights.eagle.tree=other"});
  EXPECT_EQ(c.mistakes, "");
  EXPECT_EQ(c.document.find("seed")->text, "7");
  EXPECT_EQ(eagle(c).find("tree")->text, "other");
}

TEST(Overrides, AddANewLastKeyButNoNewPath) {
  const Changed c = with({"until=5 min", "blue.flights.eagle.start={north: 0, east: 0}"});
  EXPECT_EQ(c.mistakes, "");
  EXPECT_EQ(c.document.find("until")->text, "5 min");
  EXPECT_EQ(text(*eagle(c).find("start")), "{north: 0, east: 0}");
  EXPECT_EQ(with({"blue.flihgts.eagle.tree=x"}).mistakes,
            "--set blue.flihgts.eagle.tree=x:1:6: there is no 'flihgts' here; did you mean "
            "'flights'?");
  EXPECT_EQ(with({"seed.deep=x"}).mistakes,
            "--set seed.deep=x:1:6: there is no 'deep' here, only '1'");
  EXPECT_EQ(with({"help.deep=x"}).mistakes,
            "--set help.deep=x:1:6: there is no 'deep' here, only nothing");
}

TEST(Overrides, ReplaceANodeBesideParametersOfItsParent) {
  Value document = Value::map({}, {});
  Diagnostics diagnostics;
  document = parse_yaml(
      "trees: {t: {winner_takes_all: {vote: 3, children: [evade, {navigate: {vote: 9}}]}}}", "a",
      diagnostics);
  const std::vector<std::string> sets{"trees.t.winner_takes_all.navigate={vote: 50}",
                                      "trees.t.winner_takes_all.label=x"};
  apply_overrides(document, sets, diagnostics);
  EXPECT_EQ(diagnostics.text(), "");
  EXPECT_EQ(text(document),
            "{trees: {t: {winner_takes_all: {vote: 3, children: [evade, {navigate: {vote: 50}}], "
            "label: x}}}}");
}

TEST(Overrides, MayNameTheListOfChildren) {
  Diagnostics diagnostics;
  Value document = parse_yaml(
      "trees: {bare: {priority: [{navigate: {vote: 9}}]}, named: {priority: {children: "
      "[{navigate: {vote: 9}}]}}}",
      "a", diagnostics);
  const std::vector<std::string> sets{"trees.bare.priority.children.navigate.vote=1",
                                      "trees.named.priority.children.navigate.vote=2"};
  apply_overrides(document, sets, diagnostics);
  EXPECT_EQ(diagnostics.text(), "");
  EXPECT_EQ(text(document),
            "{trees: {bare: {priority: [{navigate: {vote: 1}}]}, named: {priority: {children: "
            "[{navigate: {vote: 2}}]}}}}");
}

TEST(Overrides, ReachListItemsByIndex) {
  const Changed c = with({"blue.flights.eagle.route.1.north=3 nmi",
                          "blue.flights.eagle.loadout.2=none", "blue.flights.eagle.players.0=x"});
  EXPECT_EQ(c.mistakes, "");
  EXPECT_EQ(text(*eagle(c).find("route")), "[{north: 1 nmi}, {north: 3 nmi}]");
  EXPECT_EQ(text(*eagle(c).find("loadout")), "[aim120, aim9, none]");
  EXPECT_EQ(eagle(c).find("players")->items[0].text, "x");
  EXPECT_EQ(with({"blue.flights.eagle.route.2.north=3 nmi"}).mistakes,
            "--set blue.flights.eagle.route.2.north=3 nmi:1:26: there is no item 2 here: the list "
            "has 2, counted from 0");
  EXPECT_EQ(with({"blue.flights.eagle.route.2=3 nmi"}).mistakes,
            "--set blue.flights.eagle.route.2=3 nmi:1:26: there is no item 2 here: the list has 2, "
            "counted from 0");
}

TEST(Overrides, ReachPlayersByName) {
  const Changed c = with({"blue.flights.eagle.players.eagle1.fuel=1000 kg",
                          "blue.flights.eagle.players.eagle1.tree=other",
                          "blue.flights.eagle.players.eagle2.fuel=2000 kg",
                          "blue.flights.eagle.players.eagle3.fuel=3000 kg",
                          "blue.flights.eagle.players.eagle4={tree: other}"});
  EXPECT_EQ(c.mistakes, "");
  EXPECT_EQ(text(*eagle(c).find("players")),
            "[{eagle1: {fuel: 1000 kg, tree: other}}, {eagle2: {fuel: 2000 kg}}, "
            "{eagle3: {fuel: 3000 kg}}, {eagle4: {tree: other}}]");
  EXPECT_EQ(with({"blue.flights.eagle.players.eagel2.fuel=1 kg"}).mistakes,
            "--set blue.flights.eagle.players.eagel2.fuel=1 kg:1:28: there is no 'eagel2' here; "
            "did you mean 'eagle2'?");
}

TEST(Overrides, ReachANameWithADotInQuotes) {
  Value document = Value::map({}, {});
  Diagnostics diagnostics;
  document = parse_yaml("trees: {a.b: {priority: [{x=1.y: {vote: 9}}, plain]}}", "a", diagnostics);
  const std::vector<std::string> sets{"trees.\"a.b\".priority.\"x=1.y\".vote=\"7\"",
                                      "trees.\"c.d\"=idle"};
  apply_overrides(document, sets, diagnostics);
  EXPECT_EQ(diagnostics.text(), "");
  EXPECT_EQ(text(document), "{trees: {a.b: {priority: [{x=1.y: {vote: 7}}, plain]}, c.d: idle}}");
  std::map<std::string, std::string> paths;
  paths_below(*document.find("trees"), "trees", paths);
  EXPECT_EQ(paths.at("a:1:9"), "trees.\"a.b\"");
  EXPECT_EQ(paths.at("a:1:27"), "trees.\"a.b\".priority.\"x=1.y\"");
  EXPECT_EQ(with({"\"seed=7"}).mistakes, "--set \"seed=7:1:1: a quote without an end");
}

TEST(Overrides, GiveArgumentsToTheTreeThatAnItemRefersTo) {
  Diagnostics diagnostics;
  Value document = parse_yaml("trees: {a: {priority: [!tree egress]}}", "a", diagnostics);
  apply_overrides(document, std::vector<std::string>{"trees.a.priority.egress.vote=50"},
                  diagnostics);
  EXPECT_EQ(text(document), "{trees: {a: {priority: [{egress: {vote: 50}}]}}}");
  EXPECT_EQ(document.find("trees")->find("a")->find("priority")->items[0].tag, "!tree");
}

TEST(Overrides, ReachAPlainNodeThatIsThereTwiceByIndexAndName) {
  Diagnostics diagnostics;
  Value document = parse_yaml("trees: {a: {priority: [hold, hold]}}", "a", diagnostics);
  apply_overrides(
      document,
      std::vector<std::string>{"trees.a.priority.1.hold.vote=3", "trees.a.priority.0.vote=4"},
      diagnostics);
  EXPECT_EQ(text(document), "{trees: {a: {priority: [hold, {hold: {vote: 3}}]}}}");
  EXPECT_EQ(diagnostics.text(),
            "--set trees.a.priority.0.vote=4:1:20: there is no 'vote' here, only 'hold' "
            "('hold.vote' if that is a node)");
}

TEST(Overrides, RefuseANameThatIsThereTwice) {
  EXPECT_EQ(with({"blue.flights.eagle.loadout.aim9=none"}).mistakes,
            "--set blue.flights.eagle.loadout.aim9=none:1:28: 'aim9' is in this list more than "
            "once; say which by its index, counted from 0");
}

TEST(Overrides, TakeTheirValueAsYaml) {
  EXPECT_EQ(text(*with({"seed=[1, {a: b}]"}).document.find("seed")), "[1, {a: b}]");
  EXPECT_TRUE(with({"seed='7'"}).document.find("seed")->quoted);
  EXPECT_TRUE(with({"seed="}).document.find("seed")->is_null());
  EXPECT_TRUE(with({"seed= "}).document.find("seed")->is_null());
  EXPECT_EQ(with({"help=a=b"}).document.find("help")->text, "a=b");
}

TEST(Overrides, PointIntoTheirText) {
  const Changed c = with({"blue.flights.eagle.start={north: 1 nmi,\n  east: 2 nmi}"});
  const std::string file = "--set blue.flights.eagle.start={north: 1 nmi,\n  east: 2 nmi}";
  const Value& start = *eagle(c).find("start");
  EXPECT_EQ(start.where, (Location{file, 1, 26}));
  EXPECT_EQ(start.find("north")->where, (Location{file, 1, 34}));
  EXPECT_EQ(start.find_entry("east")->where, (Location{file, 2, 3}));
  EXPECT_EQ(eagle(c).find_entry("start")->where, (Location{file, 1, 20}));
}

TEST(Overrides, RefuseWhatIsNoOverride) {
  EXPECT_EQ(with({"seed"}).mistakes, "--set seed:1:1: expected path=value");
  EXPECT_EQ(with({"=1"}).mistakes, "--set =1:1:1: expected path=value");
  EXPECT_EQ(with({"blue..eagle=1"}).mistakes, "--set blue..eagle=1:1:6: an empty name in the path");
  EXPECT_EQ(with({"include=b.yaml"}).mistakes,
            "--set include=b.yaml:1:1: 'include' is carried out before anything is set");
  EXPECT_EQ(with({"seed.=1"}).mistakes, "--set seed.=1:1:6: an empty name in the path");
  EXPECT_EQ(with({"help= # x"}).mistakes,
            "--set help= # x:1:7: '#' begins a comment; put the value in quotes");
  EXPECT_EQ(with({"seed=[1"}).mistakes.substr(0, 29), "--set seed=[1:1:6: not YAML: ");
}

TEST(Overrides, CollectEveryMistakeAndApplyTheOthers) {
  const Changed c = with({"sede.x=1", "seed=9", "blue.y.z=1"});
  EXPECT_EQ(c.mistakes,
            "--set sede.x=1:1:1: there is no 'sede' here; did you mean 'seed'?\n"
            "--set blue.y.z=1:1:6: there is no 'y' here, only flights");
  EXPECT_EQ(c.document.find("seed")->text, "9");
}

}  // namespace
}  // namespace eyrie::scenario
