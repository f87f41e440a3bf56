// SPDX-License-Identifier: MIT
/// \file  The folders of the parts of a campaign.
#include <filesystem>

#include "campaign/store.hpp"
#include "core/diagnostics.hpp"

namespace eyrie::campaign {

namespace {

/// "part_3_of_16": 16; 0 of another name.
std::uint64_t parts_of(std::string_view name) {
  if (!name.starts_with(kPartName))
    return 0;
  const auto part = two_numbers(name.substr(std::string_view(kPartName).size()), "_of_");
  return part && part->first >= 1 && part->first <= part->second && part->second <= Part::kMost
             ? part->second
             : 0;
}

}  // namespace

std::string part_folder(const std::string& folder, const Part& part) {
  return fmt::format("{}/{}{}_of_{}", folder, kPartName, part.index + 1, part.of);
}

std::uint64_t parts_in(const std::string& folder) {
  std::uint64_t all = 0;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    const std::uint64_t of = parts_of(entry.path().filename().string());
    if (of == 0)
      continue;
    if (all != 0 && all != of)
      throw disk::Refused("{} holds parts of {} and parts of {}", quote_path(folder), all, of);
    all = of;
  }
  return all;
}

std::vector<std::string> whole_parts(const std::string& folder, const Spec& spec, std::size_t cells,
                                     const Origin& origin) {
  std::vector<std::string> folders;
  constexpr int kMostLines = 50;
  int lines = 0;
  std::string tasks, missing;
  const std::uint64_t of = parts_in(folder);
  for (Part part{0, of}; part.index < of; ++part.index) {
    std::uint64_t most = 0, flown = 0;
    for (std::size_t cell = 0; cell < cells; ++cell)
      most += part.count(cell, most_replicates(spec));
    const std::string own = part_folder(folder, part);
    if (const std::string file = fmt::format("{}/{}", own, kStoreName);
        std::filesystem::exists(file)) {
      Database results(file, Database::Access::read);
      results.distrust();
      if (begun(results)) {
        demand_the_same(results, origin_of(origin, part), own);
        demand_unchanged(results, file);
        Statement counted = results.prepare("SELECT count(*) FROM replicates");
        flown = counted.step() ? static_cast<std::uint64_t>(counted.integer(0)) : 0;
        folders.push_back(own);
      }
    }
    if (flown < most) {
      tasks += fmt::format("{}{}", tasks.empty() ? "" : ",", part.index + 1);
      if (++lines <= kMostLines)
        missing += fmt::format("\n  part {} has {} of {} replicates", part.text(), flown, most);
    }
  }
  if (of == 0)
    throw disk::Refused("there is no part of a campaign in {}", quote_path(folder));
  if (lines > kMostLines)
    missing += fmt::format("\n  and {} more", lines - kMostLines);
  if (!missing.empty())
    throw disk::Refused("{} has not all parts yet; fly what is missing (--array={}){}",
                        quote_path(folder), tasks, missing);
  return folders;
}

}  // namespace eyrie::campaign
