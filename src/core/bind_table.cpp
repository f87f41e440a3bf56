// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/bind.hpp"

namespace eyrie::detail {
namespace {

constexpr std::string_view kUnitsKey = "units";
constexpr std::string_view kValueKey = "value";

/// The numbers under one key of a table, and the unit they share if `units` names one.
struct Series {
  ParamInfo info;  ///< of each number
  const UnitInfo* shared = nullptr;
};

/// Reads the parts of one table; remembers whether anything was wrong.
class TableReader {
 public:
  TableReader(const Value& map, const ParamInfo& table, Diagnostics& diagnostics)
      : map_(map), table_(table), diagnostics_(diagnostics), before_(diagnostics.count()) {
    std::vector<std::string_view> names;
    for (const TableAxis& axis : table.axes)
      names.push_back(axis.name);
    names.push_back(kValueKey);
    if (map.is_null())
      diagnostics.error(map.where, table.name + ": expected a table, got nothing");
    else if (check_keys(map, table.name, table.name, names, std::array{kUnitsKey}, diagnostics) &&
             map.find(kUnitsKey))
      check_units(*map.find(kUnitsKey), names);
  }

  [[nodiscard]] bool ok() const { return diagnostics_.count() == before_; }

  void error(const Value& at, std::string_view message) {
    diagnostics_.error(at.where, fmt::format("{}: {}", table_.name, message));
  }

  /// The list under a key; reports its absence.
  const Value* list_of(std::string_view key) {
    const Value* list = map_.find(key);
    if (!list && map_.is_map())
      error(map_, fmt::format("needs '{}'", key));
    if (list && !list->is_list()) {
      diagnostics_.error(list->where, fmt::format("{}.{}: expected a list, got {}", table_.name,
                                                  key, list->shown()));
      return nullptr;
    }
    return list;
  }

  std::vector<double> axis(std::size_t which) {
    const TableAxis& axis = table_.axes[which];
    const Value* list = list_of(axis.name);
    return list ? numbers(*list, series(axis.name, axis.unit, {})) : std::vector<double>{};
  }

  Series values() { return series(kValueKey, table_.unit, table_.limits); }

  std::vector<double> numbers(const Value& list, const Series& series) {
    std::vector<double> result(list.items.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      read_one(result[i], list.items[i], item_info(series.info, i), series.shared);
    return result;
  }

 private:
  void check_units(const Value& units, const std::vector<std::string_view>& names) {
    check_keys(units, table_.name + ".units", table_.name + ".units", names, {}, diagnostics_);
  }

  Series series(std::string_view key, Unit unit, Range limits) {
    Series result;
    result.info.name = fmt::format("{}.{}", table_.name, key);
    result.info.unit = unit;
    result.info.limits = limits;
    const Value* units = map_.find(kUnitsKey);
    const Value* symbol = units ? units->find(key) : nullptr;
    if (!symbol)
      return result;
    const UnitInfo* known = symbol->is_scalar() ? find_unit(symbol->text) : nullptr;
    if (known && known->dimension == unit.dimension)
      result.shared = known;
    else
      diagnostics_.error(symbol->where,
                         fmt::format("{}.units.{}: expected a unit of {}, got {}", table_.name, key,
                                     dimension_noun(unit.dimension), symbol->shown()));
    return result;
  }

  void read_one(double& out, const Value& value, const ParamInfo& info, const UnitInfo* shared) {
    if (!shared) {
      read_number(out, value, info, diagnostics_);
      return;
    }
    ParamInfo plain = info;
    plain.unit = {};
    plain.limits = {};
    double number = 0;
    if (!read_number(number, value, plain, diagnostics_))
      return;
    const Value with_unit =
        Value::scalar(fmt::format("{} {}", value.text, shared->symbol), value.where);
    read_number(out, with_unit, info, diagnostics_);
  }

  const Value& map_;
  const ParamInfo& table_;
  Diagnostics& diagnostics_;
  std::size_t before_;
};

}  // namespace

bool read_table(Table1& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics) {
  TableReader reader(value, info, diagnostics);
  if (!reader.ok())
    return false;
  std::vector<double> axis = reader.axis(0);
  const Value* list = reader.list_of(kValueKey);
  std::vector<double> values;
  if (list)
    values = reader.numbers(*list, reader.values());
  if (!reader.ok())
    return false;
  if (const auto problem = Table1::problem(axis, values)) {
    reader.error(value, *problem);
    return false;
  }
  out = Table1(std::move(axis), std::move(values));
  return true;
}

bool read_table(Table2& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics) {
  TableReader reader(value, info, diagnostics);
  if (!reader.ok())
    return false;
  std::vector<double> rows = reader.axis(0);
  std::vector<double> columns = reader.axis(1);
  const Value* list = reader.list_of(kValueKey);
  std::vector<double> values;
  if (list) {
    const Series series = reader.values();
    for (std::size_t i = 0; i < list->items.size(); ++i) {
      const ParamInfo row = item_info(series.info, i);
      const Value& row_list = list->items[i];
      if (!check_list(row_list, columns.size(), columns.size(), row, diagnostics))
        continue;
      const std::vector<double> numbers = reader.numbers(row_list, {row, series.shared});
      values.insert(values.end(), numbers.begin(), numbers.end());
    }
    if (list->items.size() != rows.size())
      reader.error(*list, fmt::format("expected {} rows of values, one for each '{}', got {}",
                                      rows.size(), info.axes[0].name, list->items.size()));
  }
  if (!reader.ok())
    return false;
  if (const auto problem = Table2::problem(rows, columns, values)) {
    reader.error(value, *problem);
    return false;
  }
  out = Table2(std::move(rows), std::move(columns), std::move(values));
  return true;
}

}  // namespace eyrie::detail
