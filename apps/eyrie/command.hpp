// SPDX-License-Identifier: MIT
#pragma once
/// \file  How every command begins and ends: its streams, its exit code, and words for whatever
/// stopped it.
#include <exception>
#include <functional>
#include <string>

namespace eyrie::app {

/// Standard streams that are closed must not become those of the first files that are opened. To be
/// called before anything else.
void open_standard_streams();

/// What stopped a command, in our words.
[[nodiscard]] std::string words_for(const std::exception& error);

/// Runs a command and gives the exit code: its own; 2 after saying what mistake the user made; 1
/// after saying what failed, or that standard output could not be written; 128 and the number of
/// the signal that cut it short.
[[nodiscard]] int run_command(const std::function<int()>& command);

}  // namespace eyrie::app
