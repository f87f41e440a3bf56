// SPDX-License-Identifier: MIT
#include "ubf/expression.hpp"

#include <algorithm>
#include <cctype>

#include "core/text.hpp"

namespace eyrie::ubf {
namespace {

using detail::Instruction;
using detail::Op;
using detail::Operand;

/// Letters of Latin, Greek and Cyrillic, too: one that only looks like ours is told as what it is.
bool begins_word(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return is_letter(c) || c == '_' || (byte >= 0xC3 && byte <= 0xD4);
}
bool is_word(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return begins_word(c) || is_digit(c) || c == '.' || (byte >= 0x80 && byte <= 0xBF);
}
bool is_keyword(std::string_view word) {
  return word == "and" || word == "or" || word == "not";
}

struct Comparison {
  std::string_view sign;
  Op op;
};
constexpr std::array kComparisons = std::to_array<Comparison>({{"<=", Op::less_equal},
                                                               {">=", Op::greater_equal},
                                                               {"==", Op::equal},
                                                               {"!=", Op::not_equal},
                                                               {"<", Op::less},
                                                               {">", Op::greater}});

/// What stands on one side of a comparison, before the other side says what it must be.
struct Side {
  std::size_t at = 0;     ///< where it begins in the text
  std::string_view text;  ///< as written
  std::optional<std::size_t> field;
};

constexpr int kMostNested = 32;

/// Recursive descent. The first mistake ends it.
class Parser {
 public:
  Parser(const Value& value, std::span<const StateFieldInfo> fields, FieldNames& names,
         Diagnostics& diagnostics)
      : value_(value),
        text_(value.text),
        fields_(fields),
        names_(names),
        diagnostics_(diagnostics) {}

  std::optional<std::vector<Instruction>> parse() {
    const bool good = any_of(0);
    space();
    if (good && at_ < text_.size() && text_[at_] == ')')
      fail(at_, "there is no '(' for this ')'");
    else if (good && at_ < text_.size())
      fail(at_, "expected 'and', 'or' or the end, got {}{}", quote(rest_word()),
           did_you_mean(rest_word(), std::array<std::string_view, 2>{"and", "or"}));
    if (failed_)
      return std::nullopt;
    return std::move(program_);
  }

