// SPDX-License-Identifier: MIT
#pragma once
/// \file  Commands that several behaviors make together: the best of a grid, or a sum of vectors.
#include "ubf/arbiter/field_values.hpp"
#include "ubf/merging.hpp"

namespace eyrie::ubf {

/// What vote_grid and utility share: every child's opinion of every candidate, added up, and the
/// candidate of which the sum is the greatest, the first of equals.
template <class State, class Action>
class OverGrid : public Mixing<State, Action> {
 public:
  Grid<Action> grid;

  [[nodiscard]] static constexpr auto params() {
    return OverGrid::with_vote(
        param("grid", &OverGrid::grid, "what there is to choose from: a map from fields to axes")
            .required());
  }
  [[nodiscard]] std::string problem() const override {
    return grid.size() ? Mixing<State, Action>::problem() : "a grid needs at least one field";
  }

 protected:
  using Sums = std::array<double, Grid<Action>::kMostCandidates>;

  struct Opinion {
    StrongestChild strongest;
    bool any = false;     ///< somebody has an opinion of the grid
    double rounding = 0;  ///< sums that are no farther apart are equal
  };

  /// Asks the children and adds up `weight * worth` of each candidate in `sums`. Fields that are
  /// not on the grid are left in `out` as per_field would.
  Opinion add_up(const Tick<State>& t, Proposal<Action>& out, Sums& sums) const {
    std::fill_n(sums.begin(), grid.size(), 0.0);
    Opinion all;
    FieldMerge<Action> merge;
    Scratch<Action> scratch;
    all.strongest =
        this->ask_voters(t, scratch.get(), [&](const auto& child, Proposal<Action>& next) {
          const auto weight = static_cast<double>(next.vote);
          double farthest = 1;  // from no opinion
          if (const auto* appraiser = this->typed(child).appraiser()) {
            farthest = appraise(*appraiser, t, weight, sums);
            if (farthest - farthest != 0) [[unlikely]]  // not finite
              return refuse_worth(child, t, next);
            all.any = true;
          } else {
            all.any |= near_what_is_asked(next.action, weight, sums);
          }
          all.rounding += kRounding * weight * farthest;
          merge.add(next, out.action);
          return true;
        });
    return all;
  }
  /// Makes the proposal: the best candidate, if there is an opinion.
  Status propose(const Tick<State>& t, Proposal<Action>& out, const Opinion& all,
                 const Sums& sums) const {
    if (all.any)
      grid.set(best_of(sums, all.rounding), out.action);
    out.vote = all.strongest.vote;
    // a choice of all is nobody's but this node's
    out.leader = all.any ? kNone : all.strongest.leader;
    this->rescale(out);
    if (t.trace) [[unlikely]]
      trace_fields(*t.trace, *this, kVoters, [&](const auto&, std::size_t field, std::size_t) {
        return !all.any || !grid.has(field);
      });
    return all.strongest.status;
  }

 private:
  /// Between two voices of the same weight all candidates have the same sum, but for the last bits
  /// of it; these must not choose.
  static constexpr double kRounding = 1e-12;

  [[nodiscard]] std::size_t best_of(const Sums& sums, double rounding) const {
    const auto end = sums.begin() + static_cast<std::ptrdiff_t>(grid.size());
    const double enough = *std::max_element(sums.begin(), end) - rounding;
    const auto best = std::find_if(sums.begin(), end, [&](double sum) { return sum >= enough; });
    return static_cast<std::size_t>(best - sums.begin());
  }
  /// Returns the greatest worth, or the smallest if that is farther from 0, without its sign. If
  /// one of them is not finite, that is returned and nothing is added.
  double appraise(const Appraiser<State, Action>& appraiser, const Tick<State>& t, double weight,
                  Sums& sums) const {
    Scratch<Action> candidate;
    Sums worths;
    double farthest = 0;
    Action& action = candidate.get().action;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      grid.set(i, action);
      worths[i] = appraiser.appraise(t, action);
      if (worths[i] - worths[i] != 0) [[unlikely]]
        return worths[i];
      farthest = std::fmax(farthest, std::fabs(worths[i]));
    }
    for (std::size_t i = 0; i < grid.size(); ++i)
      sums[i] += weight * worths[i];
    return farthest;
  }
  [[gnu::cold, gnu::noinline]] bool refuse_worth(const AnyNode& child, const Tick<State>& t,
                                                 Proposal<Action>& next) const {
    if (t.mistake && t.mistake->node == kNone)
      *t.mistake = {child.index(), "appraises a candidate with what is no finite number"};
    this->halt(child, t);
    next.clear();
    if (t.trace) {
      t.trace->because(child.index(), "what it says of a candidate is no finite number");
      Trace<Action>::of(*t.trace).record(child.index(), Status::failure, next);
    }
    return false;
  }
  /// A plain proposal votes for what is near it, in the mean over the fields that it sets.
  bool near_what_is_asked(const Action& action, double weight, Sums& sums) const {
    constexpr ActionFields fields = action_fields<Action>();
    std::size_t asked = 0;
    for (const auto& axis : grid.axes())
      asked += fields[axis.field].get(&action).has_value();
    if (asked == 0)
      return false;
    std::size_t stride = 1;
    for (const auto& axis : grid.axes()) {
      if (const auto wanted = fields[axis.field].get(&action)) {
        std::array<double, Grid<Action>::kMostSteps> worth;
        for (std::size_t k = 0; k < axis.steps; ++k)
          worth[k] = weight * axis.worth(axis.at(k), *wanted) / static_cast<double>(asked);
        for (std::size_t i = 0; i < grid.size(); ++i)
          sums[i] += worth[i / stride % axis.steps];
      }
      stride *= axis.steps;
    }
    return true;
  }
};

