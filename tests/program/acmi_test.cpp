// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/acmi_reader.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

std::uint64_t hex(const std::string& text) {
  return std::stoull(text, nullptr, 16);
}

/// The sweep, flown by the program once for all tests of this file.
struct Flown {
  TempFolder folder;
  nlohmann::json report;
  Acmi file{
      "\xEF\xBB\xBF"
      "FileType=text/acmi/tacview\nFileVersion=2.2\n"};

  Flown() {
    const Ran ran = run_program(folder, {"fly", "sweep_phases", "--out", "run", "--json"});
    if (ran.code != 0)
      throw std::runtime_error(ran.err);
    report = nlohmann::json::parse(ran.out);
    file = Acmi(read_text(folder / "run/flight.acmi"));
  }
  static const Flown& get() {
    static const Flown flown;
    return flown;
  }
};

TEST(AcmiReader, RefusesWhatTheGrammarDoesNotAllow) {
  const std::string head =
      "\xEF\xBB\xBF"
      "FileType=text/acmi/tacview\nFileVersion=2.2\n";
  EXPECT_NO_THROW(Acmi(head + "0,Title=a\\,b\n#0\n1,T=1|2|3\n#1.5\n1,T=||4\n-1\n"));
  EXPECT_EQ(Acmi(head + "0,Title=a\\,b\\\nc\n").globals.at("Title"), "a,b\nc");
  for (const char* bad :
       {"#1\n#0\n", "#0\n-1\n", "1,T=1|2|3\n", "#0\n1,T=1|2\n", "#0\n01,T=1|2|3\n",
        "#0\n1,T=a|2|3\n", "#0\n0,Event=Blown|1\n", "#0\n1,T\n", "#0\n1,T=1|2|3\n-1\n1,T=1|2|3\n",
        "0,Title=a\\b\n#0\n", "#0\n1,T=||3\n", "#0\n0,Event=Message|x|text\n", "#0\nhello\n",
        "#0\n1,T=1|2|3\n1,T=1|2|3|4|5\n", "#0\nA,T=1|2|3\n", "#0\n1,A=1,A=2\n", "#0"})
    EXPECT_THROW(Acmi(head + bad), std::runtime_error) << bad;
  EXPECT_THROW(Acmi("FileType=text/acmi/tacview\nFileVersion=2.2\n"), std::runtime_error);
}

TEST(AcmiFile, SaysWhatItIsAndWhere) {
  const Acmi& f = Flown::get().file;
  EXPECT_EQ(f.globals.at("Title"), "sweep_phases");
  EXPECT_EQ(f.globals.at("DataSource"), "Eyrie");
  EXPECT_EQ(acmi_number(f.globals.at("ReferenceLongitude")), -68);
  EXPECT_EQ(acmi_number(f.globals.at("ReferenceLatitude")), 33);
  EXPECT_EQ(f.globals.at("ReferenceTime").size(), std::string("2026-01-01T12:00:00Z").size());
  ASSERT_FALSE(f.frames.empty());
  EXPECT_EQ(f.frames.front(), 0);
  EXPECT_NEAR(f.frames.back(), Flown::get().report["sim_time_s"].get<double>(), 0.005);
}

