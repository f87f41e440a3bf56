// SPDX-License-Identifier: MIT
#include "team/blame.hpp"

#include <fmt/format.h>

#include "ubf/behavior.hpp"

namespace eyrie::team {

const Underway*& underway() {
  static thread_local const Underway* now = nullptr;
  return now;
}

std::string exception_text() {
  try {
    throw;
  } catch (const ubf::BadVote& vote) {
    return fmt::format("votes what means nothing: {}", vote.what());
  } catch (const std::exception& e) {
    return fmt::format("threw: {}", e.what());
  } catch (...) {
    return "threw something that is no std::exception";
  }
}

ubf::NodeIndex exception_node() {
  try {
    throw;
  } catch (const ubf::BadVote& vote) {
    return vote.node();
  } catch (...) {
    return ubf::kNone;
  }
}

}  // namespace eyrie::team