/// Behaviors vote over a grid of candidate commands: a vote of +1 for and -1 against, weighted with
/// the vote of the proposal; the candidate with the greatest sum goes up. A behavior that proposes
/// one command votes +1 for it, and less the farther a candidate is away, down to -1 at `reach`;
/// an Appraiser votes on each candidate as it likes. Fields that are not on the grid come from the
/// highest vote that set them. Vote and status are those of the strongest child. Rosenblatt, "DAMN:
/// A Distributed Architecture for Mobile Navigation" (1997).
///   vote_grid: {grid: {heading: {from: 0 deg, to: 360 deg, steps: 36, reach: 60 deg}}, children:
///   [...]}
template <class State, class Action>
class VoteGrid final : public OverGrid<State, Action> {
 public:
  static constexpr std::string_view type_name = "vote_grid";
  static constexpr std::string_view help =
      "the candidate of a grid that gets most of the children's votes";

  [[nodiscard]] std::string problem() const override {
    for (const auto& axis : this->grid.axes())
      if (axis.spread.size() > 1)
        return "'spread' is for utility: votes are for commands, not for what comes of them";
    return OverGrid<State, Action>::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    typename VoteGrid::Sums sums;
    const auto opinion = this->add_up(t, out, sums);
    return this->propose(t, out, opinion, sums);
  }
};

/// Behaviors state the utility of outcomes, and the command with the highest expectation goes up.
/// Outcomes are the points of a grid; what comes of a command is distributed around it as each
/// axis' `spread` says (normal, within the grid; on a circle around it). The utility of an outcome
/// is the sum over the children, weighted with their votes: an Appraiser states it, for a behavior
/// that proposes one command it is 1 there and falls to -1 at `reach`. Other fields, vote and
/// status as in vote_grid. Rosenblatt, "Optimal Selection of Uncertain Actions by Maximizing
/// Expected Utility" (Autonomous Robots, 2000).
///   utility: {grid: {altitude: {from: 5000 ft, to: 35000 ft, steps: 7, reach: 1 km, spread: 500
///   ft}}, ...}
template <class State, class Action>
class Utility final : public OverGrid<State, Action> {
  using Base = OverGrid<State, Action>;

 public:
  static constexpr std::string_view type_name = "utility";
  static constexpr std::string_view help = "the command with the highest expected utility";

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    typename Base::Sums utility, expected;
    const auto opinion = this->add_up(t, out, utility);
    if (opinion.any)
      expect(utility, expected);
    return this->propose(t, out, opinion, utility);
  }

 private:
  /// Turns utilities of outcomes into expectations of commands, axis by axis. Outcomes beyond an
  /// end of an axis fall on its end.
  void expect(typename Base::Sums& utility, typename Base::Sums& scratch) const {
    std::size_t stride = 1;
    for (const auto& axis : this->grid.axes()) {
      const auto reach = static_cast<std::ptrdiff_t>(axis.spread.size()) - 1;
      if (reach > 0) {
        const auto steps = static_cast<std::ptrdiff_t>(axis.steps);
        for (std::size_t i = 0; i < this->grid.size(); ++i) {
          const auto at = static_cast<std::ptrdiff_t>(i / stride % axis.steps);
          double sum = 0;
          for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
            const std::ptrdiff_t to = axis.is_circle
                                          ? (at + k + steps) % steps
                                          : std::clamp(at + k, std::ptrdiff_t{0}, steps - 1);
            sum += axis.spread[static_cast<std::size_t>(k < 0 ? -k : k)] *
                   utility[i + static_cast<std::size_t>(to - at) * stride];
          }
          scratch[i] = sum;
        }
        std::copy_n(scratch.begin(), this->grid.size(), utility.begin());
      }
      stride *= axis.steps;
    }
  }
};

