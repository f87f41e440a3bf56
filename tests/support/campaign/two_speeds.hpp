// SPDX-License-Identifier: MIT
#pragma once
/// \file  A small campaign through the real program, in a folder of its own.
#include <gtest/gtest.h>

#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {

inline constexpr const char* kCampaign = R"(eyrie: 1
name: two speeds
scenario: small.yaml
factors:
  speed: {path: blue.flights.eagle.start.speed, values: [400 kt, 480 kt]}
replicates: 40
measures:
  end: {what: end_time}
  losses: {what: losses, who: blue}
)";

/// The campaign with one piece of its text for another.
inline std::string changed(const Change& change) {
  std::string text = kCampaign;
  text.replace(text.find(change.from), change.from.size(), change.to);
  return text;
}

class Campaign : public testing::Test {
 protected:
  Campaign() {
    folder.write("small.yaml", changed_scenario({{"until: 2 s", "until: 60 s"}}));
    folder.write("c.yaml", kCampaign);
  }
  [[nodiscard]] Ran run(const std::string& out, std::vector<std::string> more = {},
                        const RunOptions& options = {}) const {
    more.insert(more.begin(), {"campaign", "c.yaml", "--out", out});
    return run_program(folder, more, options);
  }
  [[nodiscard]] std::string table(const std::string& out) const {
    return read_text(folder / out + "/results.csv");
  }
  static std::string hash_in(const Ran& ran) {
    const auto at = ran.out.find("campaign hash ");
    return at == ran.out.npos ? "none: " + ran.err : ran.out.substr(at, 32);
  }
  /// The table of a campaign that nobody disturbs.
  const std::string& undisturbed() const {
    if (undisturbed_.empty()) {
      EXPECT_EQ(run("undisturbed", {"--workers", "2"}).code, 0);
      undisturbed_ = table("undisturbed");
    }
    return undisturbed_;
  }

  TempFolder folder;

 private:
  mutable std::string undisturbed_;
};

}  // namespace eyrie::test
