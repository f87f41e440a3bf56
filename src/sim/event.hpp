// SPDX-License-Identifier: MIT
#pragma once
/// \file  Small words of the kernel: the parts of a step, events, orders, and what ends a run.
#include <cstring>
#include <memory>
#include <typeinfo>
#include <vector>

#include "core/field.hpp"

namespace eyrie::sim {

/// The kind of an event or an order. The kernel only passes kinds on; a domain keeps its
/// own `enum class ... : std::uint16_t` and converts without a cast. KindCode 0 means none.
template <class Tag>
struct KindCode {
  std::uint16_t value = 0;

  constexpr KindCode() = default;
  constexpr explicit KindCode(std::uint16_t v) : value(v) {}
  template <class Enum>
  requires std::is_enum_v<Enum> && std::same_as<std::underlying_type_t<Enum>, std::uint16_t>
  constexpr KindCode(Enum e)
      : value(static_cast<std::uint16_t>(e)) {}  // NOLINT: implicit on purpose

  /// The kind as the domain's own enumeration, for a switch.
  template <class Enum>
  [[nodiscard]] constexpr Enum as() const {
    return static_cast<Enum>(value);
  }
  constexpr explicit operator bool() const { return value != 0; }
  friend constexpr auto operator<=>(const KindCode&, const KindCode&) = default;

  static constexpr auto fields() { return field_list(field("value", &KindCode::value)); }
};

using EventKind = KindCode<struct EventTag>;
using OrderKind = KindCode<struct OrderTag>;

/// The parts of a step, in the order in which they run and in which their events are sorted.
enum class Phase : std::uint8_t { orders, perceive, decide, act, move, interact, commit };
constexpr auto names_of(Phase) {
  return names_from_zero<Phase>("orders", "perceive", "decide", "act", "move", "interact",
                                "commit");
}
inline constexpr std::size_t kPhases = EnumNames<Phase>::names.size();

/// A system that writes a column, by its name (a literal), and when.
struct WrittenBy {
  std::string_view system;
  Phase phase = Phase::orders;
  friend constexpr bool operator==(const WrittenBy&, const WrittenBy&) = default;
};

/// Somebody's code threw in a step, or gave a value that means nothing (NaN, infinity, 1e300). The
/// step is not finished and nobody observes it; the run ends with the last whole one.
struct Fault {
  PlayerId player{};
  std::string agent = {};  ///< whose part it was: the tree and the path of the node; may be empty
  const std::type_info* node = nullptr;  ///< its type, by which the library with its code is found
  std::string what = {};                 ///< "heading is nan rad", "threw: no fuel"
  std::string_view system = {};          ///< filled in by the step
  std::uint64_t step = 0;                ///< likewise: the one that was not finished
};

/// Something that happened. Plain bytes without padding; what `aux`, `detail` and `values` mean is
/// said once per kind, by the domain. The units of `place` are the domain's
/// (Eyrie: metres in the scenario's local frame).
struct Event {
  static constexpr std::size_t kValues = 6;

  EventKind kind{};
  std::uint16_t aux = 0;
  std::uint32_t detail = 0;
  PlayerId who{};   ///< who does it
  PlayerId whom{};  ///< whom it is done to; none if nobody
  Vec3 place{};
  std::array<float, kValues> values{};

  static constexpr auto fields() {
    return field_list(field("kind", &Event::kind), field("aux", &Event::aux),
                      field("detail", &Event::detail), field("who", &Event::who),
                      field("whom", &Event::whom), field("place", &Event::place),
                      field("values", &Event::values));
  }
};
static_assert(fields_cover_row<Event>());
static_assert(sizeof(Event) == 64, "one cache line, no padding");

/// Where the rows of one chunk write their events during a parallel phase. Never drops one: when
/// the room kept for it is used up it allocates.
class alignas(64) Outbox {
 public:
  Outbox() = default;
  explicit Outbox(std::size_t room) { events_.reserve(room); }

  void emit(const Event& event) { events_.push_back(event); }

  /// The step cannot be finished. The first fault of a chunk counts; it is the only thing in a step
  /// that may allocate.
  void fail(Fault fault) {
    if (!fault_)
      fault_ = std::make_unique<Fault>(std::move(fault));
  }
  [[nodiscard]] std::unique_ptr<Fault> take_fault() { return std::move(fault_); }

  [[nodiscard]] std::span<const Event> events() const { return events_; }
  [[nodiscard]] bool failed() const { return fault_ != nullptr; }
  void clear() { events_.clear(); }

 private:
  std::vector<Event> events_;
  std::unique_ptr<Fault> fault_;
};

/// An order from an operator, a network or Python to one player. Plain bytes without padding: a
/// recording is the initial world plus the orders.
struct Order {
  static constexpr std::size_t kPayload = 32;

  std::uint64_t step = 0;  ///< applied before the perceive phase of this step
  PlayerId player{};
  OrderKind kind{};
  std::uint16_t reserved = 0;
  alignas(8) std::array<std::byte, kPayload> payload{};

  /// The payload as what order_for() was given.
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
