// SPDX-License-Identifier: MIT
#pragma once
/// \file  What is said to a line that was typed wrongly. For main.cpp alone: CLI11 is slow to
/// compile.
#include <CLI/CLI.hpp>
#include <span>

namespace eyrie::app {

/// From now on no flag of a command takes a value, as in --quiet=false.
void refuse_flag_values(CLI::App& app);
/// What is wrong with "help fly extra", of which `words` are "eyrie fly --help extra"; or "".
[[nodiscard]] std::string word_behind_help(const CLI::App& app, std::span<char*> words);
/// Says what is wrong with a line, shortly whatever was typed. The exit code.
[[nodiscard]] int say_wrong(const CLI::App& app, std::span<char*> words, std::string_view problem);
/// Says help or version, or what is wrong with a line. The exit code.
[[nodiscard]] int say_mistake(const CLI::App& app, const CLI::ParseError& e,
                              std::span<char*> words);

}  // namespace eyrie::app
