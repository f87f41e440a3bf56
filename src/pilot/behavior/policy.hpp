// SPDX-License-Identifier: MIT
#pragma once
/// \file  Learned behaviors: a network that flies, and one that votes.
#include "pilot/policy/policy_file.hpp"
#include "pilot/state.hpp"
#include "ubf/composite.hpp"

namespace eyrie::pilot {

/// Numbers of a network at one decision; for as many as there may be.
using NetworkNumbers = std::array<float, Network::kMostUnits>;

/// What both have: a network in a file, and what it remembers.
template <class Base>
class Learned : public Base {
 public:
  [[nodiscard]] std::size_t memory_bytes() const noexcept final {
    return policy_ ? policy_->network.memory() * sizeof(float) : 0;
  }

 protected:
  [[nodiscard]] static constexpr auto file_param() {
    return param("file", &Learned::file_,
                 "of the network, beside the file that names it: .safetensors, at most 12 MB "
                 "(docs/howto/fly-a-policy.md)")
        .items(1, 1000)
        .required();
  }

  std::string file_;
  std::shared_ptr<const PolicyFile> policy_;
};

/// Flies by a network that was trained elsewhere (docs/howto/fly-a-policy.md): in every decision it
/// observes, evaluates, and asks for what a person at the controls would ask for. A network with
/// memory forgets when the subtree loses control.
///   policy: {file: policies/merge.safetensors, vote: 60}
class Policy final : public Learned<Behavior> {
 public:
  static constexpr std::string_view type_name = "policy";
  static constexpr std::string_view help = "flies by a learned network";
  static constexpr auto params() {
    return Lines{file_param(), param("vote", &Policy::vote_, range(0, 1000), "how strongly")};
  }

  [[nodiscard]] std::string problem() const override;
  Status tick(const Tick& t, Proposal& out) const override;
  /// From a file.
  void read(const ubf::NodeSpec& spec, ubf::NodeReader& reader);

 private:
  float vote_ = 50;
};

/// Winner takes all by learned votes: a network gives a number for each child, in their order, and
/// votes of 0 to 100 are made of them, by a sigmoid or a line each, or by a softmax over all. The
/// highest vote goes up, of equal ones the earlier child's; a child that fails or abstains stays
/// out; how much the others vote themselves does not count.
///   learned_vote: {file: policies/votes.safetensors, children: [pursue, break_turn]}
class LearnedVote final : public Learned<ubf::Arbiter<State, Action>> {
 public:
  static constexpr std::string_view type_name = "learned_vote";
  static constexpr std::string_view help =
      "the proposal with the highest vote of a learned network";
  static constexpr auto params() { return with_vote(file_param()); }

  [[nodiscard]] std::string problem() const override;
  Status tick(const Tick& t, Proposal& out) const override;
  /// From a file.
  void read(const ubf::NodeSpec& spec, ubf::NodeReader& reader);
};

}  // namespace eyrie::pilot
