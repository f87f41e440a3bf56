// SPDX-License-Identifier: MIT
#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace eyrie {

/// A number that names one thing of one kind; ids of different kinds do not mix or compare.
/// 0 names nothing. Four bytes, no padding, so it may be a member of a row.
template <class Tag>
struct Id {
  std::uint32_t value = 0;

  [[nodiscard]] constexpr explicit operator bool() const { return value != 0; }
  friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

/// Names a player for the whole run. Never reused, so it also orders players by age.
using PlayerId = Id<struct PlayerTag>;
/// Names a table of the world.
using TableId = Id<struct TableTag>;
/// Names a track of one player; only that player knows what it means.
using TrackId = Id<struct TrackTag>;

}  // namespace eyrie

template <class Tag>
struct std::hash<eyrie::Id<Tag>> {
  [[nodiscard]] std::size_t operator()(eyrie::Id<Tag> id) const noexcept { return id.value; }
};
