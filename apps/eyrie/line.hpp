// SPDX-License-Identifier: MIT
#pragma once
/// \file  What the options of several commands share. For main.cpp and its like alone: CLI11 is
/// slow to compile.
#include <CLI/CLI.hpp>
#include <functional>
#include <memory>

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

}  // namespace eyrie::app
