// SPDX-License-Identifier: MIT
#include "page/column.hpp"

#include <algorithm>
#include <cmath>

#include "core/assert.hpp"
#include "core/bytes.hpp"

namespace eyrie::page {
namespace {

std::uint64_t zigzag(std::int64_t value) {
  return (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
}

std::string encoded(const std::vector<std::int64_t>& values, int order) {
  std::string out;
  out.reserve(values.size() * 2);
  std::int64_t last = 0, slope = 0;
  for (const std::int64_t value : values) {
    const std::int64_t difference = value - last;
    put_varint(out, zigzag(order == 0 ? value : order == 1 ? difference : difference - slope));
    last = value;
    slope = difference;
  }
  return out;
}

}  // namespace

std::int64_t Column::rounded(double value) const {
  if (!std::isfinite(value))
    return kNothing;
  const double quanta = std::floor(value / quantum_ + 0.5);
  constexpr double kMost = 9e15;  // what is beyond is shown as the most
  return static_cast<std::int64_t>(std::clamp(quanta, -kMost, kMost));
}

ColumnPlace ColumnBytes::put(const Column& column) {
  ColumnPlace place{bytes_.size(), column.values().size(), column.quantum(), 0};
  std::string best;
  for (int order = 0; order < 3; ++order) {
    std::string candidate = encoded(column.values(), order);
    if (order > 0 && candidate.size() >= best.size())
      continue;
    best = std::move(candidate);
    place.order = order;
  }
  bytes_ += best;
  return place;
}

Json put(ColumnBytes& bytes, const Column& column) {
  const ColumnPlace place = bytes.put(column);
  return Json::array({place.offset, place.count, place.quantum, place.order});
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
    json[std::string(name)] = put(bytes, column);
  return json;
}

}  // namespace eyrie::page
