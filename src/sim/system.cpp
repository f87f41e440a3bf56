// SPDX-License-Identifier: MIT
#include "sim/system.hpp"

namespace eyrie::sim {

namespace {

// Rates come from text such as '20 Hz' and dt from 1.0 / 50: both are off by a rounding or two.
constexpr double kRelativeSlack = 1e-9;
constexpr double kSlowest = 1.0 / 3600;  // Hz

}  // namespace

Period period_steps(double rate, double dt) {
  EYRIE_THROW_UNLESS(std::isfinite(dt) && dt > 0, "dt must be positive and finite");
  const double base = 1 / dt;
  if (!std::isfinite(rate) || rate <= 0)
    return {0, fmt::format("a rate must be above 0 Hz, got {} Hz", rate)};
  if (rate < kSlowest * (1 - kRelativeSlack))
    return {0, fmt::format("{} Hz is slower than once per hour", rate)};
  if (rate > base * (1 + kRelativeSlack))
    return {0, fmt::format("{} Hz is faster than the step, which runs at {:.6g} Hz", rate, base)};

  const double exact = base / rate;
  const double nearest = std::nearbyint(exact);
  if (nearest > std::numeric_limits<std::uint32_t>::max())
    return {0, fmt::format("{} Hz is too slow for steps of {} s", rate, dt)};
  if (std::fabs(exact - nearest) <= kRelativeSlack * exact)
    return {static_cast<std::uint32_t>(nearest), {}};
  return {0, fmt::format("{} Hz does not divide the base rate of {:.6g} Hz; near it are {:.6g} Hz "
                         "and {:.6g} Hz",
                         rate, base, base / std::ceil(exact), base / std::floor(exact))};
}

std::string_view phase_name(Phase phase) {
  constexpr std::array<std::string_view, kPhases> kNames = {"orders", "perceive", "decide", "act",
                                                            "move",   "interact", "commit"};
  return kNames[static_cast<std::size_t>(phase)];
}

bool CommitContext::remove(PlayerId who) {
  const std::optional<RowRef> place = world_.find(who);
  if (place)
    world_.remove(place->table, place->row);
  return place.has_value();
}

}  // namespace eyrie::sim
