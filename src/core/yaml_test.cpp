// SPDX-License-Identifier: MIT
#include "core/yaml.hpp"

#include <gtest/gtest.h>

#include <string>

namespace eyrie {
namespace {

std::string mistakes(std::string_view text, const YamlLimits& limits = {}) {
  Diagnostics d;
  const Value v = parse_yaml(text, "a.yaml", d, limits);
  EXPECT_EQ(d.ok(), !v.is_null());
  return d.text();
}

TEST(Yaml, KeepsOrderPlacesAndQuotes) {
  Diagnostics d;
  const Value v = parse_yaml("b: 1\na: ['2', x]\nc: 3\n", "a.yaml", d);
  ASSERT_TRUE(d.ok()) << d.text();
  ASSERT_EQ(v.entries.size(), 3u);
  EXPECT_EQ(v.entries[0].key, "b");
  EXPECT_EQ(v.entries[2].where, (Location{"a.yaml", 3, 1}));
  const Value& list = v.entries[1].value;
  EXPECT_TRUE(list.items[0].quoted);
  EXPECT_FALSE(list.items[1].quoted);
  EXPECT_EQ(list.items[1].where, (Location{"a.yaml", 2, 10}));
}

TEST(Yaml, ReadsWhatWindowsWrites) {
  Diagnostics d;
  const Value v = parse_yaml(
      "\xEF\xBB\xBF"
      "a: 1\r\nb: !tree 'x'\r\n",
      "a.yaml", d);
  ASSERT_TRUE(d.ok()) << d.text();
  EXPECT_EQ(v.find("a")->text, "1");
  EXPECT_EQ(v.entries[0].where, (Location{"a.yaml", 1, 1}));
  EXPECT_EQ(v.find("b")->tag, "!tree") << "also of what is quoted";
}

TEST(Yaml, RefusesAKeyThatAMapGivesTwiceAndReadsTheRest) {
  Diagnostics d;
  const Value v =
      parse_yaml("b: 1\na: &x {b: 2, c: [{k: 1, k: 2, k: 3}],\n  b: 4}\n'b': 5\nagain: *x\nB: 6\n",
                 "a.yaml", d);
  EXPECT_EQ(d.text(),
            "a.yaml:2:25: 'k' is given twice (first at line 2)\n"
            "a.yaml:2:31: 'k' is given twice (first at line 2)\n"
            "a.yaml:3:3: 'b' is given twice (first at line 2)\n"
            "a.yaml:4:1: 'b' is given twice (first at line 1)");
  ASSERT_EQ(v.entries.size(), 4u);
  EXPECT_EQ(v.find("b")->text, "1");
  EXPECT_EQ(v.find("again")->entries.size(), 2u);
  EXPECT_EQ(v.find("again")->find("b")->text, "2");
}

TEST(Yaml, ExpandsAliases) {
  Diagnostics d;
  const Value v = parse_yaml("a: &x [1, 2]\nb: *x\n", "a.yaml", d);
  ASSERT_TRUE(d.ok()) << d.text();
  EXPECT_EQ(v.find("b")->items.size(), 2u);
}

TEST(Yaml, RefusesAnAliasBomb) {
  std::string text = "a0: &a0 [1,1,1,1,1,1,1,1,1,1]\n";
  for (int i = 1; i < 10; ++i) {
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 10; ++k)
      text += std::string(k ? "," : "") + "*a" + std::to_string(i - 1);
    text += "]\n";
  }
  EXPECT_EQ(mistakes(text), "a.yaml:6:10: more than 200000 values, aliases expanded");
}

TEST(Yaml, RefusesAnAliasInsideItsOwnAnchor) {
  EXPECT_EQ(mistakes("a: &x [1, *x]\n"), "a.yaml:1:11: this alias stands inside what it refers to");
}

TEST(Yaml, RefusesWhatItWouldOtherwiseSilentlyIgnore) {
  EXPECT_EQ(mistakes("a: &x {b: 1}\nc: {<<: *x}\n"),
            "a.yaml:2:5: merge keys ('<<') are not supported; use include or base");
  EXPECT_EQ(mistakes("a: 1\n---\nb: 2\n"), "a.yaml:2:1: a second document in one file");
  EXPECT_EQ(mistakes(std::string_view("a: 1\nb: \0 2\n", 12)),
            "a.yaml:2:4: a NUL byte: this is not a text file");
  EXPECT_EQ(mistakes("? [a, b]\n: 1\n"), "a.yaml:1:3: a key must be a plain word, not a list");
  EXPECT_EQ(mistakes(""), "a.yaml:1:1: the file is empty");
}

TEST(Yaml, SaysThatATabIsOne) {
  EXPECT_EQ(mistakes("a:\n\tb: 1\n"), "a.yaml:2:1: a tab; YAML is indented with spaces");
  EXPECT_EQ(mistakes("a:\n  - b\n \t- c\n"), "a.yaml:3:2: a tab; YAML is indented with spaces");
  EXPECT_EQ(mistakes("a: [1,\n\t2]\nb: \"\t\"\n"), "") << "where it does no harm";
  EXPECT_EQ(mistakes("a: 1\nb: @\tc\n").find("a tab"), std::string::npos);
}

TEST(Yaml, RefusesAnchorsInsideAnchorsThatWouldKeepCopiesOfCopies) {
  std::string text;
  for (int i = 0; i < 50; ++i)
    text += "&a" + std::to_string(i) + " [";
  for (int i = 0; i < 50'000; ++i)
    text += "1,";
  text += std::string(50, ']') + "\n";
  EXPECT_EQ(mistakes(text), "a.yaml:1:267: more than 200000 values below anchors");
}

TEST(Yaml, PlacesAMissingValueAtItsKey) {
  Diagnostics d;
  const Value v = parse_yaml("a: 1\nb:\n\nc: 2\n", "a.yaml", d);
  EXPECT_EQ(v.find("b")->where, (Location{"a.yaml", 2, 1}));
}

TEST(Yaml, RefusesDeepNesting) {
  EXPECT_EQ(mistakes(std::string(257, '[') + std::string(257, ']')),
            "a.yaml:1:257: nested deeper than 256 levels");
  EXPECT_NE(mistakes(std::string(200'000, '[')), "");
}

TEST(Yaml, RefusesFilesThatAreTooLarge) {
  EXPECT_EQ(mistakes("abcdef", {.bytes = 5}), "a.yaml:1:1: the file is larger than 5 bytes");
}

TEST(Yaml, PointsAtTheLineOfASyntaxError) {
  const std::string said = mistakes("a: 1\nb: [1, 2\nc: 3\n");
  EXPECT_TRUE(said.starts_with("a.yaml:3:")) << said;
  EXPECT_NE(said.find("not YAML: "), std::string::npos) << said;
}

TEST(Yaml, PointsAtAKeyWithoutAColon) {
  const std::string why = ": not YAML: while scanning a simple key: could not find expected ':'";
  EXPECT_EQ(mistakes("a: 1\nbee\nc: 2\n"), "a.yaml:2:1" + why);
  EXPECT_EQ(mistakes("a: 1\nbee"), "a.yaml:2:1" + why) << "there is no line 3";
}

TEST(Yaml, RefusesTagsThatMeanNothing) {
  const auto said = [](std::string_view text) {
    Diagnostics d;
    EXPECT_FALSE(parse_yaml(text, "a.yaml", d).is_null()) << "the rest is read";
    return d.text();
  };
  const std::string known = "only !tree, !choice, !range, !uniform, !log_uniform, !normal";
  EXPECT_EQ(said("a: !tre x\nb: !!int 5\nc: !foo [!normal {}, !bar {}]\n! d: !tree e\n"),
            "a.yaml:1:4: there is no tag '!tre', " + known + "; did you mean '!tree'?\n" +
                "a.yaml:2:4: there is no tag '!!int', " + known + "\n" +
                "a.yaml:3:4: there is no tag '!foo', " + known + "\n" +
                "a.yaml:3:22: there is no tag '!bar', " + known + "\n" +
                "a.yaml:4:1: there is no tag '!', " + known);
  EXPECT_EQ(said("- !tree engage: {vote: 3}\n"),
            "a.yaml:1:3: a key has no tag: write !tree {engage: ...}");
}

TEST(Yaml, PointsAtBytesThatAreNoText) {
  EXPECT_EQ(mistakes("a: 1\nb: \u00e9\xC3\x28\n"),
            "a.yaml:2:6: not YAML: invalid trailing UTF-8 octet");
  EXPECT_EQ(mistakes("a: 1\n\nb: x\x01y\n"),
            "a.yaml:3:5: not YAML: control characters are not allowed");
}

}  // namespace
}  // namespace eyrie
