// SPDX-License-Identifier: MIT
#pragma once
/// \file  Files of learned behaviors: what they see, the network, and what comes out of it.
#include "pilot/policy/controls.hpp"
#include "pilot/policy/network.hpp"
#include "pilot/policy/observation.hpp"

namespace eyrie::pilot {

/// What makes votes of a network's numbers, times 100; linear: -1 makes 0, and 1 makes 1, as the
/// actions of training do.
enum class Votes : std::uint8_t { sigmoid, softmax, linear };
constexpr auto names_of(Votes) {
  return names_from_zero<Votes>("sigmoid", "softmax", "linear");
}

/// A file of tensors (pilot/policy/tensors.hpp) with these words in its metadata:
///
///   eyrie_policy      the version of this format: 1
///   observation       the text of an Observation
///   network           the text of a Network, whose layers are tensors of the file
///   controls          the text of Controls, a line for each number that comes out; or
///   votes             sigmoid, softmax or linear: each number that comes out is the vote of a
///   child observation_hash, controls_hash    of both, as 0x0123456789abcdef, if somebody wants to
///   be sure
///
/// Other words and tensors are nobody's business: a state_dict may be saved as it is.
struct PolicyFile {
  Observation observation;
  Network network;
  Controls controls;
  std::optional<Votes> votes;

  static constexpr std::string_view kVersion = "1";
  static constexpr std::string_view kEnding = ".safetensors";  ///< of its name

  /// Nothing after reporting every mistake, as far as it can be seen.
  [[nodiscard]] static std::optional<PolicyFile> read(std::string bytes, FileName file,
                                                      Diagnostics& diagnostics);
};

}  // namespace eyrie::pilot
