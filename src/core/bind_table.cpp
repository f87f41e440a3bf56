// SPDX-License-Identifier: MIT

#include "core/bind.hpp"

namespace eyrie::detail {
namespace {

constexpr std::string_view kUnitsKey = "units";
constexpr std::string_view kValueKey = "value";

/// One list of numbers of a table: where it is, what each number is, and the unit that `units`
/// gives to all of them.
struct Series {
  const Value* list = nullptr;
  ParamInfo info;
  const UnitInfo* shared = nullptr;
};

/// Reads the parts of one table. After a mistake, what depends on it is not checked.
class TableReader {
 public:
  TableReader(const Value& map, const ParamInfo& table, Diagnostics& diagnostics)
      : map_(map), table_(table), diagnostics_(diagnostics), before_(diagnostics.count()) {
    std::vector<std::string_view> names;
    for (const TableAxis& axis : table.axes)
      names.push_back(axis.name);
    names.push_back(kValueKey);
    if (!map.is_map()) {
      error(map, table.name, "expected a table, got {}", map.shown());
      return;
    }
    check_keys(map, "the table", table.name, names, std::array{kUnitsKey}, diagnostics);
    if (const Value* units = map.find(kUnitsKey))
      check_keys(*units, "units", fmt::format("{}.units", table.name), names, {}, diagnostics);
  }

  [[nodiscard]] bool ok() const { return diagnostics_.count() == before_; }

  Series axis_series(std::size_t which) {
    return series(table_.axes[which].name, table_.axes[which].unit, {});
  }
  Series value_series() { return series(kValueKey, table_.unit, table_.limits); }

  /// The breakpoints of an axis: at least one, and increasing.
  std::vector<double> breakpoints(const Series& axis) {
    if (!axis.list || !check_list(*axis.list, 1, axis.info.max_items, axis.info, diagnostics_))
      return {};
    const std::size_t before = diagnostics_.count();
    std::vector<double> result = numbers(axis);
    for (std::size_t i = 1; i < result.size() && diagnostics_.count() == before; ++i)
      if (result[i] <= result[i - 1])
        error(axis.list->items[i], fmt::format("{}[{}]", axis.info.name, i),
              "{} is not above {}: breakpoints must increase", axis.list->items[i].text,
              axis.list->items[i - 1].text);
    return result;
  }

  /// Exactly `count` numbers.
  std::vector<double> numbers(const Series& series, std::size_t count) {
    return check_list(*series.list, count, count, series.info, diagnostics_)
               ? numbers(series)
               : std::vector<double>{};
  }

  /// What only the table itself finds wrong, such as breakpoints too far apart.
  bool accept(const std::optional<std::string>& problem) {
    if (problem)
      error(map_, table_.name, "{}", *problem);
    return !problem;
  }

 private:
  template <class... T>
  void error(const Value& at, std::string_view path, fmt::format_string<T...> words,
             T&&... values) {
    diagnostics_.error(at.where, "{}: {}", path, fmt::format(words, std::forward<T>(values)...));
  }

  Series series(std::string_view key, Unit unit, Range limits) {
    Series result;
    result.info.name = fmt::format("{}.{}", table_.name, key);
    result.info.unit = unit;
    result.info.limits = limits;
    result.list = map_.find(key);
    if (!result.list && map_.is_map())
      report_missing(map_, "the table", table_.name, key, diagnostics_);
    const Value* units = map_.find(kUnitsKey);
    const Value* symbol = units ? units->find(key) : nullptr;
    if (!symbol)
      return result;
    const UnitInfo* known = symbol->is_scalar() ? find_unit(symbol->text) : nullptr;
    if (known && known->dimension == unit.dimension)
      result.shared = known;
    else
      error(*symbol, fmt::format("{}.units.{}", table_.name, key), "{}",
            unit.dimension == Dimension::none
                ? fmt::format("these are plain numbers and have no unit, got {}", symbol->shown())
                : fmt::format("expected the unit of {}, such as '{}', got {}",
                              dimension_noun(unit.dimension), unit.si_symbol, symbol->shown()));
    return result;
  }

  std::vector<double> numbers(const Series& series) {
    std::vector<double> result(series.list->items.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      read_one(result[i], series.list->items[i], item_info(series.info, i), series.shared);
    return result;
  }

  void read_one(double& out, const Value& value, const ParamInfo& info, const UnitInfo* shared) {
    if (!shared) {
      read_number(out, value, info, diagnostics_);
      return;
    }
    // with a shared unit a number stands alone; then it is as if it carried that unit
    ParamInfo plain = info;
    plain.unit = {};
    plain.limits = {};
    double number = 0;
    if (!read_number(number, value, plain, diagnostics_))
      return;
    const std::string text = fmt::format("{} {}", value.text, shared->symbol);
    read_number(out, Value::scalar(text, value.where), info, diagnostics_);
  }

  const Value& map_;
  const ParamInfo& table_;
  Diagnostics& diagnostics_;
  std::size_t before_;
};

}  // namespace

bool read_table(Table1& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics) {
  TableReader reader(value, info, diagnostics);
  const Series axis = reader.axis_series(0);
  const Series series = reader.value_series();
  std::vector<double> breakpoints = reader.breakpoints(axis);
  std::vector<double> values;
  if (series.list && !breakpoints.empty())
    values = reader.numbers(series, breakpoints.size());
  if (!reader.ok() || !reader.accept(Table1::problem(breakpoints, values)))
    return false;
  out = Table1(std::move(breakpoints), std::move(values));
  return true;
}

bool read_table(Table2& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics) {
  TableReader reader(value, info, diagnostics);
  const Series row_axis = reader.axis_series(0);
  const Series column_axis = reader.axis_series(1);
  const Series series = reader.value_series();
  std::vector<double> rows = reader.breakpoints(row_axis);
  std::vector<double> columns = reader.breakpoints(column_axis);
  std::vector<double> values;
  const bool shaped = series.list && !rows.empty() && !columns.empty();
  if (shaped && check_list(*series.list, rows.size(), rows.size(), series.info, diagnostics)) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Series row{&series.list->items[i], item_info(series.info, i), series.shared};
      const std::vector<double> numbers = reader.numbers(row, columns.size());
      values.insert(values.end(), numbers.begin(), numbers.end());
    }
  }
  if (!reader.ok() || !reader.accept(Table2::problem(rows, columns, values)))
    return false;
  out = Table2(std::move(rows), std::move(columns), std::move(values));
  return true;
}

}  // namespace eyrie::detail
