// SPDX-License-Identifier: MIT
/// \file  The launch zones of data/zones are, bit by bit, those that a load would fly.
#include <gtest/gtest.h>

#include <string>

#include "model/weapon/kept_zones.hpp"
#include "scenario/data.hpp"
#include "support/program.hpp"

namespace eyrie {
namespace {

TEST(LaunchZones, OfEveryShippedMissileAreKeptAsTheyAreFlown) {
  scenario::Source source = scenario::Source::disk(".");
  for (const std::string& name : source.data_names("missiles")) {
    model::weapon::KeptZones kept;
    EXPECT_EQ(kept.take(test::read_text("data/zones/" + name + ".zone")), 1U) << name;
    model::Library library;
    Diagnostics diagnostics;
    scenario::DataLoader loader(library, nullptr, source, diagnostics);
    const auto index = loader.load<model::MissileType>(name, {});
    ASSERT_TRUE(index) << diagnostics.text();
    const model::MissileType& type = library.missiles[*index];
    const auto table = kept.of(type).table();
    EXPECT_EQ(kept.flown(), 0U) << "'eyrie zones " << name << "' makes it anew";
    EXPECT_TRUE(*table == model::weapon::fly_zone(type, 3)) << name;
  }
}

}  // namespace
}  // namespace eyrie
