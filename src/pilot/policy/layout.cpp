// SPDX-License-Identifier: MIT
#include "pilot/policy/layout.hpp"

namespace eyrie::pilot {
namespace {

constexpr std::string_view kBlank = " \t\r";

bool begins_number(std::string_view word) {
  return !word.empty() && std::string_view("+-.0123456789").find(word.front()) != word.npos;
}

}  // namespace

std::string_view LayoutLine::next_word() const {
  const std::size_t begin = line_.find_first_not_of(kBlank, at_);
  if (begin == line_.npos)
    return line_.substr(line_.size());
  return line_.substr(begin, std::min(line_.find_first_of(kBlank, begin), line_.size()) - begin);
}

std::string_view LayoutLine::word() {
  const std::string_view word = next_word();
  begin_ = static_cast<std::size_t>(word.data() - line_.data());
  at_ = begin_ + word.size();
  return word;
}

std::nullopt_t LayoutLine::fail(std::string message) {
  if (!failed_) {
    Location where = where_;
    if (where.column)
      where.column += static_cast<int>(begin_);
    diagnostics_.error(std::move(where), std::move(message));
  }
  failed_ = true;
  return std::nullopt;
}

bool LayoutLine::end() {
  if (const std::string_view more = word(); !more.empty())
    fail("expected the end of the line, got " + quote(more));
  return !failed_;
}

std::optional<double> LayoutLine::quantity(Dimension dimension) {
  std::string text(word());
  const std::size_t begin = begin_;
  if (const std::string_view unit = next_word();
      begins_number(text) && !unit.empty() && !begins_number(unit))
    text.append(" ").append(word());
  begin_ = begin;
  const Parsed parsed = parse_quantity(text, dimension);
  if (parsed)
    return parsed.value;
  const std::string_view example = dimension_example(dimension);
  return fail(text.empty() ? fmt::format("expected two numbers from less to more{}{}, got the end",
                                         example.empty() ? "" : ", such as ", example)
                           : parsed.error);
}

std::optional<std::pair<double, double>> LayoutLine::range(Dimension dimension) {
  const std::optional<double> low = quantity(dimension);
  const std::optional<double> high = low ? quantity(dimension) : std::nullopt;
  if (!high)
    return std::nullopt;
  if (!(*low < *high))
    return fail("the range must go from less to more");
  return std::pair(*low, *high);
}

}  // namespace eyrie::pilot
