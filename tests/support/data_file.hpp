// SPDX-License-Identifier: MIT
#pragma once
/// \file  Reads the files of data/ in tests of layers below the one that loads scenarios.
#include <stdexcept>
#include <string>

#include "core/bind.hpp"
#include "core/diagnostics.hpp"
#include "core/value.hpp"

namespace eyrie::test {

/// The file as a value, on top of its `base`; throws with a message when it cannot be read.
[[nodiscard]] Value read_data_file(const std::string& path);

/// Paths are relative to the root of the source tree, where tests run.
/// `const auto missile = test::load<MissileType>("data/missiles/aim120.yaml");` Throws with every
/// mistake of the file.
template <Described T>
[[nodiscard]] T load(const std::string& path) {
  T result;
  Diagnostics diagnostics;
  if (!bind(result, read_data_file(path), diagnostics))
    throw std::runtime_error(diagnostics.text());
  return result;
}

}  // namespace eyrie::test
