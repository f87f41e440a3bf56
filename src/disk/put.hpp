// SPDX-License-Identifier: MIT
#pragma once
/// \file  A temporary comes to its place in one go: what was there before, or the new, never
/// neither.
#include <functional>
#include <string>

#include "disk/place.hpp"

namespace eyrie::disk {

/// How a move went: `error` is that of errno if it could not be made. Nothing is moved then.
struct Put {
  enum How { done, taken, failed } how = done;
  int error = 0;
};

/// Gives `from` the name `to` in the same folder; taken if there is anything of that name.
[[nodiscard]] Put put_new(int folder, const std::string& from, const std::string& to);

/// Swaps `from` and `to`: then `from` is what was there. Only if `expected` of what came out is
/// true; taken if not. Where a file system knows no swap there is a moment in which neither has the
/// name, and both stand beside it.
[[nodiscard]] Put put_instead(int folder, const std::string& from, const std::string& to,
                              const std::function<bool(const struct stat&)>& expected);

}  // namespace eyrie::disk
