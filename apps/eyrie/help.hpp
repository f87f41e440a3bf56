// SPDX-License-Identifier: MIT
#pragma once
/// \file  What --help, the manual page and the completion of shells say, all of the same texts. For
/// main.cpp alone: CLI11 is slow to compile.
#include <CLI/CLI.hpp>
#include <span>

namespace eyrie::app {

/// The commands of the program, or what is below one.
[[nodiscard]] inline std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

[[nodiscard]] std::vector<std::string> command_names(const CLI::App& app);
/// Null if there is none.
[[nodiscard]] const CLI::App* command_named(const CLI::App& app, std::string_view name);

/// "[SCENARIO] [options]"
[[nodiscard]] std::string usage_of(const CLI::App& app);

/// From now on --help is in our words: what options take, their texts, examples.
void set_help(CLI::App& app);

/// The command that prints what a shell sources, and eyrie.1.
void add_completion(CLI::App& app, std::function<int()>& chosen);
/// How the last of the words behind "eyrie" may go on, a line each; none: by the name of a file.
[[nodiscard]] std::string completions(const CLI::App& app, std::span<char*> words);

}  // namespace eyrie::app
