// SPDX-License-Identifier: MIT
#include "core/assert.hpp"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

namespace eyrie::detail {
namespace {

/// The path as people of this project write it ("src/core/vec.hpp"), wherever it was built.
std::string_view short_path(std::string_view file) {
  const std::size_t at = file.rfind("/src/");
  return at == std::string_view::npos ? file : file.substr(at + 1);
}

}  // namespace

void assertion_failed(const char* condition, const char* words, const char* file,
                      int line) noexcept {
  const std::string_view path = short_path(file);
  std::fprintf(stderr, "%.*s:%d: %s (%s)\n", static_cast<int>(path.size()), path.data(), line,
               words, condition);
  std::fflush(stderr);
  std::abort();
}

void misuse(const char* condition, const char* words, const char* file, int line) {
  std::string text(short_path(file));
  text += ':';
  text += std::to_string(line);
  text += ": ";
  text += words;
  text += " (";
  text += condition;
  text += ')';
  throw std::logic_error(text);
}

}  // namespace eyrie::detail
