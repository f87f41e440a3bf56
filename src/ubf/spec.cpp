// SPDX-License-Identifier: MIT
#include "ubf/spec.hpp"

#include <map>

#include "core/text.hpp"
#include "ubf/expression.hpp"

namespace eyrie::ubf {
namespace {

const Value kNothing;

std::nullopt_t refuse(const Value& value, Diagnostics& diagnostics) {
  return diagnostics.error(value.where,
                           "expected a node, such as 'navigate' or {{navigate: {{...}}}}, got {}",
                           value.shown());
}

struct Argument {
  const Value* value = nullptr;
  bool is_default = true;
  bool used = false;
};
using Arguments = std::map<std::string, Argument, std::less<>>;

/// The part of a tree that is a tree: all of it, if it has no parameters.
const Value& root_of(const Value& tree) {
  const Value* root = tree.find(kParametersKey) ? tree.find(kRootKey) : nullptr;
  return root ? *root : tree;
}

bool is_name(char c) {
  return is_letter(c) || is_digit(c) || c == '_';
}

/// Puts arguments in place of `$name`, everywhere below a value.
class Filling {
 public:
  Filling(std::string_view tree, Arguments& arguments, Diagnostics& diagnostics)
      : tree_(tree), arguments_(arguments), diagnostics_(diagnostics) {}

  void fill(Value& value) {
    const std::size_t within = open_.size();
    if (value.is_scalar() && value.text.find('$') != value.text.npos && !fill_text(value))
      return;
    for (Value& item : value.items)
      fill(item);
    for (Value::Entry& e : value.entries)
      fill(e.value);
    open_.resize(within);
  }

 private:
  /// False if an argument took its place, which has the names of whoever gave it.
  bool fill_text(Value& value) {
    const std::string text = std::move(value.text);
    value.text.clear();
    for (std::size_t at = 0; at < text.size();) {
      if (text[at] != '$') {
        value.text += text[at++];
        continue;
      }
      std::size_t end = at + 1;
      while (end < text.size() && is_name(text[end]))
        ++end;
      const std::string_view name = std::string_view(text).substr(at + 1, end - at - 1);
      if (name.empty()) {
        value.text += text[at++];
        continue;
      }
      const Arguments::value_type* found = find(value.where, name);
      const Value* argument = found ? found->second.value : nullptr;
      if (argument && at == 0 && end == text.size()) {
        if (std::ranges::find(open_, name) != open_.end()) {
          diagnostics_.error(value.where, "parameter {} contains itself: {} -> {}", quote(name),
                             fmt::join(open_, " -> "), name);
          return false;
        }
        put(*argument, value);
        if (found->second.is_default)
          open_.push_back(found->first);
        return found->second.is_default;
      }
      if (argument && !argument->is_scalar())
        diagnostics_.error(value.where, "'${}' is {}: it cannot be a piece of a text", name,
                           argument->shown());
      else if (argument)
        value.text += argument->text;
      at = end;
    }
    return true;
  }
  /// An argument that is used twice in a tree that is used twice ... must not fill the memory.
  void put(const Value& argument, Value& value) {
    copied_ += size(argument);
    if (copied_ <= kMostCopied) {
      std::string tag = std::move(value.tag);  // of `!tree $name`
      value = Value(argument);
      if (!tag.empty())
        value.tag = std::move(tag);
    } else if (!full_)
      diagnostics_.error(value.where, "the arguments of tree {} make it larger than {} values",
                         quote(tree_), kMostCopied);
    full_ = copied_ > kMostCopied;
  }
  static std::size_t size(const Value& value) {
    std::size_t n = 1;
    for (const Value& item : value.items)
      n += size(item);
    for (const Value::Entry& e : value.entries)
      n += size(e.value);
    return n;
  }
  const Arguments::value_type* find(const Location& where, std::string_view name) {
    const auto found = arguments_.find(name);
    if (found == arguments_.end()) {
      diagnostics_.error(where, "tree {} has no parameter {}{}", quote(tree_), quote(name),
                         nearest_or_all(name, listed(arguments_, &Arguments::value_type::first)));
      return nullptr;
    }
    found->second.used = true;
    return &*found;
  }

  std::string_view tree_;
  Arguments& arguments_;
  Diagnostics& diagnostics_;
  std::vector<std::string_view> open_;  ///< parameters whose defaults are being filled
  std::size_t copied_ = 0;
  bool full_ = false;

