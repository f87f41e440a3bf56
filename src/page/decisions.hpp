// SPDX-License-Identifier: MIT
#pragma once
/// \file  One agent's decisions in columns.
#include <unordered_map>

#include "core/enum_names.hpp"
#include "core/hash.hpp"
#include "debrief/decision.hpp"
#include "page/column.hpp"
#include "ubf/action_traits.hpp"
#include "ubf/trace.hpp"

namespace eyrie::page {

/// Texts by number, each once.
class TextBook {
 public:
  [[nodiscard]] std::int64_t number(const std::string& text) {
    const auto [at, is_new] = numbers_.try_emplace(text, static_cast<std::int64_t>(texts_.size()));
    if (is_new)
      texts_.push_back(text);
    return at->second;
  }
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }
  /// Those that nobody has taken yet.
  [[nodiscard]] std::vector<std::string> left() const {
    return {texts_.begin() + static_cast<std::ptrdiff_t>(taken_), texts_.end()};
  }
  void take() { taken_ = texts_.size(); }

 private:
  std::unordered_map<std::string, std::int64_t> numbers_;
  std::vector<std::string> texts_;
  std::size_t taken_ = 0;
};

/// What the nodes of a tree, `all` of which are blank, answered, without values: enough to tell who
/// won, and why.
template <class Action>
[[nodiscard]] std::vector<debrief::Answer> answered(std::vector<debrief::Answer> all,
                                                    const ubf::Trace<Action>& trace) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto node = static_cast<ubf::NodeIndex>(i);
    const auto& row = trace.row(node);
    debrief::Answer& answer = all[i];
    team::take_votes(answer, trace, node);
    if (const char* said = row.ticked ? trace.why(node) : nullptr)
      answer.why = said;
    else if (!row.ticked || row.status != ubf::Status::failure)
      answer.why.clear();
    for (std::size_t f = 0; f < row.supplier.size(); ++f)
      if (row.supplier[f] != ubf::kNone)
        answer.action.push_back({.name = std::string(ubf::action_fields<Action>()[f].name),
                                 .held = row.held[f],
                                 .supplier = row.supplier[f]});
  }
  return all;
}

/// What of a decision stays the same for long: who was asked, what they answered, with which
/// votes, who supplied which field, and against whom. Kept once, however often it comes.
class ShapeBook {
 public:
  explicit ShapeBook(TextBook& texts) : texts_(texts) {}

  /// The number of the shape of a decision by tree number `tree`, whose nodes are `blank`.
  template <class Action>
  [[nodiscard]] std::int64_t number(std::size_t tree, const std::vector<debrief::Answer>& blank,
                                    ubf::NodeIndex leader, const ubf::Trace<Action>& trace) {
    key_.clear();
    append(tree);
    append(leader);
    for (std::size_t i = 0; i < blank.size(); ++i) {
      const auto node = static_cast<ubf::NodeIndex>(i);
      const auto& row = trace.row(node);
      // what is not there takes no place: most nodes are not asked
      if (!row.ticked) {
        append(char{0});
        continue;
      }
      const float vote = row.proposal.vote;
      const auto given = team::given_vote(trace, node);
      const char* why = trace.why(node);
      const bool proposes = !ubf::is_empty(row.proposal.action);
      append(static_cast<char>((1 + static_cast<int>(row.status)) | (vote != 0) << 4 |
                               given.has_value() << 5 | (why != nullptr) << 6 | proposes << 7));
      if (vote != 0)
        append(vote);
      if (given)
        append(*given);
      if (why)
        append(why);
      if (proposes) {
        append(row.supplier);
        append(row.held);
      }
    }
    const auto [at, is_new] =
        numbers_.try_emplace(key_, static_cast<std::int64_t>(numbers_.size()));
    if (is_new)
      json_.push_back(shape(tree, leader, answered(blank, trace), ubf::action_fields<Action>()));
    return at->second;
  }
  /// Those that nobody has taken yet.
  [[nodiscard]] const Json& json() const { return json_; }
  void take() { json_ = Json::array(); }

 private:
  template <class T>
  void append(const T& value) {
    key_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  /// Of the answers of all nodes; `fields` are those of the action.
  [[nodiscard]] Json shape(std::size_t tree, ubf::NodeIndex leader,
                           const std::vector<debrief::Answer>& nodes,
                           std::span<const ubf::ActionFieldInfo> fields);

  struct Hash {
    std::size_t operator()(const std::string& key) const {
      return static_cast<std::size_t>(hash_bytes(std::as_bytes(std::span(key))));
    }
  };

  TextBook& texts_;
  std::string key_;
  std::unordered_map<std::string, std::int64_t, Hash> numbers_;
  Json json_ = Json::array();
};

/// How a field of an action stands in a column: "number", "flag", "id" or "text".
template <class Field>
[[nodiscard]] constexpr std::string_view column_kind() {
  using T = typename Field::Value;
  return std::is_same_v<T, bool> ? "flag"
         : Field::is_number      ? "number"
                                 : NamedEnum<T> || requires(const T& v) {
         to_text(v);
  }
  ? "text" : "id";
}

/// What the page knows of the fields of an action.
template <class Action>
[[nodiscard]] Json action_fields() {
  Json fields = Json::array();
  ubf::for_each_field<Action>([&](const auto& f, auto) {
    using Field = std::remove_cvref_t<decltype(f)>;
    fields.push_back({{"name", f.name},
                      {"unit", f.unit.si_symbol},
                      {"form", team::form_of(f.name, f.unit.dimension)},
                      {"kind", column_kind<Field>()}});
  });
  return fields;
}

/// What numbers are rounded to that are decided with, by unit.
[[nodiscard]] inline double quantum_of(std::string_view unit) {
  return unit == "rad" ? 1e-6 : unit == "m" ? 1e-3 : 1e-4;
}

/// Steps, shapes, and the values that nodes proposed themselves: leaves all of theirs, arbiters
/// what they blended, the root what it holds of somebody who did not propose it this time.
class Decisions {
 public:
  /// Which decisions are kept; those of 0 steps are all.
  struct Thinning {
    double same = 0;   ///< steps until one that is as the last one was
    double other = 0;  ///< steps until one that is not
  };

