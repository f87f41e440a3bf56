// SPDX-License-Identifier: MIT
#pragma once
/// \file  A folder in which one process works at a time, and a later one goes on.
#include <functional>

#include "disk/file_system.hpp"

namespace eyrie::disk {

/// Locks the folder until the handle is closed; makes it, with its parents, if it is not there.
/// Throws Refused if something is in it and none of that `is_ours`, or it is and nobody asked to
/// `resume`, or another process works on it. `kind`: "campaign".
[[nodiscard]] Handle work_folder(const std::string& path, const char* kind,
                                 const std::function<bool(const std::string& name)>& is_ours,
                                 bool resume);

}  // namespace eyrie::disk
