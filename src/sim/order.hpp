// SPDX-License-Identifier: MIT
#pragma once
/// \file  What comes from outside: applied at the boundary of the step it names.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "core/id.hpp"
#include "sim/kind.hpp"

namespace eyrie::sim {

/// An order from an operator, a network or Python to one player. Plain bytes without padding: a
/// recording is the initial world plus the orders.
struct Order {
  static constexpr std::size_t kPayload = 32;

  std::uint64_t step = 0;  ///< applied before the perceive phase of this step
  PlayerId player{};
  OrderKind kind{};
  std::uint16_t reserved = 0;
  alignas(8) std::array<std::byte, kPayload> payload{};

  /// The payload as the row that the kind was described with.
  template <class Payload>
  [[nodiscard]] Payload as() const {
    static_assert(std::is_trivially_copyable_v<Payload> && sizeof(Payload) <= kPayload);
    Payload out;
    std::memcpy(&out, payload.data(), sizeof out);
    return out;
  }
};
static_assert(std::is_trivially_copyable_v<Order>);
static_assert(sizeof(Order) == 48, "no padding");

/// `order_for(step, player, Orders::turn, Turn{.heading = 1.5})`
template <class Payload>
[[nodiscard]] Order order_for(std::uint64_t step, PlayerId player, OrderKind kind,
                              const Payload& payload) {
  static_assert(std::is_trivially_copyable_v<Payload> && sizeof(Payload) <= Order::kPayload);
  Order order{.step = step, .player = player, .kind = kind};
  std::memcpy(order.payload.data(), &payload, sizeof payload);
  return order;
}

}  // namespace eyrie::sim
