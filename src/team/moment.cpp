// SPDX-License-Identifier: MIT
#include "team/moment.hpp"

namespace eyrie::team {

const Underway*& underway() {
  static thread_local const Underway* now = nullptr;
  return now;
}

std::string exception_text() {
  try {
    throw;
  } catch (const std::exception& e) {
    return fmt::format("threw: {}", e.what());
  } catch (...) {
    return "threw something that is no std::exception";
  }
}

}  // namespace eyrie::team
