// SPDX-License-Identifier: MIT
#pragma once
/// \file  The home page of `serve`: which scenarios there are, which runs, and what somebody chose.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "live/mailbox.hpp"
#include "net/web_host.hpp"

namespace eyrie::app {

/// What is to be flown.
struct Choice {
  std::shared_ptr<const scenario::Scenario> scenario;
  std::optional<std::uint64_t> seed;
};

/// Makes a site the home page, with the debrief pages of the runs in runs/.
class Home {
 public:
  /// `linked`: others are heard by DIS; `ours`: an override that holds for each scenario, or none.
  Home(bool linked, std::vector<std::string> ours) : linked_(linked), ours_(std::move(ours)) {}
  /// The thread of the network uses it as long as there is a host of that site.
  /// `problem`: why what was chosen last could not be flown, or "".
  void furnish(net::WebOptions& site, std::string_view problem);
  /// Until somebody has chosen a scenario that can be flown; nothing if it was interrupted.
  [[nodiscard]] std::optional<Choice> ask(net::WebHost& host);

 private:
  struct Wish {
    net::ViewerId who = 0;
    std::string scenario, seed;
    std::vector<std::string> sets;
  };
  std::string hear(net::ViewerId who, std::string_view text);
  [[nodiscard]] std::string problem(const Wish& wish, Choice& chosen) const;

  bool linked_;
  std::vector<std::string> ours_;
  std::vector<std::string> names_;  ///< of the scenarios
  std::string scenarios_;           ///< what the page is told of them
  live::Mailbox<Wish> wishes_{16};
};

}  // namespace eyrie::app
