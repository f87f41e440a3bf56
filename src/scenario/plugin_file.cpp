// SPDX-License-Identifier: MIT
#include "scenario/plugin_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "core/hash.hpp"
#include "disk/read_file.hpp"

namespace eyrie::scenario {

FileBytes read_plugin_file(const std::string& path) {
  disk::FileRead read = disk::read_file(path, kLargestPlugin);
  if (read.problem.empty())
    return {std::move(read.bytes), {}};
  return {{}, read.missing ? read.problem : "it " + read.problem};
}

std::uint64_t hash_of(std::string_view bytes) {
  return hash_bytes(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

std::optional<std::uint64_t> hash_of_file(const std::string& path) {
  const FileBytes file = read_plugin_file(path);
  return file.problem.empty() ? std::optional(hash_of(file.bytes)) : std::nullopt;
}

std::string shell_word(std::string_view path) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("/._-+:@%=,").find(c) != std::string_view::npos;
  };
  const auto shown = [](char c) { return c >= ' ' && c <= '~'; };
  if (!path.empty() && std::all_of(path.begin(), path.end(), plain))
    return std::string(path);
  const bool all_shown = std::all_of(path.begin(), path.end(), shown);
  std::string word = all_shown ? "'" : "$'";
  for (const char c : path) {
    if (all_shown && c == '\'')
      word += "'\\''";
    else if (!all_shown && (c == '\'' || c == '\\'))
      (word += '\\') += c;
    else if (shown(c))
      word += c;
    else
      fmt::format_to(std::back_inserter(word), "\\x{:02x}", static_cast<unsigned char>(c));
  }
  return word + "'";
}

}  // namespace eyrie::scenario
