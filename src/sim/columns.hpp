// SPDX-License-Identifier: MIT
#pragma once
/// \file  A table described once: its columns with their names, and who writes them when.
///
///   struct CarColumns : sim::Table<CarColumns> {
///     sim::Column<Body> body;
///     sim::Column<Tank> tank;
///     static constexpr std::string_view table_name = "car";
///     static constexpr auto columns() {
///       return Lines{sim::column("body", &CarColumns::body, sim::WrittenBy{"drive",
///       sim::Phase::move}),
///                         sim::column("tank", &CarColumns::tank, ...)};
///     }
///   };
#include "core/lines.hpp"
#include "sim/schema.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

/// A column as a table describes it.
template <class Columns, class Row_>
struct DescribedColumn {
  using Row = Row_;
  std::string_view name;
  Column<Row> Columns::*member;
  std::array<WrittenBy, 4> writers{};
  std::size_t writer_count = 0;
  bool seldom = false;

  /// The same, zero in most runs (ColumnInfo::seldom).
  [[nodiscard]] constexpr DescribedColumn seldom_used() const {
    DescribedColumn column = *this;
    column.seldom = true;
    return column;
  }
  [[nodiscard]] constexpr bool is_written_in(Phase phase) const {
    for (std::size_t i = 0; i < writer_count; ++i)
      if (writers[i].phase == phase)
        return true;
    return false;
  }
};

/// One that nobody but these systems writes, in these phases; without any it is set at birth.
template <class Columns, class Row, class... W>
[[nodiscard]] constexpr auto column(std::string_view name, Column<Row> Columns::*member,
                                    const W&... writers) {
  static_assert((std::is_same_v<W, WrittenBy> && ...));
  return DescribedColumn<Columns, Row>{name, member, {writers...}, sizeof...(W)};
}

/// The keys of a table that a scenario has once, made from its description.
template <class Columns>
struct Table {
  TableId table;

  /// Adds the table to a schema. Columns stand in a world in the order of their description.
  [[nodiscard]] static Columns define(SchemaBuilder& builder, std::uint32_t capacity) {
    Columns keys;
    keys.table = builder.add_table(Columns::table_name, capacity);
    each([&]<class Row>(const DescribedColumn<Columns, Row>& c) {
      keys.*c.member = builder.add_column<Row>(keys.table, c.name);
      builder.set_writers((keys.*c.member).index, {c.writers.data(), c.writer_count});
      if (c.seldom)
        builder.set_seldom((keys.*c.member).index);
    });
    return keys;
  }

  /// Gives a row that was just born the default value of each of its columns.
  void set_defaults(World& world, std::uint32_t row) const {
    each([&]<class Row>(const DescribedColumn<Columns, Row>& c) {
      world.rows(static_cast<const Columns&>(*this).*c.member)[row] = Row{};
    });
  }

  /// Calls `use` with each described column.
  template <class Use>
  static constexpr void each(Use use) {
    with_lines(lines_of(Columns::columns()), [&](const auto&... c) { (use(c), ...); });
  }
  /// Whether somebody writes a column in a phase.
  template <class Row>
  [[nodiscard]] static constexpr bool is_written_in(Column<Row> Columns::*member, Phase phase) {
    bool written = false;
    each([&]<class R>(const DescribedColumn<Columns, R>& c) {
      if constexpr (std::is_same_v<R, Row>)
        written |= c.member == member && c.is_written_in(phase);
    });
    return written;
  }
};

/// The columns that a view looks at, found once per chunk. A view is a struct of references to what
/// stands in one row, whose columns() lists where its members come from, in their order. In a const
/// World it is one for reading.
///   struct Cab {
///     const Body& body;
///     const Tank& tank;
///     static constexpr auto columns() {
///       return Lines{&CarColumns::body, &CarColumns::tank};
///     }
///   };
template <class View, class AnyWorld>
class Views {
 public:
  template <class Columns>
  Views(AnyWorld& world, const Columns& keys)
      : first_(with_lines(lines_of(View::columns()), [&](auto... member) {
          return First{world.rows(keys.*member).data()...};
        })) {}

  /// The view of a row; what is no column follows as `rest`.
  template <class... Rest>
  [[nodiscard]] View at(std::size_t row, Rest&&... rest) const {
    return at_both(row, *this, row, std::forward<Rest>(rest)...);
  }
  /// The same where what is written in perceive is that of `sensed_row` in another world.
  template <class... Rest>
  [[nodiscard]] View at_both(std::size_t row, const Views& sensed, std::size_t sensed_row,
                             Rest&&... rest) const {
    return [&]<std::size_t... I>(std::index_sequence<I...>)->View {
      return {(kSensed[I] ? line<I>(sensed.first_)[sensed_row] : line<I>(first_)[row])...,
              std::forward<Rest>(rest)...};
    }
    (std::make_index_sequence<First::size()>{});
  }

 private:
  template <class World, class Columns, class... Row>
  static auto first_of(const Lines<Column<Row> Columns::*...>&)
      -> Lines<decltype(std::declval<World&>().rows(std::declval<Column<Row>>()).data())...>;
  template <class Columns, class... Row>
  [[nodiscard]] static constexpr std::array<bool, sizeof...(Row)> sensed(
      const Lines<Column<Row> Columns::*...>& members) {
    return with_lines(members, [](auto... member) {
      return std::array{Columns::is_written_in(member, Phase::perceive)...};
    });
  }

  using First = decltype(first_of<AnyWorld>(lines_of(View::columns())));
  static constexpr auto kSensed = sensed(lines_of(View::columns()));
  First first_;  ///< row of each column
};

}  // namespace eyrie::sim
