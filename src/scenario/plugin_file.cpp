// SPDX-License-Identifier: MIT
#include "scenario/plugin_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <system_error>

#include "core/hash.hpp"

namespace eyrie::scenario {

std::optional<std::uint64_t> hash_of_file(const std::string& path) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed))
    return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in)
    return std::nullopt;
  return hash_bytes(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

}  // namespace eyrie::scenario
