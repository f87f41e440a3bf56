// SPDX-License-Identifier: MIT
/// \file  What a reader gets who joins a recording while it is written.
#include <gtest/gtest.h>

#include "record/acmi.hpp"
#include "support/acmi_reader.hpp"
#include "support/flight.hpp"

namespace eyrie::test {
namespace {

using Properties = std::map<std::string, std::string>;

/// Every property as it stands in the end, but the place.
Properties last_of(const AcmiObject& object) {
  Properties all;
  for (const AcmiUpdate& update : object.updates)
    for (const auto& [key, value] : update.properties)
      if (key != "T")
        all[key] = value;
  return all;
}

using Ways = std::vector<std::pair<double, std::array<double, 9>>>;
Ways way_from(const AcmiObject& object, double time) {
  Ways way;
  for (const AcmiSample& sample : object.samples)
    if (sample.time >= time)
      way.emplace_back(sample.time, sample.fields);
  return way;
}

std::vector<std::string> told_after(const Acmi& file, double time) {
  std::vector<std::string> all;
  for (const AcmiEvent& event : file.events)
    if (event.time > time)
      all.push_back(event.type + (event.parts.empty() ? "" : " " + event.parts.back()));
  return all;
}

TEST(AcmiWhole, LeadsWhoeverJoinsToWhatTheOthersHave) {
  const auto scenario = load_scenario("sweep");
  std::string text;
  std::vector<std::string> late;
  std::size_t parts = 0;
  record::AcmiWriter writer(
      *scenario,
      [&](std::string_view lines) {
        text += lines;
        for (std::string& one : late)
          one += lines;
        if (parts++ % 30 == 0)
          late.push_back(writer.whole());
      },
      record::AcmiWriter::kWatched);
  scenario::Mission mission(scenario, scenario->spec.seed);
  mission.run().attach(writer);
  mission.fly();

  ASSERT_GT(late.size(), 20u);
  EXPECT_EQ(late.front(), text) << "the beginning is all that there is";
  const Acmi file(text);
  std::size_t missiles = 0, locks = 0;
  for (const std::string& one : late) {
    const Acmi stream(one);
    const double begun = stream.frames.front();
    EXPECT_EQ(stream.globals, file.globals);
    EXPECT_EQ(told_after(stream, begun), told_after(file, begun));
    for (const auto& [id, object] : file.objects) {
      const bool there = !object.removed || *object.removed > begun;
      ASSERT_EQ(stream.objects.contains(id), there) << begun << " " << id;
      if (!there)
        continue;
      const AcmiObject& seen = stream.objects.at(id);
      EXPECT_EQ(last_of(seen), last_of(object)) << begun << " " << id;
      EXPECT_EQ(way_from(seen, begun), way_from(object, begun)) << begun << " " << id;
      EXPECT_EQ(seen.removed, object.removed);
      missiles += object.last("Type") == "Weapon+Missile" && object.updates.front().time < begun;
      locks += seen.updates.front().time == begun &&
               seen.updates.front().properties.contains("LockedTarget");
    }
  }
  EXPECT_GT(missiles, 0u) << "somebody joined while one flew";
  EXPECT_GT(locks, 0u);
}

}  // namespace
}  // namespace eyrie::test
