// SPDX-License-Identifier: MIT
#pragma once

namespace eyrie {

/// Of the whole project. CMakeLists.txt reads it from this line.
inline constexpr const char* kVersion = "0.2.0";

/// Of the scenarios and campaigns that it reads: `eyrie:` says theirs.
inline constexpr int kFileFormat = 1;

}  // namespace eyrie
