// SPDX-License-Identifier: MIT
#pragma once
/// \file  The debrief page inside a campaign's report, in which every replicate is flown again.
#include <string>
#include <vector>

namespace eyrie::app {

struct CampaignDebrief {
  std::string page;     ///< base64 of a zlib stream; empty if there is a problem
  std::string problem;  ///< why no replicate can be flown in the report
};
[[nodiscard]] CampaignDebrief campaign_debrief(const std::string& folder,
                                               const std::vector<std::string>& plugins);

}  // namespace eyrie::app
