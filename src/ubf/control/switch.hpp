// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "ubf/composite.hpp"
#include "ubf/node_reader.hpp"

namespace eyrie::ubf {

struct SwitchMemory {
  std::uint16_t open = 0;  ///< 1 + the child that goes on since the last tick, 0 for none
};

/// Asks the child whose case is what a field of the state says, in every tick anew; `default` for
/// every other value and for none. When another child's turn comes, the one before forgets. Vote
/// and status are the child's; without a child for the value it fails.
///   switch: {on: phase, cases: {ingress: navigate, egress: {tree: home}}, default: pursue}
template <class State, class Action>
class Switch final : public WithMemory<Voting<State, Action>, SwitchMemory> {
  using Base = WithMemory<Voting<State, Action>, SwitchMemory>;

 public:
  static constexpr std::string_view type_name = "switch";
  static constexpr std::string_view help = "the child whose case a state field names";
  static constexpr Kind kind = Kind::control;
  static constexpr std::array<std::string_view, 2> child_keys{"cases", "default"};
  [[nodiscard]] static constexpr auto params() {
    return std::tuple_cat(
        std::tuple{param("on", &Switch::on, "the state field that is looked at").required()},
        Voting<State, Action>::template vote_params<Switch>());
  }
  using Base::Base;

  std::string on;

  [[nodiscard]] bool remembers() const noexcept override { return false; }
  [[nodiscard]] bool stands() const noexcept override { return this->any_child_stands(); }
  [[nodiscard]] NodeIndex active_child(const std::byte* slab) const noexcept override {
    const auto& m = this->memory(slab);
    return m.open ? static_cast<NodeIndex>(m.open - 1) : kNone;
  }

  [[nodiscard]] std::string problem() const override {
    if (!read_)
      return "a switch needs a field to look at";
    const std::size_t count = this->children_.size();
    if (count != values_.size() && count != values_.size() + 1)
      return fmt::format(
          "a switch has a child per value, and perhaps one more, but here are {} "
          "for {} values",
          count, values_.size());
    return Base::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    const std::size_t chosen = child_for(read_(t.state));
    if (m.open && m.open != chosen + 1) {
      this->halt(*this->children_[m.open - 1u], t);
      m.open = 0;
    }
    if (chosen == this->children_.size())
      return Status::failure;
    const auto& child = *this->children_[chosen];
    const Status answer = this->ask(child, t, out);
    m.open = static_cast<std::uint16_t>(this->left_open(child, answer) ? chosen + 1 : 0);
    this->took(t, child);
    this->rescale(out);
    return answer;
  }

  /// For code that builds a tree without a file: what is looked at, and the value of each child;
  /// one child more than values is the default.
  void look_at(double (*field)(const State&), std::vector<double> values) {
    read_ = field;
    values_ = std::move(values);
  }
  /// For NodeReader.
  void read(const NodeSpec& spec, NodeReader<State, Action>& reader) {
    const Value* name = spec.body->find("on");
    const auto field = name && name->is_scalar() ? reader.field(*name) : std::nullopt;
    const Value* cases = spec.body->find("cases");
    if (!cases || !cases->is_map() || cases->entries.empty())
      return reader.error(cases ? cases->where : spec.where,
                          "switch needs 'cases', a map from values to nodes");
    const auto fields = StateFields<State>::all();
    typename Base::Children children;
    std::vector<double> values;
    for (const Value::Entry& e : cases->entries) {
      if (field)
        if (const auto value = value_of(fields[*field].info, e, reader.diagnostics())) {
          if (std::find(values.begin(), values.end(), *value) != values.end())
            reader.error(e.where, fmt::format("there are two cases {}", quote(e.key)));
          values.push_back(*value);
        }
      if (auto child = reader.read(e.value))
        children.push_back(std::move(child));
    }
    if (const Value* other = spec.body->find("default"))
      if (auto child = reader.read(*other))
        children.push_back(std::move(child));
    if (field)
      look_at(fields[*field].read, std::move(values));
    this->adopt(std::move(children));
  }

 private:
  [[nodiscard]] std::size_t child_for(double value) const {
    std::size_t i = 0;
    while (i < values_.size() && values_[i] != value)
      ++i;
    return i;  // the default, or behind the last child
  }
  static std::optional<double> value_of(const StateFieldInfo& field, const Value::Entry& e,
                                        Diagnostics& diagnostics) {
    if (field.kind == FieldKind::number) {
      const Parsed parsed = parse_quantity(e.key, field.unit.dimension);
      if (parsed)
        return parsed.value;
      diagnostics.error(e.where, fmt::format("{}: {}", field.name, parsed.error));
      return std::nullopt;
    }
    static constexpr std::array<std::string_view, 2> kTruth{"false", "true"};
    const std::span<const std::string_view> choices =
        field.kind == FieldKind::flag ? std::span<const std::string_view>(kTruth) : field.choices;
    const auto choice = std::find(choices.begin(), choices.end(), e.key);
    if (choice != choices.end())
      return static_cast<double>(choice - choices.begin());
    diagnostics.error(e.where, fmt::format("{} is never {}{}", quote(field.name), quote(e.key),
                                           did_you_mean(e.key, choices)));
    return std::nullopt;
  }

  double (*read_)(const State&) = nullptr;
  std::vector<double> values_;
};

}  // namespace eyrie::ubf
