// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a node remembers between ticks: plain bytes in the agent's slab, zero when fresh.
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace eyrie::ubf {

/// Pre-order position of a node in its tree.
using NodeIndex = std::uint16_t;
/// No node, no child.
inline constexpr NodeIndex kNone = 0xffff;

namespace detail {

/// Reads every byte of M{}; padding bytes have no value, so that is no constant then.
template <class M>
consteval int bytes_of_fresh() {
  const auto bytes = std::bit_cast<std::array<unsigned char, sizeof(M)>>(M{});
  int sum = 0;
  for (const unsigned char byte : bytes)
    sum += byte;
  return sum;
}

}  // namespace detail

/// Every byte of an M belongs to a member, so that equal values are equal bytes and a hash of the
/// slab is a hash of what was remembered.
template <class M>
concept NoPadding = std::is_trivially_copyable_v<M> && requires {
  typename std::integral_constant<int, detail::bytes_of_fresh<M>()>;
};

/// What a node may keep in the slab: copyable by memcpy, without padding, and all zero bytes when
/// it is fresh, because forgetting is zeroing.
template <class M>
concept NodeMemory =
    NoPadding<M> && alignof(M) <= 8 && std::bool_constant<detail::bytes_of_fresh<M>() == 0>::value;

/// Bytes that a memory of that size takes in the slab.
[[nodiscard]] constexpr std::size_t slab_bytes(std::size_t size) noexcept {
  return (size + 7) / 8 * 8;
}

/// One of a node's children, remembered: none when fresh.
class ChildSlot {
 public:
  [[nodiscard]] constexpr NodeIndex get() const {
    return number_ ? static_cast<NodeIndex>(number_ - 1) : kNone;
  }
  constexpr void set(std::size_t child) { number_ = static_cast<std::uint16_t>(child + 1); }
  constexpr void clear() { number_ = 0; }
  [[nodiscard]] constexpr explicit operator bool() const { return number_ != 0; }

 private:
  std::uint16_t number_ = 0;
};

/// s. A tick that comes this little too early is on time: simulated times are sums of steps and
/// carry their rounding, so 0.7 - 0.2 is a bit less than 0.5.
inline constexpr double kTimeSlack = 1e-6;

/// Whether at `now` at least `duration` has passed since `since`; all in s.
[[nodiscard]] constexpr bool passed(double now, double since, double duration) {
  return now - since >= duration - kTimeSlack;
}

}  // namespace eyrie::ubf