  static constexpr std::size_t kMostCopied = 100'000;
};

/// The parameters of a tree with their defaults; null for those without.
Arguments declared(std::string_view name, const Value& tree, Diagnostics& diagnostics) {
  Arguments arguments;
  const Value* parameters = tree.find(kParametersKey);
  if (!parameters)
    return arguments;
  for (const Value::Entry& e : tree.entries)
    if (e.key != kParametersKey && e.key != kRootKey)
      diagnostics.error(e.where, "a tree with parameters has 'parameters' and 'root', got {}",
                        quote(e.key));
  if (!tree.find(kRootKey))
    diagnostics.error(tree.where, "tree {} has parameters but no 'root'", quote(name));
  if (!parameters->is_map())
    diagnostics.error(parameters->where, "parameters: expected a map from names to defaults, got " +
                                             parameters->shown());
  for (const Value::Entry& e : parameters->entries) {
    if (e.key.empty() || !std::ranges::all_of(e.key, is_name))
      diagnostics.error(e.where, "{} is no name of a parameter: use letters, digits and '_'",
                        quote(e.key));
    else if (e.key == kFieldsKey)
      diagnostics.error(
          e.where,
          "a parameter cannot be called 'fields': a reference renames state fields under that key");
    else
      arguments.emplace(e.key, Argument{e.value.is_null() ? nullptr : &e.value});
  }
  return arguments;
}

/// The tree with those arguments in it, or nothing after reporting.
std::optional<Value> filled(std::string_view name, const Value& tree, Arguments& arguments,
                            Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count();
  Value root = root_of(tree);
  Filling filling(name, arguments, diagnostics);
  filling.fill(root);
  const Value* parameters = tree.find(kParametersKey);
  // a default that a reference replaces may name a parameter that nothing else names
  if (parameters && diagnostics.count() == before)
    for (Value::Entry e : parameters->entries)
      if (!arguments.at(e.key).is_default)
        filling.fill(e.value);
  for (const auto& [parameter, argument] : arguments)
    if (!argument.used && diagnostics.count() == before)
      diagnostics.error(parameters->find_entry(parameter)->where,
                        "tree {} never uses its parameter {}", quote(name), quote(parameter));
  if (diagnostics.count() != before)
    return std::nullopt;
  return root;
}

std::vector<FieldRename> read_renames(const Value& value, Diagnostics& diagnostics) {
  std::vector<FieldRename> renames;
  if (!value.is_map()) {
    diagnostics.error(
        value.where,
        "fields: expected a map from the tree's names of state fields to the platform's, got " +
            value.shown());
    return renames;
  }
  for (const Value::Entry& e : value.entries) {
    if (!e.value.is_scalar())
      diagnostics.error(e.value.where, "fields: {}: expected the name of a state field, got {}",
                        quote(e.key), e.value.shown());
    else
      renames.push_back({e.key, e.value.text});
  }
  return renames;
}

}  // namespace

std::optional<NodeSpec> read_spec(const Value& value, Diagnostics& diagnostics) {
  if (value.tag == kTreeTag)
    return NodeSpec{std::string(kTreeReference), value.where, &value};
  if (value.is_scalar() && looks_like_expression(value.text))
    return NodeSpec{std::string(kHolds), value.where, &value};
  if (value.is_scalar())
    return NodeSpec{value.text, value.where, &kNothing};
  if (!value.is_map() || value.entries.empty())
    return refuse(value, diagnostics);
  if (value.entries.size() > 1)  // most often the parameters are not indented far enough
    return diagnostics.error(value.entries[1].where,
                             "a node is one name with its parameters below it, but beside {} there "
                             "is {}; a parameter must be indented further than its node",
                             quote(value.entries[0].key), quote(value.entries[1].key));
  const Value::Entry& only = value.entries.front();
  return NodeSpec{only.key, only.where, &only.value};
}

std::optional<std::string> label_problem(std::string_view label) {
  if (label.empty())
    return "must not be empty";
  if (label.find_first_of("/[]") != label.npos)
    return fmt::format("{} must not contain '/', '[' or ']'", quote(label));
  if (const auto held = text_problem(label))
    return fmt::format("{} holds {}", quote(label), *held);
  if (const std::size_t size = characters(label); size > kLongestLabel)
    return fmt::format("{} has {} characters, at most {} fit", quote(label), size, kLongestLabel);
  return std::nullopt;
}

std::string read_label(const Value& body, Diagnostics& diagnostics) {
  const Value* label = body.find(kLabelKey);
  if (!label)
    return {};
  if (!label->is_scalar()) {
    diagnostics.error(label->where, "name: expected a text, got {}", label->shown());
    return {};
  }
  if (const auto problem = label_problem(label->text)) {
    diagnostics.error(label->where, "name: " + *problem);
    return {};
  }
  return label->text;
}

std::optional<Reference> read_reference(const Value& body, const Location& where,
                                        Diagnostics& diagnostics) {
  if (body.is_scalar())
    return Reference{body.text, body.where, {}, {}, {}};
  if (!body.is_map() || body.entries.size() != 1)
    return diagnostics.error(where,
                             "a reference names its tree, as in {tree: ingress}, or with arguments "
                             "{tree: {ingress: {vote: 40}}}");
  const Value::Entry& only = body.entries.front();
  Reference reference{only.key, only.where, {}, {}, {}};
  if (only.value.is_null())
    return reference;
  if (!only.value.is_map())
    return diagnostics.error(only.value.where, "tree {}: expected its arguments as a map, got {}",
                             quote(only.key), only.value.shown());
  const std::size_t before = diagnostics.count();
  for (const Value::Entry& e : only.value.entries) {
    if (e.key == kFieldsKey) {
      reference.renames = read_renames(e.value, diagnostics);
      reference.renames_where = e.where;
    } else {
      reference.arguments.push_back(&e);
    }
  }
  if (diagnostics.count() != before)
    return std::nullopt;
  return reference;
}

bool needs_arguments(const Value& tree) {
  const Value* parameters = tree.find(kParametersKey);
  return parameters && std::ranges::any_of(parameters->entries,
                                           [](const Value::Entry& e) { return e.value.is_null(); });
}

void check_parameters(std::string_view name, const Value& tree, Diagnostics& diagnostics) {
  static const Value kNoArgument = Value::scalar("");
  const std::size_t before = diagnostics.count();
  Arguments arguments = declared(name, tree, diagnostics);
  for (auto& [parameter, argument] : arguments)
    if (!argument.value)
      argument.value = &kNoArgument;
  if (diagnostics.count() == before)
    static_cast<void>(filled(name, tree, arguments, diagnostics));
}

std::optional<Value> instantiate(std::string_view name, const Value& tree,
                                 const std::vector<const Value::Entry*>& given,
                                 const Location& where, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count();
  Arguments arguments = declared(name, tree, diagnostics);
  for (const Value::Entry* e : given) {
    const auto parameter = arguments.find(e->key);
    if (parameter == arguments.end())
      diagnostics.error(e->where, "tree {} has no parameter {}{}", quote(name), quote(e->key),
                        nearest_or_all(e->key, listed(arguments, &Arguments::value_type::first)));
    else
      parameter->second = {.value = &e->value, .is_default = false};
  }
  for (const auto& [parameter, argument] : arguments)
    if (!argument.value)
      diagnostics.error(where, "tree {} needs the argument {}", quote(name), quote(parameter));
  if (diagnostics.count() != before)
    return std::nullopt;
  return filled(name, tree, arguments, diagnostics);
}

Value body_for_another_type(const Value& body, const NodeInfo* type) {
  if (!body.is_map())
    return body;
  const auto takes = [&](std::string_view key) {
    return !type ||
           std::ranges::find(type->parameters, key, &ParamInfo::name) != type->parameters.end();
  };
  Value kept = Value::map({}, body.where);
  for (const Value::Entry& e : body.entries)
    if (e.key == kLabelKey || e.key == "children" ||
        ((e.key == "vote" || e.key == "vote_scale") && takes(e.key)))
      kept.entries.push_back(e);
  return kept;
}

Location place_of_problem(const NodeSpec& spec) {
  if (!spec.where.file.text().starts_with("--set"))  // else the type is what was changed
    for (const Value::Entry& e : spec.body->entries)
      if (!(e.value.where.file == spec.where.file) && e.value.where.line > 0)
        return e.value.where;
  return spec.where;
}

}  // namespace eyrie::ubf
