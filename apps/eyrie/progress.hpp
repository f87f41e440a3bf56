// SPDX-License-Identifier: MIT
#pragma once
/// \file  A line on a terminal: how far, how fast, how long still. Nothing elsewhere, and nothing
/// of it stays.
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace eyrie::app {

class Progress {
 public:
  /// `what` is counted to `total`: "seeds".
  Progress(std::string_view what, std::uint64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `more` stands behind it. Draws ten times a second at most.
  void at(std::uint64_t done, std::string_view more = {});
  /// Whether anybody sees it: what `more` costs may be saved.
  [[nodiscard]] bool due() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::uint64_t total_;
  bool shown_, drawn_ = false;
  Clock::time_point begun_ = Clock::now(), last_ = begun_;
};

}  // namespace eyrie::app
