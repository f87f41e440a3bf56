// SPDX-License-Identifier: MIT
/// \file  Flies the launch zones of every missile in data/ while Eyrie is built and writes them
/// into one file, so that no load has to. usage: launch_zones HOME FILE
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "model/weapon/kept_zones.hpp"
#include "scenario/data.hpp"

int main(int argc, char** argv) {
  using namespace eyrie;
  if (argc != 3) {
    std::fprintf(stderr, "usage: launch_zones HOME FILE\n");
    return 2;
  }
  // a missile with a mistake is left out: whoever loads it is told
  scenario::Source source = scenario::Source::disk(argv[1]);
  std::vector<model::MissileType> types;
  for (const std::string& name : source.data_names("missiles")) {
    model::Library library;
    Diagnostics ignored;
    scenario::DataLoader loader(library, nullptr, source, ignored);
    if (const auto index = loader.missile(name, {}))
      types.push_back(library.missiles[*index]);
  }
  std::ofstream file(argv[2], std::ios::binary | std::ios::trunc);
  file << model::weapon::kept_zones().encode(types);
  if (!file.flush()) {
    std::fprintf(stderr, "launch_zones: cannot write %s\n", argv[2]);
    return 1;
  }
}
