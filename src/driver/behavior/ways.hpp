// SPDX-License-Identifier: MIT
#pragma once
/// \file  What drivers do as all platforms do: the behaviors of src/team, with nothing added.
#include "driver/state.hpp"
#include "driver/trees.hpp"
#include "team/member.hpp"

namespace eyrie::driver {

/// Drives along a route of the convoy (team/member.hpp).
class Navigate final : public team::Navigate<Platform> {
 public:
  static constexpr std::string_view help = "drives along the waypoints of the convoy's route";
  Status tick(const Tick& t, Proposal& out) const override { return go(t, out).status; }
};

/// Keeps its distance behind the vehicle ahead (team/member.hpp).
class FollowLead final : public team::FollowLead<Platform> {
 public:
  static constexpr std::string_view help = "keeps its distance behind the vehicle ahead";
  Status tick(const Tick& t, Proposal& out) const override {
    return go(t, out) ? Status::running : Status::failure;
  }
};

using IsLead = team::IsLead<Platform>;
using RouteDone = team::RouteDone<Platform>;

}  // namespace eyrie::driver
