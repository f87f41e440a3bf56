// SPDX-License-Identifier: MIT
#include "campaign/again.hpp"

#include <filesystem>

#include "core/hash.hpp"

namespace eyrie::campaign {

Again::Again(Database& database, const std::vector<std::string>& plugins, unsigned workers)
    : database_(database) {
  Statement origin = database.prepare("SELECT name, text FROM origin");
  while (origin.step())
    files_[origin.text(0)] = origin.text(1);
  spec_ = parse_spec(files_[kCampaignText], "campaign.yaml");
  cells_ = cells_of(spec_);
  file_ = std::filesystem::path(spec_.scenario).replace_extension(".yaml").filename();
  scenarios_.emplace(
      spec_, cells_,
      [this, plugins](const std::vector<std::string>& sets) {
        return scenario::load({.file = file_, .sets = sets, .plugins = plugins},
                              scenario::Source::bundle(files_));
      },
      workers + 1);
}

std::vector<std::vector<std::string>> Again::sets() const {
  std::vector<std::vector<std::string>> all;
  for (const Cell& cell : cells_)
    all.push_back(sets_of(spec_, cell));
  return all;
}

std::vector<Again::Flight> Again::flights(const std::string& which, double parameter) {
  Statement found =
      database_.prepare("SELECT cell, replicate, seed, hash FROM (SELECT * FROM replicates " +
                        which + ") WHERE outcome <> 'fault' ORDER BY cell, replicate");
  found.with(parameter);
  std::vector<Flight> all;
  while (found.step()) {
    const auto whole = [&](int i) { return static_cast<std::uint64_t>(found.integer(i)); };
    all.push_back({whole(0), whole(1), whole(2), found.text(3)});
    if (all.back().cell >= cells_.size())
      throw disk::Refused("the results are damaged: there is no cell {}", all.back().cell);
  }
  return all;
}

void Again::demand_the_same(const Flight& flight, std::uint64_t hash) {
  if (hash_text(hash) != flight.hash)
    throw disk::Refused(
        "cell {}, replicate {} ends otherwise than it did: the campaign was flown by "
        "another program",
        flight.cell, flight.replicate);
}

}  // namespace eyrie::campaign
