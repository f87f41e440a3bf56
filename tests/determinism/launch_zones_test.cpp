// SPDX-License-Identifier: MIT
/// \file  The launch zones that the build has flown are, bit by bit, those that a load would fly.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "model/weapon/kept_zones.hpp"
#include "scenario/data.hpp"
#include "support/program.hpp"

namespace eyrie {
namespace {

TEST(LaunchZones, OfEveryShippedMissileAreKeptAsTheyAreFlown) {
  if (!std::filesystem::exists(EYRIE_ZONES))
    GTEST_SKIP() << "built for another machine";
  model::weapon::KeptZones kept;
  scenario::Source source = scenario::Source::disk(".");
  const auto names = source.data_names("missiles");
  EXPECT_EQ(kept.take(test::read_text(EYRIE_ZONES)), names.size());
  for (const std::string& name : names) {
    model::Library library;
    Diagnostics diagnostics;
    scenario::DataLoader loader(library, nullptr, source, diagnostics);
    const auto index = loader.missile(name, {});
    ASSERT_TRUE(index) << diagnostics.text();
    const model::MissileType& type = library.missiles[*index];
    EXPECT_TRUE(*kept.of(type).table() == model::weapon::fly_zone(type)) << name;
  }
  EXPECT_EQ(kept.flown(), 0U);
}

}  // namespace
}  // namespace eyrie
