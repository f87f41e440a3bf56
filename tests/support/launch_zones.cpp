// SPDX-License-Identifier: MIT
/// \file  Linked into whatever loads scenarios: the launch zones of data/zones are at hand, as they
/// are for the program.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "model/weapon/kept_zones.hpp"

namespace {

class LaunchZones : public testing::Environment {
 public:
  void SetUp() override {
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator("data/zones", failed)) {
      std::ifstream file(entry.path(), std::ios::binary);
      eyrie::model::weapon::kept_zones().take(
          std::string(std::istreambuf_iterator<char>(file), {}));
    }
  }
};
const auto* const kZones = testing::AddGlobalTestEnvironment(new LaunchZones);

}  // namespace
