// SPDX-License-Identifier: MIT
#pragma once
/// \file  Why something could not be written, in words for the user.
#include <stdexcept>
#include <string>

namespace eyrie::disk {

/// The machine's failure: a full disk, a folder that may not be written to.
struct Failed : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// The user's mistake: a place that is taken, that is none, or that may not be replaced.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A path in a message: "'runs/sweep-13'".
[[nodiscard]] std::string quoted(const std::string& path);

/// Throws that `path` cannot be made because of `error` of errno: Refused if there cannot be
/// anything of that name, Failed otherwise.
[[noreturn]] void cannot_make(const std::string& path, int error);

}  // namespace eyrie::disk
