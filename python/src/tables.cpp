// SPDX-License-Identifier: MIT
#include "common.hpp"

namespace eyrie::python {
namespace {

/// An array of NumPy that owns what stood in the vector.
template <class T>
nb::object array_of(std::vector<T>&& values) {
  auto* const kept = new std::vector<T>(std::move(values));
  const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  return nb::cast(nb::ndarray<nb::numpy, T, nb::ndim<1>>(kept->data(), {kept->size()}, owner));
}

}  // namespace

void TableBuilder::column(std::string_view name, std::string_view unit, std::string_view help,
                          ColumnKind kind) {
  columns_.push_back({std::string(name), std::string(unit), std::string(help), kind});
}

void TableBuilder::row(std::span<const record::Cell> cells) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    Column& column = columns_[i];
    const auto* number = std::get_if<double>(&cells[i]);
    const auto* words = std::get_if<std::string>(&cells[i]);
    switch (column.kind) {
      case ColumnKind::number:
        column.numbers.push_back(number ? *number : math::kNaN);
        break;
      case ColumnKind::integer:
        column.integers.push_back(number ? static_cast<std::int64_t>(*number) : 0);
        break;
      case ColumnKind::words: {
        const std::string text = words ? printable(*words) : "";
        const auto [at, is_new] =
            column.code_of.try_emplace(text, static_cast<std::int32_t>(column.words.size()));
        if (is_new)
          column.words.push_back(text);
        column.codes.push_back(at->second);
        break;
      }
    }
  }
}

Columns TableBuilder::take() {
  constexpr std::array kKinds{"number", "integer", "words"};
  Columns all;
  for (Column& c : columns_) {
    nb::object values = c.kind == ColumnKind::number    ? array_of(std::move(c.numbers))
                        : c.kind == ColumnKind::integer ? array_of(std::move(c.integers))
                                                        : array_of(std::move(c.codes));
    all.emplace_back(c.name, c.unit, c.help, kKinds[static_cast<std::size_t>(c.kind)],
                     std::move(values), std::move(c.words));
  }
  columns_.clear();
  return all;
}

void add_event_columns(TableBuilder& table) {
  for (const record::EventColumn& column : record::event_columns()) {
    const bool is_words = column.format.empty(), is_whole = column.format == "{:.0f}";
    table.column(column.name, record::unit_of(column), column.help,
                 is_words   ? ColumnKind::words
                 : is_whole ? ColumnKind::integer
                            : ColumnKind::number);
  }
}

}  // namespace eyrie::python