  Decisions(ShapeBook& shapes, TextBook& texts) : shapes_(shapes), texts_(texts) {}

  /// True if it is kept and somebody else leads than in the one kept before.
  template <class Action>
  bool add(std::uint64_t step, std::size_t tree, const std::vector<debrief::Answer>& blank,
           ubf::NodeIndex leader, const ubf::Trace<Action>& trace, const Thinning& thin) {
    const auto since = static_cast<double>(step - last_step_);
    if (shape_ >= 0 && since < thin.other)
      return false;
    const std::int64_t shape = shapes_.number(tree, blank, leader, trace);
    if (shape == shape_ && since < thin.same)
      return false;
    const bool changed = tree != tree_ || leader != leader_;
    std::int64_t why = -1;
    if (changed && tree == tree_)
      why = texts_.number(
          debrief::why_not({.leader = leader, .nodes = answered(blank, trace)}, leader_));
    why_not_.add_rounded(why);
    tree_ = tree;
    leader_ = leader;
    shape_ = shape;
    last_step_ = step;
    step_.add_rounded(static_cast<std::int64_t>(step));
    shape_column_.add_rounded(shape);
    suppliers_.clear();
    for (std::size_t i = 0; i < blank.size(); ++i) {
      const auto node = static_cast<ubf::NodeIndex>(i);
      const auto& row = trace.row(node);
      if (row.ticked && (i == 0 || std::ranges::find(row.supplier, node) != row.supplier.end()))
        suppliers_.push_back(node);
    }
    fields_ = ubf::kFields<Action>;
    if (values_.size() < blank.size() * fields_)
      values_.resize(blank.size() * fields_);
    ubf::for_each_field<Action>([&](const auto& f, auto i) { add_field(f, i, trace); });
    return changed;
  }

  [[nodiscard]] Json json(ColumnBytes& bytes) const {
    Json values = Json::array();
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (!values_[i].values().empty())
        values.push_back({i / fields_, i % fields_, bytes.put(values_[i])});
    return {{"step", bytes.put(step_)},
            {"shape", bytes.put(shape_column_)},
            {"why_not", bytes.put(why_not_)},
            {"values", std::move(values)}};
  }
  [[nodiscard]] bool empty() const { return step_.values().empty(); }
  void forget() {
    step_.forget();
    shape_column_.forget();
    why_not_.forget();
    for (Column& column : values_)
      column.forget();
  }

 private:
  /// One field of all nodes that have a value of their own. What differs stays different, however
  /// little: the page must see that two nodes want two things.
  template <class Field, class Action>
  void add_field(const Field& f, std::size_t index, const ubf::Trace<Action>& trace) {
    using T = typename Field::Value;
    std::vector<std::pair<T, std::int64_t>> taken;
    for (const ubf::NodeIndex node : suppliers_) {
      const auto& row = trace.row(node);
      if (row.held[index] ? node != 0 : row.supplier[index] != node)
        continue;
      const T& value = *(row.proposal.action.*f.member);
      Column& column = values_[node * fields_ + index];
      if (column.values().empty())
        column = Column(column_kind<Field>() == "number" ? quantum_of(f.unit.si_symbol) : 1.0);
      std::int64_t number = rounded<Field>(value, column);
      for (std::size_t k = 0; k < taken.size(); ++k)
        if (taken[k].second == number && !(taken[k].first == value)) {
          number = another<Field>(number);
          k = static_cast<std::size_t>(-1);  // it may now be a third one's
        }
      taken.emplace_back(value, number);
      column.add_rounded(number);
    }
  }
  template <class Field>
  [[nodiscard]] std::int64_t rounded(const typename Field::Value& value, const Column& column) {
    using T = typename Field::Value;
    if constexpr (std::is_arithmetic_v<T>)
      return column.rounded(static_cast<double>(value));
    else if constexpr (NamedEnum<T>)
      return texts_.number(std::string(enum_name(value)));
    else if constexpr (requires { to_text(value); })
      return texts_.number(to_text(value));
    else
      return static_cast<std::int64_t>(value.value);
  }
  /// Shown alike, but not the same.
  template <class Field>
  [[nodiscard]] std::int64_t another(std::int64_t number) {
    return column_kind<Field>() == "text"
               ? texts_.number(texts_.texts()[static_cast<std::size_t>(number)] + " (another)")
               : number + 1;
  }

  ShapeBook& shapes_;
  TextBook& texts_;
  Column step_, shape_column_;
  Column why_not_;  ///< in words, why who led before leads no more; -1: he does, or another tree
  std::vector<Column> values_;  ///< by node and field
  std::size_t fields_ = 1;
  std::vector<ubf::NodeIndex> suppliers_;  ///< of the decision that is added: who has a value
  std::size_t tree_ = static_cast<std::size_t>(-1);
  ubf::NodeIndex leader_ = ubf::kNone;
  std::int64_t shape_ = -1;
  std::uint64_t last_step_ = 0;
};

}  // namespace eyrie::page
