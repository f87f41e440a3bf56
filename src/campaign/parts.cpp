// SPDX-License-Identifier: MIT
#include "campaign/parts.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "core/diagnostics.hpp"

namespace eyrie::campaign {

std::string part_folder(const std::string& folder, const Part& part) {
  return fmt::format("{}/{}{}_of_{}", folder, kPartName, part.index + 1, part.of);
}

std::uint64_t parts_in(const std::string& folder) {
  std::uint64_t all = 0;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename();
    const std::size_t at = name.rfind('_') + 1;
    std::uint64_t of = 0;
    std::from_chars(name.data() + at, name.data() + name.size(), of);
    if (!name.starts_with(kPartName) || of == 0)
      continue;
    if (all != 0 && all != of)
      throw disk::Refused(
          fmt::format("{} holds parts of {} and parts of {}", quote_path(folder), all, of));
    all = of;
  }
  return all;
}

std::vector<std::string> whole_parts(const std::string& folder, const Spec& spec, std::size_t cells,
                                     const Origin& origin) {
  std::vector<std::string> folders;
  std::string tasks, missing;
  const std::uint64_t of = parts_in(folder);
  for (Part part{0, of}; part.index < of; ++part.index) {
    std::uint64_t most = 0, flown = 0;
    for (std::size_t cell = 0; cell < cells; ++cell)
      most += part.count(cell, most_replicates(spec));
    const std::string own = part_folder(folder, part);
    if (std::filesystem::exists(fmt::format("{}/{}", own, kStoreName))) {
      Database results(fmt::format("{}/{}", own, kStoreName), Database::Access::read);
      if (begun(results)) {
        demand_the_same(results, origin_of(origin, part), own);
        Statement counted = results.prepare("SELECT count(*) FROM replicates");
        flown = counted.step() ? static_cast<std::uint64_t>(counted.integer(0)) : 0;
        folders.push_back(own);
      }
    }
    if (flown < most) {
      tasks += fmt::format("{}{}", tasks.empty() ? "" : ",", part.index + 1);
      missing += fmt::format("\n  part {} has {} of {} replicates", part.text(), flown, most);
    }
  }
  if (of == 0)
    throw disk::Refused(fmt::format("there is no part of a campaign in {}", quote_path(folder)));
  if (!missing.empty())
    throw disk::Refused(fmt::format("{} has not all parts yet; fly what is missing (--array={}){}",
                                    quote_path(folder), tasks, missing));
  return folders;
}

}  // namespace eyrie::campaign
