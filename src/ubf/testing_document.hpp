// SPDX-License-Identifier: MIT
#pragma once
/// \file  Documents for the tests of this library, which has no YAML: `{a: [b, {c: 2 s}]}`.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/assert.hpp"
#include "core/value.hpp"

namespace eyrie::ubf::testing {

/// Reads flow style: maps, lists, plain and 'quoted' scalars, over several lines if need be. The
/// text is the test's own, so a mistake in it ends the test.
class Document {
 public:
  [[nodiscard]] static Value parse(std::string_view text, std::string file = "test.yaml") {
    Document document(text, std::move(file));
    Value value = document.value();
    document.space();
    EYRIE_DEMAND(document.at_ == text.size(), "text after the end of a test's document");
    return value;
  }

 private:
  Document(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  char take() {
    const char taken = text_[at_++];
    column_ = taken == '\n' ? 1 : column_ + 1;
    line_ += taken == '\n';
    return taken;
  }
  void space() {
    while (peek() == ' ' || peek() == '\n')
      take();
  }
  [[nodiscard]] Location here() const { return {file_, line_, column_}; }

  [[nodiscard]] std::string scalar() {
    std::string text;
    if (peek() == '\'') {
      take();
      while (peek() != '\'')
        text += take();
      take();
      return text;
    }
    while (std::string_view(",:[]{}\n").find(peek()) == std::string_view::npos && peek() != '\0')
      text += take();
    while (text.ends_with(' '))
      text.pop_back();
    return text;
  }
  [[nodiscard]] Value value() {
    space();
    const Location where = here();
    if (peek() == '[')
      return list(where);
    if (peek() == '{')
      return map(where);
    const bool quoted = peek() == '\'';
    const std::string text = scalar();
    if (text.empty() && !quoted)
      return Value::null(where);
    return quoted ? Value::quoted_scalar(text, where) : Value::scalar(text, where);
  }
  [[nodiscard]] Value list(const Location& where) {
    std::vector<Value> items;
    take();
    for (space(); peek() != ']'; space()) {
      items.push_back(value());
      separator();
    }
    take();
    return Value::list(std::move(items), where);
  }
  [[nodiscard]] Value map(const Location& where) {
    std::vector<Value::Entry> entries;
    take();
    for (space(); peek() != '}'; space()) {
      const Location key_at = here();
      std::string key = scalar();
      space();
      EYRIE_DEMAND(take() == ':', "a ':' is missing in a test's document");
      entries.push_back({std::move(key), key_at, value()});
      separator();
    }
    take();
    return Value::map(std::move(entries), where);
  }
  void separator() {
    space();
    if (peek() == ',')
      take();
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
};

}  // namespace eyrie::ubf::testing
