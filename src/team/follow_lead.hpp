// SPDX-License-Identifier: MIT
#pragma once
#include <tuple>

#include "core/angle.hpp"
#include "core/describe.hpp"
#include "team/member.hpp"
#include "ubf/behavior.hpp"

namespace eyrie::team {

/// Keeps the own place behind or beside whom the state says to follow. The place follows from the
/// rank among the living, so the formation closes up. Fails for who leads, and while nothing has
/// been heard of the leader.
template <class Platform>
requires MemberState<typename Platform::State>
class FollowLead : public ubf::Behavior<typename Platform::State, typename Platform::Action> {
 public:
  static constexpr std::string_view type_name = "follow_lead";
  static constexpr auto params() {
    return std::tuple{param("vote", &FollowLead::vote_, range(0, 1000), "how strongly")};
  }

 protected:
  struct Slot {
    Leader leader;
    Vec3 offset;  ///< m forward, right, down of the leader
  };

  /// Recommends heading and speed towards the own place; nothing if there is nobody to follow.
  std::optional<Slot> go(const ubf::Tick<typename Platform::State>& t,
                         ubf::Proposal<typename Platform::Action>& out) const {
    const auto& s = t.state;
    const std::optional<Leader> leader = s.leads() ? std::nullopt : s.leader();
    if (!leader) {
      static_cast<void>(this->fails(t, s.leads() ? "leads" : "the leader was not heard of"));
      return std::nullopt;
    }

    const Vec3 offset = s.place();
    const model::flight::Guidance wanted =
        model::flight::follow_guidance(s.guidance(), s.own,
                                       {.position = leader->position,
                                        .velocity = leader->velocity,
                                        .lead_heading = s.forward_of(*leader),
                                        .offset = offset},
                                       s.wind());
    out.action.heading = wrap_tau(wanted.heading);
    out.action.speed = wanted.speed;
    out.vote = vote_;
    return Slot{*leader, offset};
  }

  float vote_ = 20;
};

}  // namespace eyrie::team