TEST(AcmiFile, GivesLongitudesAsOthersDo) {
  TempFolder folder;
  const Ran ran = run_program(folder, {"fly", "merge", "--until", "1 s", "--set",
                                       "reference.longitude=300 deg", "--out", "run"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const Acmi file(read_text(folder / "run/flight.acmi"));
  EXPECT_EQ(acmi_number(file.globals.at("ReferenceLongitude")), -60);
}

TEST(AcmiFile, DescribesEveryAircraft) {
  const Acmi& f = Flown::get().file;
  for (const char* name : {"eagle1", "eagle2", "eagle3", "eagle4", "bogey1", "bogey2"}) {
    const AcmiObject* o = f.by_name(name);
    ASSERT_TRUE(o) << name;
    const bool blue = name[0] == 'e';
    EXPECT_EQ(o->last("Type"), "Air+FixedWing");
    EXPECT_EQ(o->last("Name"), blue ? "F-15C" : "MiG-29S");
    EXPECT_EQ(o->last("Group"), blue ? "eagle" : "bogey");
    EXPECT_EQ(o->last("Color"), blue ? "Blue" : "Red");
    EXPECT_EQ(o->last("Slot"), std::to_string(name[5] - '1')) << "0 leads";
    EXPECT_EQ(o->updates.front().time, 0);
    EXPECT_EQ(o->place_fields, 6U);
  }
}

TEST(AcmiFile, BurnsFuelAndSaysWhoIsInCharge) {
  const Acmi& f = Flown::get().file;
  for (const auto& [id, o] : f.objects) {
    if (o.last("Type") != "Air+FixedWing")
      continue;
    double fuel = 1e9;
    std::size_t decisions = 0;
    for (const AcmiUpdate& u : o.updates) {
      if (const auto p = u.properties.find("FuelWeight"); p != u.properties.end()) {
        EXPECT_LT(acmi_number(p->second), fuel);
        fuel = acmi_number(p->second);
      }
      EXPECT_EQ(u.properties.contains("UbfWinner"), u.properties.contains("UbfVote"));
      if (u.properties.contains("UbfWinner")) {
        ++decisions;
        EXPECT_FALSE(u.properties.at("UbfWinner").empty());
        EXPECT_GT(acmi_number(u.properties.at("UbfVote")), 0);
        EXPECT_EQ(u.properties.at("Label"),
                  u.properties.at("UbfWinner") + " " + u.properties.at("UbfVote"));
      }
    }
    EXPECT_LT(fuel, 6000);
    EXPECT_GT(decisions, 2U) << o.last("CallSign");
  }
}

TEST(AcmiFile, LetsEveryMissileBeBornOfAShooterAndEnd) {
  const Acmi& f = Flown::get().file;
  std::uint32_t missiles = 0, locked = 0;
  for (const auto& [id, o] : f.objects) {
    if (o.last("Type") != "Weapon+Missile")
      continue;
    ++missiles;
    const auto parent = f.objects.find(hex(o.last("Parent")));
    ASSERT_NE(parent, f.objects.end());
    EXPECT_EQ(parent->second.last("Type"), "Air+FixedWing");
    EXPECT_EQ(parent->second.last("Color"), o.last("Color"));
    const auto first = o.updates.front().properties;
    for (const char* key : {"T", "Type", "Name", "Parent", "Color", "Coalition"})
      EXPECT_TRUE(first.contains(key)) << key;
    if (first.contains("LockedTarget")) {
      ++locked;
      EXPECT_TRUE(f.objects.contains(hex(first.at("LockedTarget"))));
    }
    for (const auto& update : o.updates)
      if (const auto lock = update.properties.find("LockedTarget");
          lock != update.properties.end()) {
        EXPECT_EQ(lock->second, first.at("LockedTarget")) << std::hex << id;
      }
    ASSERT_TRUE(o.removed) << std::hex << id;
    EXPECT_GT(*o.removed, o.updates.front().time);
    // with a Timeout event that names it, at the same time
    int said = 0;
    for (const AcmiEvent& e : f.events)
      if (e.type == "Timeout" && !e.parts.empty() && e.time == *o.removed) {
        std::map<std::string, std::string> fields;
        for (const std::string& part : e.parts)
          fields[part.substr(0, part.find(':'))] = part.substr(part.find(':') + 1);
        if (hex(fields.at("SourceId")) == id) {
          ++said;
          EXPECT_TRUE(fields.at("Outcome") == "Kill" || fields.at("Outcome") == "Miss");
        }
      }
    EXPECT_EQ(said, 1);
  }
  EXPECT_GT(missiles, 0U);
  EXPECT_GT(locked, 0U);
  const auto& sides = Flown::get().report["sides"];
  EXPECT_GE(
      sides["blue"]["shots"].get<std::uint32_t>() + sides["red"]["shots"].get<std::uint32_t>(),
      missiles)
      << "shots are missiles and bursts";
}

TEST(AcmiFile, TellsLossesFromLandings) {
  const Acmi& f = Flown::get().file;
  const auto& sides = Flown::get().report["sides"];
  std::uint32_t destroyed = 0, left = 0;
  for (const auto& [id, o] : f.objects) {
    if (o.last("Type") != "Air+FixedWing")
      continue;
    int said_destroyed = 0, said_left = 0;
    for (const AcmiEvent& e : f.events) {
      if ((e.type != "Destroyed" && e.type != "LeftArea") || hex(e.parts.at(0)) != id)
        continue;
      said_destroyed += e.type == "Destroyed";
      said_left += e.type == "LeftArea";
      ASSERT_TRUE(o.removed);
      EXPECT_EQ(e.time, *o.removed) << "told in the frame that removes it";
    }
    EXPECT_LE(said_destroyed + said_left, 1) << o.last("CallSign");
    EXPECT_EQ(said_destroyed + said_left == 1, o.removed.has_value()) << o.last("CallSign");
    destroyed += said_destroyed > 0;
    left += said_left > 0;
  }
  EXPECT_EQ(destroyed, sides["blue"]["losses"].get<std::uint32_t>() +
                           sides["red"]["losses"].get<std::uint32_t>());
  EXPECT_EQ(left,
            sides["blue"]["home"].get<std::uint32_t>() + sides["red"]["home"].get<std::uint32_t>());
  EXPECT_GT(destroyed, 0U);
  EXPECT_GT(left, 0U);
}

TEST(AcmiFile, ShowsLocksAndPhases) {
  const Acmi& f = Flown::get().file;
  bool lock = false, unlock = false;
  for (const auto& [id, o] : f.objects) {
    if (o.last("Type") != "Air+FixedWing")
      continue;
    for (const AcmiUpdate& u : o.updates) {
      if (!u.properties.contains("LockedTarget"))
        continue;
      const std::uint64_t target = hex(u.properties.at("LockedTarget"));
      EXPECT_EQ(u.properties.at("LockedTargetMode"), target ? "1" : "0");
      EXPECT_TRUE(target == 0 || f.objects.contains(target));
      lock |= target != 0;
      unlock |= target == 0;
    }
  }
  EXPECT_TRUE(lock);
  EXPECT_TRUE(unlock);
  std::set<std::string> messages;
  for (const AcmiEvent& e : f.events)
    if (e.type == "Message")
      messages.insert(e.parts.at(1));
  for (const char* phase : {"ingress", "bvr"})
    EXPECT_TRUE(messages.contains(std::string("eagle1: ") + phase)) << phase;
}

TEST(AcmiFile, TellsTheStoryAsMessagesAndMarksItsKeyMoments) {
  const Acmi& f = Flown::get().file;
  std::map<std::string, std::size_t> messages, bookmarks;
  const std::array words{"commit on ", "fox 3 on ", "pitbull on ", "defending: ", "splash "};
  for (const AcmiEvent& e : f.events) {
    if (e.type != "Message" && e.type != "Bookmark")
      continue;
    ASSERT_EQ(e.parts.size(), 2U);
    const auto who = f.objects.find(hex(e.parts[0]));
    ASSERT_NE(who, f.objects.end());
    if (e.type == "Bookmark") {
      EXPECT_TRUE(e.parts[1].starts_with(who->second.last("CallSign") + ": ")) << e.parts[1];
    }
    for (const char* word : words)
      if (e.parts[1].find(word) != std::string::npos)
        ++(e.type == "Message" ? messages : bookmarks)[word];
  }
  for (const char* word : words)
    EXPECT_GT(messages[word], 0U) << word;
  std::size_t launched = 0;
  for (const auto& [id, o] : f.objects)
    launched += o.last("Type") == "Weapon+Missile";
  EXPECT_EQ(messages["fox 3 on "], launched);
  for (const char* word : {"commit on ", "fox 3 on ", "defending: ", "splash "})
    EXPECT_EQ(bookmarks[word], messages[word]) << word;
  EXPECT_EQ(bookmarks["pitbull on "], 0U) << "a mark on everything marks nothing";
}

}  // namespace
}  // namespace eyrie::test
