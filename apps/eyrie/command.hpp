// SPDX-License-Identifier: MIT
#pragma once
/// \file  How every command begins and ends: its streams, its exit code, words for whatever stopped
/// it, and its files.
#include <exception>
#include <map>

#include "disk/output.hpp"

namespace eyrie::app {

/// Standard streams that are closed must not become those of the first files that are opened. To be
/// called before anything else.
void open_standard_streams();

/// What stopped a command, in our words.
[[nodiscard]] std::string words_for(const std::exception& error);

/// Runs a command and gives its exit code; 2 after saying what mistake the user made, 1 after
/// saying what failed.
[[nodiscard]] int attempt(const std::function<int()>& command);
/// The same of the whole program: 1 also if standard output could not be written; 128 and the
/// number of the signal that cut it short.
[[nodiscard]] int run_command(const std::function<int()>& command);

/// From now on the first signal that asks the program to end (Ctrl-C, a closed terminal, a file at
/// its limit) is noted, and what is being made is brought to its end. A second one ends the program
/// at once, without anything that is half written. Signals that were ignored stay so, as under
/// nohup. A reader who has gone is seen when something is written for him.
void listen_for_interrupts();
/// The signal that was noted; 0: none.
[[nodiscard]] int interruption();
[[nodiscard]] inline bool interrupted() {
  return interruption() != 0;
}

/// Puts a file in its place and says so. Throws disk::Failed, also if it was interrupted.
void finish(disk::OutputFile& out);
/// The same of a whole folder with these files, without a word.
void finish(disk::OutputFolder& folder, const std::map<std::string, std::string>& files);

}  // namespace eyrie::app
