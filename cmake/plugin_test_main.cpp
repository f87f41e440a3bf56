// SPDX-License-Identifier: MIT
/// \file  Begins the test of a plug-in (eyrie_add_plugin): what it adds is known to decide().
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "pilot/testing.hpp"
#include "scenario/plugin.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  eyrie::scenario::Registries registries{.pilots = eyrie::pilot::testing::registry()};
  eyrie::scenario::Registrar registrar(registries, "the plug-in");
  eyrie_plugin.add(registrar);
  for (const std::string& problem : registrar.problems())
    std::fprintf(stderr, "%s\n", problem.c_str());
  if (!registrar.problems().empty())
    return 2;
  eyrie::pilot::testing::registry() = registries.pilots;
  // the library of pilot/testing.hpp reads data/ from here
  std::filesystem::current_path(EYRIE_SHARE);
  return RUN_ALL_TESTS();
}
