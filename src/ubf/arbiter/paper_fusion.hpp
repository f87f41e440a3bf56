// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/merging.hpp"

namespace eyrie::ubf {

/// The fusion arbiter of Roberson et al., "The Unified Behavior Framework for the Simulation of
/// Autonomous Agents" (CSC'15), section III.C.2: every quantity (altitude, velocity, heading) is
/// the plain average of all proposals, whatever their votes, and an order (release) goes up if a
/// highly voted proposal gives it, a flag also if a stronger one says no. A heading is averaged as
/// the plain number it is, so 350 and 10 degrees make 180; `fusion` is the arbiter that knows the
/// circle. How high a vote must be is not in the paper and so must be given. Failing and abstaining
/// children make no proposal; if none is left, it fails. Vote and status are those of the strongest
/// child.
template <class State, class Action>
class PaperFusion final : public Blending<State, Action> {
 public:
  static constexpr std::string_view type_name = "paper_fusion";
  static constexpr std::string_view help =
      "as in the paper: plain averages, and orders that a highly voted proposal gives";
  static constexpr Kind kind = Kind::arbiter;
  [[nodiscard]] static constexpr auto params() {
    return std::tuple_cat(std::tuple{param("high_vote", &PaperFusion::high_vote, range(0, 1000),
                                           "least vote of a proposal whose orders are taken")
                                         .required()},
                          Voting<State, Action>::template vote_params<PaperFusion>());
  }
  using Blending<State, Action>::Blending;

  float high_vote = 0;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const auto as_in_the_paper = [this]<class Field>(const Field&, float given) -> double {
      if (Field::averages)
        return 1;
      return kIsOrder<Field> && given < high_vote ? 0 : static_cast<double>(given);
    };
    return this->template blend<SumOf>(t, out, as_in_the_paper);
  }

 private:
  template <class Field>
  static constexpr bool kIsOrder = std::is_same_v<typename Field::BlendTag, blend::Strongest>;
  /// "Release" goes up if anybody who is heard says so.
  class AnyYes {
   public:
    void add(bool value, double) { value_ = value || value_.value_or(false); }
    [[nodiscard]] std::optional<bool> get() const { return value_; }

   private:
    std::optional<bool> value_;
  };
  template <class Field>
  struct Plain {
    using type = typename Field::Sum;
  };
  template <class Field>
  requires Field::averages struct Plain<Field> {
    using type = blend::Mean::Sum<typename Field::Value>;
  };
  template <class Field>
  requires(kIsOrder<Field>&& std::is_same_v<typename Field::Value, bool>) struct Plain<Field> {
    using type = AnyYes;
  };
  template <class Field>
  using SumOf = typename Plain<Field>::type;
};

}  // namespace eyrie::ubf
