// SPDX-License-Identifier: MIT
#pragma once
/// \file  The command line: what the options of several commands share; what --help, the manual
/// page and the completion of shells say, all of the same texts; and what is said to a line that
/// was typed wrongly. For main.cpp and its like alone: CLI11 is slow to compile.
#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <span>

#include "arguments.hpp"
#include "commands.hpp"

namespace eyrie::app {

/// What the user asked for, once the line is parsed.
using Chosen = std::function<int()>;

/// The options of a command, there as long as the line; `run` is what is done with them.
template <class Options>
Options& options_of(CLI::App* command, int (*run)(const Options&), Chosen& chosen) {
  const auto options = std::make_shared<Options>();
  command->callback([=, &chosen] { chosen = [=] { return run(*options); }; });
  return *options;
}

/// To be given to transform().
inline CLI::Validator number(std::uint64_t least, std::uint64_t most) {
  return {whole_number(least, most), ""};
}
inline void add_workers(CLI::App* app, unsigned& workers) {
  app->add_option("--workers", workers, "flights at a time; never the result (default: all cores)")
      ->transform(number(1, 1024));
}
inline void add_plugins(CLI::App* app, std::vector<std::string>& plugins, const char* help) {
  app->add_option("--plugin", plugins, help)->allow_extra_args(false);
}
inline void add_includes(CLI::App* app, std::vector<std::string>& folders) {
  app->add_option("--allow-include", folders,
                  "a folder that the scenario may include files from, besides its own")
      ->allow_extra_args(false);
}
inline constexpr const char* kPluginHelp =
    "a shared library with more behaviors, arbiters and models";

// Of campaigns and searches.
void add_campaign(CLI::App& app, Chosen& chosen);
void add_report(CLI::App& app, Chosen& chosen);
void add_query(CLI::App& app, Chosen& chosen);
void add_optimize(CLI::App& app, Chosen& chosen);

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
