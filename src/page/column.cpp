// SPDX-License-Identifier: MIT
#include "page/column.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/assert.hpp"
#include "core/bytes.hpp"

namespace eyrie::page {
namespace {

std::uint64_t zigzag(std::int64_t value) {
  return (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
}

/// What is written of each value: itself, what it differs by from the last, or that from the last
/// difference.
class Differences {
 public:
  [[nodiscard]] std::array<std::uint64_t, 3> next(std::int64_t value) {
    const std::int64_t difference = value - std::exchange(last_, value);
    return {zigzag(value), zigzag(difference),
            zigzag(difference - std::exchange(slope_, difference))};
  }

 private:
  std::int64_t last_ = 0, slope_ = 0;
};

}  // namespace

std::int64_t Column::rounded(double value) const {
  if (!std::isfinite(value))
    return kNothing;
  const double quanta = std::floor(value / quantum_ + 0.5);
  constexpr double kMost = 9e15;  // what is beyond is shown as the most
  return static_cast<std::int64_t>(std::clamp(quanta, -kMost, kMost));
}

Json ColumnBytes::put(const Column& column) {
  std::array<std::size_t, 3> sizes{};
  Differences measured;
  for (const std::int64_t value : column.values()) {
    const auto numbers = measured.next(value);
    for (std::size_t order = 0; order < sizes.size(); ++order)
      sizes[order] += varint_size(numbers[order]);
  }
  const auto order = static_cast<std::size_t>(std::ranges::min_element(sizes) - sizes.begin());
  Json place = Json::array({bytes_.size(), column.values().size(), column.quantum(), order});
  Differences written;
  for (const std::int64_t value : column.values())
    put_varint(bytes_, written.next(value)[order]);
  return place;
}

Columns::Columns(std::initializer_list<Head> heads) {
  for (const Head& head : heads)
    columns_.emplace_back(head.name, Column(head.quantum));
}

void Columns::add(std::initializer_list<double> row) {
  EYRIE_ASSERT(row.size() == columns_.size());
  auto column = columns_.begin();
  for (const double value : row)
    (column++)->second.add(value);
}

void Columns::forget() {
  for (auto& [name, column] : columns_)
    column.forget();
}

Json Columns::json(ColumnBytes& bytes) const {
  Json json = Json::object();  // one made of null ends the program where memory runs out
  for (const auto& [name, column] : columns_)
    json[std::string(name)] = bytes.put(column);
  return json;
}

}  // namespace eyrie::page
