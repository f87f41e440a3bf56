// SPDX-License-Identifier: MIT
#pragma once
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "core/bind.hpp"
#include "core/yaml.hpp"

namespace eyrie::evidence {

/// A file of data/ over its bases, by its path below the home folder.
inline Value document(const std::string& home, const std::string& path, Diagnostics& diagnostics) {
  std::ifstream file(home + "/" + path);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  Value value = parse_yaml(text, path, diagnostics);
  if (!value.find("base"))
    return value;
  const std::string below =
      path.substr(0, path.rfind('/') + 1) + value.find("base")->text + ".yaml";
  std::erase_if(value.entries, [](const Value::Entry& e) { return e.key == "base"; });
  return merged(document(home, below, diagnostics), value);
}

/// A model of data/; throws with all its mistakes.
template <Described T>
T load(const std::string& home, const std::string& path) {
  Diagnostics diagnostics;
  T result;
  const Value value = document(home, path, diagnostics);
  if (!diagnostics.ok() || !bind(result, value, diagnostics))
    throw std::runtime_error(diagnostics.text());
  return result;
}

}  // namespace eyrie::evidence
