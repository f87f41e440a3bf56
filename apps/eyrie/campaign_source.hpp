// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a campaign or a search is flown with: read once, when it begins. From then on
/// nothing on the disk matters.
#include "campaign/store.hpp"

namespace eyrie::app {

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

}  // namespace eyrie::app
