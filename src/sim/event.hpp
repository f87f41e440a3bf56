// SPDX-License-Identifier: MIT
#pragma once
/// \file  What happened in a step, and where parallel phases write it down.
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/field.hpp"
#include "core/id.hpp"
#include "core/vec.hpp"
#include "sim/fault.hpp"
#include "sim/kind.hpp"

namespace eyrie::sim {

/// Something that happened. Plain bytes without padding; what `aux`, `detail` and `values` mean is
/// said once per kind, by the domain and in the schema. The units of `place` are the domain's
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
/// the room kept for it is used up it allocates, and the growth is counted.
class alignas(64) Outbox {
 public:
  Outbox() = default;
  explicit Outbox(std::size_t room) { events_.reserve(room); }

  void emit(const Event& event) {
    if (events_.size() == events_.capacity())
      ++growths_;
    events_.push_back(event);
  }

  /// The step cannot be finished. The first fault of a chunk counts; it is the only thing in a step
  /// that may allocate.
  void fail(Fault fault) {
    if (!fault_)
      fault_ = std::make_unique<Fault>(std::move(fault));
  }
  [[nodiscard]] std::unique_ptr<Fault> take_fault() { return std::move(fault_); }

  [[nodiscard]] std::span<const Event> events() const { return events_; }
  /// How often emit() had to allocate since the outbox was made.
  [[nodiscard]] std::uint64_t growths() const { return growths_; }
  void clear() { events_.clear(); }

 private:
  std::vector<Event> events_;
  std::uint64_t growths_ = 0;
  std::unique_ptr<Fault> fault_;
};

}  // namespace eyrie::sim
