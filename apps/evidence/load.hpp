// SPDX-License-Identifier: MIT
#pragma once
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "core/bind.hpp"
#include "core/yaml.hpp"

namespace eyrie::evidence {

/// A model of data/, by its file's path below the home folder; throws with all its mistakes.
template <Described T>
T load(const std::string& home, const std::string& path) {
  Diagnostics diagnostics;
  T result;
  std::ifstream file(home + "/" + path);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const Value value = parse_yaml(text, path, diagnostics);
  if (!diagnostics.ok() || !bind(result, value, diagnostics))
    throw std::runtime_error(diagnostics.text());
  return result;
}

}  // namespace eyrie::evidence
