// SPDX-License-Identifier: MIT
#include "support/data_file.hpp"

#include <fstream>
#include <iterator>
#include <utility>

#include "core/yaml.hpp"

namespace eyrie::test {

Value read_data_file(const std::string& path) {
  std::ifstream in(path);
  if (!in)
    throw std::runtime_error("cannot read " + path);
  Diagnostics diagnostics;
  Value value = parse_yaml(std::string(std::istreambuf_iterator<char>(in), {}), path, diagnostics);
  if (!diagnostics.ok())
    throw std::runtime_error(diagnostics.text());
  if (!value.find("base"))
    return value;
  // a name in the same folder
  const std::string below =
      path.substr(0, path.rfind('/') + 1) + value.find("base")->text + ".yaml";
  std::erase_if(value.entries, [](const Value::Entry& e) { return e.key == "base"; });
  return merged(read_data_file(below), value);
}

}  // namespace eyrie::test
