// SPDX-License-Identifier: MIT
#include "core/assert.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
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
  throw std::logic_error(fmt::format("{}:{}: {} ({})", short_path(file), line, words, condition));
}

}  // namespace eyrie::detail
