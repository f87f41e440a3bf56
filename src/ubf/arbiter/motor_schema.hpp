// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "core/math.hpp"
#include "ubf/arbiter/field_choice.hpp"
#include "ubf/merging.hpp"

namespace eyrie::ubf {

/// Adds up the proposals of all children as vectors: a direction and a magnitude, which are two
/// fields of the action (heading and speed). The gain of a child is its vote / `unit_vote`. The sum
/// is never longer than the longest vector that was asked for; vectors that cancel leave a
/// magnitude of 0 and no direction. A proposal with only one of the two fields adds no vector. The
/// other fields come from the highest vote that set them, as in per_field. Failing and abstaining
/// children are ignored; if that leaves none, it fails. Vote and status are those of the strongest
/// child. Arkin, "Motor Schema-Based Mobile Robot Navigation" (IJRR 1989).
template <class State, class Action>
class MotorSchema final : public Mixing<State, Action> {
 public:
  static constexpr std::string_view type_name = "motor_schema";
  static constexpr std::string_view help =
      "the sum of all proposals as vectors, each as long as its vote says";
  static constexpr Kind kind = Kind::arbiter;
  [[nodiscard]] static constexpr auto params() {
    return std::tuple_cat(
        std::tuple{
            param("direction", &MotorSchema::direction, "the field that is the vector's direction")
                .required(),
            param("magnitude", &MotorSchema::magnitude, "the field that is the vector's length")
                .required(),
            param("unit_vote", &MotorSchema::unit_vote, positive(1000),
                  "a vote of this is a gain of 1")
                .required()},
        Voting<State, Action>::template vote_params<MotorSchema>());
  }
  using Mixing<State, Action>::Mixing;

  FieldChoice<Action, blend::Angle> direction;
  FieldChoice<Action, blend::Mean> magnitude;
  double unit_vote = 1;

  [[nodiscard]] std::string problem() const override {
    return direction.index() && magnitude.index()
               ? Voting<State, Action>::problem()
               : "motor_schema needs a 'direction' and a 'magnitude'";
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    FieldMerge<Action> merge;
    Sum sum;
    Scratch<Action> scratch;
    const StrongestChild strongest =
        this->ask_voters(t, scratch.get(), [&](const auto&, const Proposal<Action>& next) {
          const auto angle = direction.get(next.action), length = magnitude.get(next.action);
          if (angle && length)
            sum.add(*angle, *length, static_cast<double>(next.vote) / unit_vote);
          merge.add(next, out.action);
        });
    direction.set(sum.direction(), out.action);
    magnitude.set(sum.magnitude(), out.action);
    out.vote = strongest.vote;
    out.leader = sum.empty() ? strongest.leader : kNone;  // a sum is nobody's but this node's
    this->rescale(out);
    if (t.trace) [[unlikely]]
      trace_others(*t.trace, *this, [&](std::size_t field) {
        return field == direction.index() || field == magnitude.index();
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
