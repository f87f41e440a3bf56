// SPDX-License-Identifier: MIT
#pragma once
/// \file  What an argument must be, in words.
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "commands.hpp"

namespace eyrie::app {

/// Each gives what is wrong with an argument, or an empty text.
[[nodiscard]] std::function<std::string(const std::string&)> whole_number(
    std::uint64_t least = 0, std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
/// A factor of real time.
[[nodiscard]] std::string pace(const std::string& text);
/// A format of `export`.
[[nodiscard]] std::string format_problem(const std::string& text);

[[nodiscard]] std::optional<ExportFormat> format_named(std::string_view name);

}  // namespace eyrie::app
