// SPDX-License-Identifier: MIT
#pragma once
/// \file  What the commands of campaigns and searches share: what is flown, and what came of it on
/// a terminal, in JSON and in a page.
#include <cmath>
#include <nlohmann/json.hpp>

#include "campaign/store.hpp"
#include "campaign/summary.hpp"
#include "record/story.hpp"

namespace eyrie::app {

/// What one is flown with: read once, when it begins. From then on nothing on the disk matters.
class CampaignSource {
 public:
  /// Reads everything that any cell needs, and checks it; `typed` plug-ins are added to the spec.
  /// Throws ConfigError.
  CampaignSource(campaign::Spec& spec, const std::vector<std::string>& typed,
                 const std::vector<std::string>& includes);

  /// For any number of threads; the source must outlive it.
  [[nodiscard]] campaign::Load load() const;
  [[nodiscard]] const campaign::Origin& origin() const { return origin_; }
  [[nodiscard]] std::uint64_t hash() const;                                ///< of the origin
  [[nodiscard]] const std::string& scenario() const { return scenario_; }  ///< file
  [[nodiscard]] scenario::Source files() const { return scenario::Source::bundle(files_); }

 private:
  std::string scenario_;  ///< key in `files_`
  std::vector<std::string> plugins_;
  std::map<std::string, std::string> files_;
  campaign::Origin origin_;
};

/// The debrief page inside a campaign's report, in which every replicate is flown again.
struct CampaignDebrief {
  std::string page;     ///< base64 of a zlib stream; empty if there is a problem
  std::string problem;  ///< why no replicate can be flown in the report
};
[[nodiscard]] CampaignDebrief campaign_debrief(const std::string& folder,
                                               const std::vector<std::string>& plugins);

/// "14 s", "3 min", "2 h 05 min"
[[nodiscard]] std::string duration_text(double seconds);

/// A row per cell with every measure and its interval, and the first faults.
void print_cells(const campaign::Summary& summary);
/// So many of them, the surest first.
void print_comparisons(const campaign::Summary& summary,
                       const std::vector<campaign::Comparison>& comparisons, std::size_t most);
void print_effects(const campaign::Summary& summary, const std::vector<campaign::Effect>& effects,
                   const std::vector<campaign::Interaction>& interactions);

[[nodiscard]] inline nlohmann::ordered_json number_or_null(double x) {
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json();
}

/// A flight of many, with `more` between how it ended and its fault.
[[nodiscard]] inline nlohmann::ordered_json flown_json(const campaign::Flown& flown,
                                                       const nlohmann::ordered_json& more) {
  nlohmann::ordered_json json{{"seed", flown.seed},
                              {"outcome", enum_name(flown.outcome)},
                              {"time_s", flown.time},
                              {"steps", flown.steps},
                              {"hash", hash_text(flown.hash)}};
  json.update(more);
  if (!flown.fault.empty())
    json["fault"] = flown.fault;
  return json;
}
[[nodiscard]] inline nlohmann::ordered_json side_json(const record::Tally::OfSide& s) {
  return {{"losses", s.losses}, {"shots", s.shots}, {"kills", s.kills}, {"home", s.home}};
}
/// [low, high], null for what there is not.
[[nodiscard]] inline nlohmann::ordered_json interval_json(const std::optional<stats::Interval>& i) {
  if (!i)
    return {nullptr, nullptr};
  return {number_or_null(i->low), number_or_null(i->high)};
}

/// [value, low, high, n], null for what there is not; n replicates have the measure.
[[nodiscard]] inline nlohmann::ordered_json estimate_json(const campaign::Estimate& e) {
  const nlohmann::ordered_json ends = interval_json(e.interval);
  return {e.value ? number_or_null(*e.value) : nullptr, ends[0], ends[1], e.n};
}

}  // namespace eyrie::app