 private:
  /// Of UTF-8: "°" is one of them.
  static int characters(std::string_view text) {
    return static_cast<int>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
  }
  template <class... T>
  bool fail(std::size_t at, fmt::format_string<T...> words, T&&... values) {
    if (!failed_) {
      Location where = value_.where;
      if (where.column)
        where.column += characters(text_.substr(0, at)) + (value_.quoted ? 1 : 0);
      diagnostics_.error(where, "{}", fmt::format(words, std::forward<T>(values)...));
    }
    failed_ = true;
    return false;
  }
  template <class... T>
  std::nullopt_t none(std::size_t at, fmt::format_string<T...> words, T&&... values) {
    fail(at, words, std::forward<T>(values)...);
    return std::nullopt;
  }
  void space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])))
      ++at_;
  }
  [[nodiscard]] std::string_view word_at(std::size_t at) const {
    std::size_t end = at;
    while (end < text_.size() && is_word(text_[end]))
      ++end;
    return text_.substr(at, end - at);
  }
  [[nodiscard]] std::string_view rest_word() const {
    const std::string_view word = word_at(at_);
    return word.empty() ? text_.substr(at_, 1) : word;
  }
  bool take_word(std::string_view word) {
    space();
    if (word_at(at_) != word)
      return false;
    at_ += word.size();
    return true;
  }
  bool take(char c) {
    space();
    if (at_ >= text_.size() || text_[at_] != c)
      return false;
    ++at_;
    return true;
  }

  using Rule = bool (Parser::*)(int);
  /// `part { word part }`, where `skip` ends it early.
  bool chain(std::string_view word, Op skip, Rule part, int depth) {
    if (!(this->*part)(depth))
      return false;
    std::vector<std::size_t> skips;
    while (take_word(word)) {
      skips.push_back(program_.size());
      program_.push_back({.op = skip, .left = {}, .right = {}});
      if (!(this->*part)(depth))
        return false;
    }
    for (const std::size_t i : skips)
      program_[i].target = static_cast<std::uint32_t>(program_.size());
    return true;
  }
  bool any_of(int depth) { return chain("or", Op::skip_if_true, &Parser::all_of, depth); }
  bool all_of(int depth) { return chain("and", Op::skip_if_false, &Parser::factor, depth); }

  bool factor(int depth) {
    space();
    if (depth > kMostNested)
      return fail(at_, "nested more than {} deep", kMostNested);
    if (take_word("not")) {
      if (!factor(depth + 1))
        return false;
      program_.push_back({.op = Op::negate, .left = {}, .right = {}});
      return true;
    }
    const std::size_t begin = at_;
    if (take('(')) {
      if (!any_of(depth + 1))
        return false;
      return take(')') || fail(begin, "there is no ')' for this '('");
    }
    return comparison();
  }

  bool comparison() {
    const std::optional<Side> left = side();
    if (!left)
      return false;
    space();
    const auto sign = std::ranges::find_if(
        kComparisons, [&](const auto& c) { return text_.substr(at_).starts_with(c.sign); });
    if (sign == kComparisons.end()) {
      static constexpr std::array<std::array<std::string_view, 2>, 5> kMeant{
          {{"=>", ">="}, {"=<", "<="}, {"\u2264", "<="}, {"\u2265", ">="}, {"\u2260", "!="}}};
      for (const auto& [written, meant] : kMeant)
        if (text_.substr(at_).starts_with(written))
          return fail(at_, "write '{}' for '{}'", meant, written);
      if (at_ < text_.size() && text_[at_] == '=')
        return fail(at_, "write '==' to compare");
      return flag(*left);
    }
    at_ += sign->sign.size();
    const std::optional<Side> right = side();
    if (!right)
      return false;
    space();
    if (at_ < text_.size() && std::string_view("<>=!").find(text_[at_]) != std::string_view::npos)
      return fail(at_, "compare two things at a time, as in 1 nmi < range and range < 10 nmi");
    return compare(*left, sign->op, *right);
  }

  /// A field, a quantity or the name of a choice; the other side tells the last two apart.
  std::optional<Side> side() {
    space();
    if (at_ >= text_.size())
      return none(at_, "expected {} or a quantity, got the end", names_.one());
    Side side{.at = at_, .text = {}, .field = {}};
    if (begins_word(text_[at_])) {
      side.text = word_at(at_);
      if (is_keyword(side.text))
        return none(at_, "expected {} or a quantity, got {}", names_.one(), quote(side.text));
      at_ += side.text.size();
      if (const std::size_t field = names_.find(fields_, side.text); field < fields_.size())
        side.field = field;
      return side;
    }
    quantity();
    side.text = text_.substr(side.at, at_ - side.at);
    if (side.text.empty())
      return none(at_, "expected {} or a quantity, got {}", names_.one(), quote(rest_word()));
    return side;
  }
  /// A number and, behind it, a unit.
  void quantity() {
    const auto number = [](char c) { return is_digit(c) || c == '.' || c == '-' || c == '+'; };
    while (at_ < text_.size() &&
           (number(text_[at_]) || ((text_[at_] == 'e' || text_[at_] == 'E') &&
                                   at_ + 1 < text_.size() && number(text_[at_ + 1]))))
      ++at_;
    std::size_t unit = at_;
    while (unit < text_.size() && text_[unit] == ' ')
      ++unit;
    std::size_t end = unit;
    const auto in_unit = [](char c) {
      return is_word(c) || c == '/' || c == '^' || c == '%' || c == '*' || (c & 0x80);  // "°"
    };
    while (end < text_.size() && in_unit(text_[end]))
      ++end;
    if (end > unit && !is_keyword(text_.substr(unit, end - unit)))
      at_ = end;
  }

  [[nodiscard]] const StateFieldInfo& info(const Side& side) const { return fields_[*side.field]; }
  bool unknown(const Side& side) { return fail(side.at, "{}", names_.unknown(fields_, side.text)); }
  static Operand operand(std::size_t field) {
    return {.field = static_cast<std::uint32_t>(field), .number = 0};
  }

  bool flag(const Side& side) {
    if (!side.field && begins_word(side.text.front()))
      return unknown(side);
    if (!side.field)
      return fail(side.at, "{} is compared with nothing", quote(side.text));
    if (info(side).kind != FieldKind::flag)
      return fail(side.at, "{} is not true or false: compare it, as in {}", quote(side.text),
                  example(side));
    program_.push_back({.op = Op::flag, .left = operand(*side.field), .right = {}});
    return true;
  }
  [[nodiscard]] std::string example(const Side& side) const {
    const StateFieldInfo& f = info(side);
    if (f.kind == FieldKind::choice)
      return fmt::format("{} == {}", side.text, f.choices.empty() ? "..." : f.choices.front());
    const std::string_view quantity = dimension_example(f.unit.dimension);
    return fmt::format("{} < {}", side.text, quantity.empty() ? "1" : quantity);
  }

  bool compare(const Side& left, Op op, const Side& right) {
    if (!left.field && !right.field) {
      const Side& word = begins_word(left.text.front()) ? left : right;
      return begins_word(word.text.front()) ? unknown(word)
                                            : fail(left.at, "neither side is {}", names_.one());
    }
    const Side& field = left.field ? left : right;
    const Side& other = left.field ? right : left;
    const StateFieldInfo& f = info(field);
    if (f.kind == FieldKind::flag)
      return fail(field.at, "{} is true or false: write {} or not {}", quote(field.text),
                  field.text, field.text);
    if (f.kind == FieldKind::choice && op != Op::equal && op != Op::not_equal)
      return fail(field.at, "{} is one of several: compare it with == or !=", quote(field.text));
    std::optional<Operand> value = other.field ? same_kind(field, other) : number(field, other);
    if (!value)
      return false;
    Instruction i{.op = op, .left = operand(*field.field), .right = *value};
    if (&field == &right)
      std::swap(i.left, i.right);
    program_.push_back(i);
    return true;
  }
  std::optional<Operand> same_kind(const Side& field, const Side& other) {
    const StateFieldInfo &a = info(field), &b = info(other);
    if (a.kind == b.kind && a.unit == b.unit && a.choices.data() == b.choices.data())
      return operand(*other.field);
    return none(other.at, "{} cannot be compared with {}", quote(other.text), quote(field.text));
  }
  std::optional<Operand> number(const Side& field, const Side& other) {
    const StateFieldInfo& f = info(field);
    if (f.kind == FieldKind::choice) {
      const auto choice = std::ranges::find(f.choices, other.text);
      if (choice != f.choices.end())
        return Operand{.field = Operand::kNumber,
                       .number = static_cast<double>(choice - f.choices.begin())};
      return none(other.at, "{} is never {}{}", quote(field.text), quote(other.text),
                  did_you_mean(other.text, f.choices));
    }
    if (begins_word(other.text.front())) {
      unknown(other);
      return std::nullopt;
    }
    const Parsed parsed = parse_quantity(other.text, f.unit.dimension);
    if (!parsed)
      return none(other.at, "{}: {}", field.text, parsed.error);
    if (const std::string problem = never(f, field.text, parsed.value, other.text);
        !problem.empty())
      return none(other.at, "{}", problem);
    return Operand{.field = Operand::kNumber, .number = parsed.value};
  }

  const Value& value_;
  std::string_view text_;
  std::span<const StateFieldInfo> fields_;
  FieldNames& names_;
  Diagnostics& diagnostics_;
  std::vector<Instruction> program_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

}  // namespace

std::optional<std::vector<Instruction>> parse_expression(const Value& text,
                                                         std::span<const StateFieldInfo> fields,
                                                         FieldNames& names,
                                                         Diagnostics& diagnostics) {
  if (!text.is_scalar())
    return diagnostics.error(
        text.where, "expected a condition in words, as in range < 10 nmi, got " + text.shown());
  return Parser(text, fields, names, diagnostics).parse();
}

bool looks_like_expression(std::string_view text) {
  if (text.find_first_of("<>=!()") != text.npos || text.starts_with("not "))
    return true;
  for (const std::string_view word : {" and ", " or ", "\u2264", "\u2265", "\u2260"})
    if (text.find(word) != text.npos)
      return true;
  return text.ends_with(" and") || text.ends_with(" or");
}

}  // namespace eyrie::ubf
