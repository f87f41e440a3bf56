// SPDX-License-Identifier: MIT
#pragma once
/// \file  What is said to a line that was typed wrongly. For main.cpp alone: CLI11 is slow to
/// compile.
#include <CLI/CLI.hpp>
#include <span>

namespace eyrie::app {

/// Says what is wrong with a line, shortly whatever was typed. The exit code.
[[nodiscard]] int say_wrong(const CLI::App& app, std::span<char*> words, std::string_view problem);
/// Says help or version, or what is wrong with a line. The exit code.
[[nodiscard]] int say_mistake(const CLI::App& app, const CLI::ParseError& e,
                              std::span<char*> words);

}  // namespace eyrie::app
