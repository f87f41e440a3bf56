// SPDX-License-Identifier: MIT
#pragma once
/// \file  Long rows of numbers in few bytes, as viewer/src/run/decode.ts reads them.
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eyrie::page {

using Json = nlohmann::ordered_json;

/// Numbers rounded to multiples of a quantum.
class Column {
 public:
  /// Stands for NaN, and for infinity where nobody tells them apart.
  static constexpr std::int64_t kNothing = -2147483648;
  static constexpr std::int64_t kNever = 2147483647;  ///< stands for infinity

  explicit Column(double quantum = 1) : quantum_(quantum) {}

  void add(double value) { values_.push_back(rounded(value)); }
  /// In quanta.
  void add_rounded(std::int64_t value) { values_.push_back(value); }
  [[nodiscard]] std::int64_t rounded(double value) const;
  [[nodiscard]] double quantum() const { return quantum_; }
  [[nodiscard]] const std::vector<std::int64_t>& values() const { return values_; }
  void forget() { values_.clear(); }

 private:
  double quantum_;
  std::vector<std::int64_t> values_;
};

/// Columns one behind the other, each as zigzag varints of whichever differences take the fewest
/// bytes: none, first or second.
class ColumnBytes {
 public:
  /// Gives where it stands, as decode.ts expects it: [offset, count, quantum, order of the
  /// differences].
  Json put(const Column& column);
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Columns that grow together, with their names in the page.
class Columns {
 public:
  struct Head {
    std::string_view name;
    double quantum = 1;
  };
  Columns(std::initializer_list<Head> heads);

  /// A number for each column, in their order.
  void add(std::initializer_list<double> row);
  [[nodiscard]] bool empty() const { return columns_.front().second.values().empty(); }
  /// By name.
  [[nodiscard]] Json json(ColumnBytes& bytes) const;
  void forget();

 private:
  std::vector<std::pair<std::string_view, Column>> columns_;
};

}  // namespace eyrie::page
