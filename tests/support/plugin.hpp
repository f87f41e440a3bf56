// SPDX-License-Identifier: MIT
#pragma once
/// \file  The plug-ins that are built for tests: tests/plugins.
#include <filesystem>
#include <string>
#include <string_view>

namespace eyrie::test {

/// The path of tests/plugins/<name>, as it was built beside this test.
[[nodiscard]] inline std::string plugin(std::string_view name) {
  const auto self = std::filesystem::read_symlink("/proc/self/exe");
  return self.parent_path() / "plugins" / ("lib" + std::string(name) + ".so");
}

}  // namespace eyrie::test