/// Adds up the proposals of all children as vectors: a direction and a magnitude, which are two
/// fields of the action (heading and speed). The gain of a child is its vote / `unit_vote`. The sum
/// is never longer than the longest vector that was asked for; vectors that cancel leave a
/// magnitude of 0 and no direction. A proposal with only one of the two fields adds no vector. The
/// other fields come from the highest vote that set them, as in per_field. Failing and abstaining
/// children are ignored; if that leaves none, it fails. Vote and status are those of the strongest
/// child. Arkin, "Motor Schema-Based Mobile Robot Navigation" (IJRR 1989).
///   motor_schema: {direction: heading, magnitude: speed, unit_vote: 40, children: [pursue,
///   follow_lead]}
template <class State, class Action>
class MotorSchema final : public Mixing<State, Action> {
 public:
  static constexpr std::string_view type_name = "motor_schema";
  static constexpr std::string_view help =
      "the sum of all proposals as vectors, each as long as its vote says";
  [[nodiscard]] static constexpr auto params() {
    return MotorSchema::with_vote(
        param("direction", &MotorSchema::direction, "the field that is the vector's direction")
            .required(),
        param("magnitude", &MotorSchema::magnitude, "the field that is the vector's length")
            .required(),
        param("unit_vote", &MotorSchema::unit_vote, positive(1000), "a vote of this is a gain of 1")
            .required());
  }

  FieldChoice<Action, blend::Angle> direction;
  FieldChoice<Action, blend::Mean> magnitude;
  double unit_vote = 1;

  [[nodiscard]] std::string problem() const override {
    return direction.index() && magnitude.index()
               ? Arbiter<State, Action>::problem()
               : "motor_schema needs a 'direction' and a 'magnitude'";
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    FieldMerge<Action> merge;
    Sum sum;
    Scratch<Action> scratch;
    const StrongestChild strongest =
        this->ask_voters(t, scratch.get(), [&](const auto&, const Proposal<Action>& next) {
          const auto angle = direction.get(&next.action), length = magnitude.get(&next.action);
          if (angle && length)
            sum.add(*angle, *length, static_cast<double>(next.vote) / unit_vote);
          merge.add(next, out.action);
        });
    direction.set(sum.direction(), &out.action);
    magnitude.set(sum.magnitude(), &out.action);
    out.vote = strongest.vote;
    out.leader = sum.empty() ? strongest.leader : kNone;  // a sum is nobody's but this node's
    this->rescale(out);
    if (t.trace) [[unlikely]]
      trace_fields(*t.trace, *this, kVoters, [&](const auto&, std::size_t field, std::size_t) {
        return field != direction.index() && field != magnitude.index();
      });
    return strongest.status;
  }

 private:
  /// A sum of vectors; east and north as for a heading.
  class Sum {
   public:
    void add(double angle, double length, double gain) {
      const auto [sin, cos] = math::sin_cos(angle);
      east_ += gain * length * sin;
      north_ += gain * length * cos;
      total_ += gain * std::fabs(length);
      longest_ = std::max(longest_, std::fabs(length));
      empty_ = false;
    }
    [[nodiscard]] bool empty() const { return empty_; }
    [[nodiscard]] std::optional<double> direction() const {
      if (empty_ || cancels())
        return std::nullopt;
      return wrap_tau(math::atan2(east_, north_));
    }
    [[nodiscard]] std::optional<double> magnitude() const {
      if (empty_)
        return std::nullopt;
      return cancels() ? 0 : std::min(longest_, std::sqrt(east_ * east_ + north_ * north_));
    }

   private:
    [[nodiscard]] bool cancels() const {
      return east_ * east_ + north_ * north_ <= 1e-18 * total_ * total_;
    }
    double east_ = 0, north_ = 0, total_ = 0, longest_ = 0;
    bool empty_ = true;
  };
};

}  // namespace eyrie::ubf
