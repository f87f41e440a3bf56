// SPDX-License-Identifier: MIT
#include "ubf/registry.hpp"

#include <exception>

#include "core/bind.hpp"
#include "core/text.hpp"

namespace eyrie::ubf {
namespace {

/// "tree 'a' refers to itself: a -> b -> a", if `name` is being read already; `open` are the trees
/// being read, outermost first.
std::optional<std::string> cycle_through(std::span<const std::string> open, std::string_view name) {
  const auto first = std::ranges::find(open, name);
  if (first == open.end())
    return std::nullopt;
  return fmt::format("tree {} refers to itself: {} -> {}", quote(name),
                     fmt::join(first, open.end(), " -> "), name);
}

/// No node, and its mistake has been reported.
NodeReader::Child no_node(std::nullopt_t) {
  return nullptr;
}

/// A name, or a map whose only key is none of the type's own: the only child, without its slot.
bool is_child_alone(const NodeType& type, const Value& body) {
  if (type.grammar != Grammar::slots || type.child_keys.size() != 1)
    return false;
  if (body.is_scalar())
    return true;
  if (!body.is_map() || body.entries.size() != 1)
    return false;
  const std::string& key = body.entries.front().key;
  return key != kLabelKey && key != type.child_keys.front() && !type.parameters->find(key);
}

}  // namespace

NodeReader::Child NodeReader::read(const Value& value) {
  if (full_ || diagnostics_.full())
    return nullptr;
  const std::optional<NodeSpec> spec = read_spec(value, diagnostics_);
  if (!spec)
    return nullptr;
  if (spec->type == kTreeReference)
    return read_reference(*spec);
  if (!within_limits(spec->where))
    return nullptr;
  ++depth_;
  Child node = changes_.empty() ? make(*spec) : make_changed(*spec);
  --depth_;
  return node;
}

AnyNode::Children NodeReader::read_list(std::span<const Value> values) {
  AnyNode::Children children;
  for (const Value& value : values)
    if (Child child = read(value))
      children.push_back(std::move(child));
  return children;
}

NodeReader::Child NodeReader::read_tree(const std::string& name, const Value& value,
                                        const std::vector<const Value::Entry*>& arguments,
                                        const Location& where) {
  std::optional<Value> filled;
  if (value.find(kParametersKey) || !arguments.empty()) {
    filled = instantiate(name, value, arguments, where.line ? where : value.where, diagnostics_);
    if (!filled)
      return nullptr;
  }
  const std::size_t before = diagnostics_.count();
  open_.push_back(name);
  Child root = read(filled ? *filled : value);
  open_.pop_back();
  if (!arguments.empty())
    diagnostics_.trace_to(before, where, "with the arguments at");
  return root;
}

std::vector<detail::Instruction> NodeReader::expression(const Value& text) {
  return expression(text, registry_.fields_);
}
std::vector<detail::Instruction> NodeReader::expression(const Value& text,
                                                        std::span<const StateFieldInfo> fields) {
  if (characters(text.text) > kLongestText)  // whoever bound it has said so
    return {};
  return parse_expression(text, fields, names_, diagnostics_)
      .value_or(std::vector<detail::Instruction>{});
}

std::optional<std::size_t> NodeReader::field(const Value& name) {
  const std::size_t found = names_.find(registry_.fields_, name.text);
  if (found < registry_.fields_.size())
    return found;
  return diagnostics_.error(name.where, names_.unknown(registry_.fields_, name.text));
}

bool NodeReader::within_limits(const Location& where) {
  if (depth_ >= kMaxDepth) {
    diagnostics_.error(where, "nodes are nested more than {} deep", kMaxDepth);
    return false;
  }
  if (++count_ > kMaxNodes) {
    diagnostics_.error(where, "the tree has more than {} nodes", kMaxNodes);
    full_ = true;
    return false;
  }
  return true;
}

NodeReader::Child NodeReader::read_reference(const NodeSpec& spec) {
  std::optional<Reference> reference = ubf::read_reference(*spec.body, spec.where, diagnostics_);
  if (!reference)
    return nullptr;
  const std::string& name = reference->name;
  const auto tree = std::ranges::find(trees_, name, &NamedSpec::name);
  if (tree == trees_.end()) {
    const auto known = diagnostics_.full() ? std::span<const NamedSpec>() : trees_;
    return no_node(diagnostics_.error(reference->where, "there is no tree {}{}", quote(name),
                                      nearest_or_all(name, listed(known, &NamedSpec::name))));
  }
  if (const auto cycle = cycle_through(open_, name))
    return no_node(diagnostics_.error(reference->where, *cycle));
  if (open_.size() >= kMaxDepth)
    return no_node(
        diagnostics_.error(spec.where, "trees refer to one another more than {} deep", kMaxDepth));
  names_.push(std::move(reference->renames));
  Child root = read_tree(name, *tree->value, reference->arguments, reference->where);
  for (const FieldRename& rename : names_.pop())
    if (root && !rename.used)
      diagnostics_.error(reference->renames_where, "fields: nothing in tree {} reads {}",
                         quote(name), quote(rename.from));
  if (root && root->label() == root->type())
    root->set_label(name);
  return root;
}

/// The node that was read last, with the changes that are meant for it.
NodeReader::Child NodeReader::make_changed(NodeSpec spec) {
  Value body;
  pending_.clear();
  for (const NodeChange& change : changes_) {
    if (change.node + std::size_t{1} != count_)
      continue;
    if (!change.key.empty()) {
      pending_.push_back(&change);
      continue;
    }
    if (!change.value.is_scalar() || change.value.text == kTreeReference)
      return no_node(diagnostics_.error(change.value.where, "expected the name of a node, got {}",
                                        change.value.shown()));
    body = body_for_another_type(*spec.body, registry_.find(change.value.text));
    spec = {change.value.text, change.value.where, &body};
  }
  Child node = make(spec);
  pending_.clear();
  return node;
}

NodeReader::Child NodeReader::make(const NodeSpec& spec) {
  const auto found = registry_.by_name_.find(spec.type);
  if (found == registry_.by_name_.end()) {
    // a flag of the state is a condition in words
    if (spec.body->is_null() && registry_.find(kHolds) && is_flag(spec.type)) {
      const Value words = Value::scalar(spec.type, spec.where);
      return make({std::string(kHolds), spec.where, &words});
    }
    const std::string first = spec.type.substr(0, spec.type.find_first_of(" {["));
    diagnostics_.error(spec.where, "there is no node {}{}", quote(spec.type),
                       first != spec.type && registry_.find(first)
                           ? fmt::format("; a colon is missing behind '{}'", first)
                           : registry_.did_you_mean(spec.type));
    read_below_unknown(*spec.body);
    return nullptr;
  }
  try {
    Child node = make(*registry_.types_[found->second], spec);
    if (node && registry_.infos_[found->second].origin != "eyrie")
      node->distrust();
    return node;
  } catch (const std::bad_alloc&) {  // nobody's mistake
    throw;
  } catch (const std::exception& e) {
    return no_node(diagnostics_.error(spec.where, "node {} (of {}) could not be made: {}",
                                      quote(spec.type), registry_.infos_[found->second].origin,
                                      e.what()));
  }
}

/// The mistakes in what are children whatever the node is.
void NodeReader::read_below_unknown(const Value& body) {
  const Value* const only = body.find("child");
  const Value* const list = body.is_list() ? &body : body.find("children");
  if (only)
    static_cast<void>(read(*only));
  if (list)
    static_cast<void>(read_list(list->items));
}

NodeReader::Child NodeReader::make(const NodeType& type, const NodeSpec& spec) {
  if (!type.text_key.empty() && spec.body->is_scalar()) {
    const Value whole = Value::map({entry(std::string(type.text_key), *spec.body)}, spec.where);
    return make(type, {spec.type, spec.where, &whole});
  }
  if (!pending_.empty()) {
    const Value whole = with_pending(type, *spec.body);
    return make(type, {spec.type, spec.where, &whole});
  }
  if (type.parameters->find("vote"))
    if (const Value* vote = spec.body->find("vote"); vote && vote->is_map())
      return make_voting(type, spec, *vote);
  const std::size_t before = diagnostics_.count();
  Child node = type.make(type);
  node->set_type(type);
  node->where_ = spec.where;
  node->set_label(read_label(*spec.body, diagnostics_));
  switch (type.grammar) {
    case Grammar::none:
      read_leaf(*node, spec);
      break;
    case Grammar::list:
    case Grammar::list_or_one:
      read_children(*node, spec);
      break;
    case Grammar::slots:
      read_slots(*node, spec);
      break;
    case Grammar::own:
      bind(*node, *spec.body, {type.child_keys.begin(), type.child_keys.end()});
      break;
  }
  if (type.read && (diagnostics_.count() == before || spec.body->is_map()))
    type.read(*node, spec, *this);
  if (diagnostics_.count() != before)
    return nullptr;
  if (const std::string problem = node->problem(); !problem.empty())
    return no_node(diagnostics_.error(place_of_problem(spec), problem));
  return node;
}

/// A node whose vote follows the state (ubf/vote_curve.hpp).
NodeReader::Child NodeReader::make_voting(const NodeType& type, const NodeSpec& spec,
                                          const Value& text) {
  std::optional<VoteCurve> curve = read_vote(
      text, registry_.fields_, [&](const Value& name) { return field(name); }, diagnostics_);
  Value whole = *spec.body;
  std::erase_if(whole.entries, [](const Value::Entry& e) { return e.key == "vote"; });
  if (const Value* most = text.find("most"); most && !most->is_map())
    whole.entries.push_back(entry("vote", *most));
  Child node = make(type, {spec.type, spec.where, &whole});
  if (!curve || !node)
    return nullptr;
  const std::optional<double> most = node->full_vote();
  if (curve->least > 0 && !(most && curve->least <= *most))
    return no_node(diagnostics_.error(
        text.where, most ? fmt::format("vote: 'least' is {}, above the full vote of {}",
                                       curve->least, static_cast<float>(*most))
                         : "vote: 'least' needs 'most' beside it"));
  if (most && *most > 0)
    curve->least /= *most;
  node->set_vote_curve(std::move(*curve));
  return node;
}

/// A body with the changes of parameters put in.
Value NodeReader::with_pending(const NodeType& type, const Value& body) {
  Value whole = body;
  if (body.is_null())
    whole = Value::map({}, body.where);
  else if (body.is_list())
    whole = Value::map({entry("children", body)}, body.where);
  else if (is_child_alone(type, body))
    whole = Value::map({entry(std::string(type.child_keys.front()), body)}, body.where);
  for (const NodeChange* change : std::exchange(pending_, {})) {
    if (Value::Entry* there = whole.find_entry(change->key))
      *there = {change->key, change->where, change->value};
    else
      whole.entries.push_back({change->key, change->where, change->value});
  }
  return whole;
}

/// The parameters (`- navigate:` has none); the label and `also` are read by others.
bool NodeReader::bind(AnyNode& node, const Value& body, std::vector<std::string_view> also) {
  also.push_back(kLabelKey);
  return eyrie::detail::bind(*node.type_->parameters, node.type_->object(node),
                             body.is_null() ? Value::map({}, node.where_) : body, {}, diagnostics_,
                             also);
}

void NodeReader::read_leaf(AnyNode& node, const NodeSpec& spec) {
  const Value* children = spec.body->find("children");
  if (!children)
    children = spec.body->find("child");
  if (spec.body->is_list() || children)
    diagnostics_.error(children ? children->where : spec.where, "{} is a {} and takes no children",
                       spec.type, to_text(node.node_kind()));
  else
    bind(node, *spec.body, {});
}

/// `{type: [child, ...]}` or `{type: {children: [child, ...], ...}}`
void NodeReader::read_children(AnyNode& node, const NodeSpec& spec) {
  const bool takes_one = node.type_->grammar == Grammar::list_or_one;
  const Value* list = spec.body;
  const Value* only = nullptr;
  if (spec.body->is_scalar()) {
    diagnostics_.error(spec.body->where, "{}: write children as a list: [{}]", spec.type,
                       printable(spec.body->text, 40));
    return;
  }
  if (spec.body->is_list()) {
    bind(node, Value::map({}, spec.where), {});
  } else {
    if (!refuse_nodes_as_keys(node, spec))
      return;
    if (const Value* child = spec.body->find("child"); child && !takes_one) {
      diagnostics_.error(child->where, "{} has 'children', a list, and no 'child'", spec.type);
      return;
    }
    bind(node, *spec.body,
         takes_one ? std::vector<std::string_view>{"children", "child"}
                   : std::vector<std::string_view>{"children"});
    list = spec.body->find("children");
    only = takes_one ? spec.body->find("child") : nullptr;
  }
  if (only && list)
    diagnostics_.error(only->where, "{} has either 'child' or 'children'", spec.type);
  else if (only)
    node.children_ = read_list(std::span(only, 1));
  else if (list && !list->is_list())
    diagnostics_.error(list->where, "children: expected a list of nodes, got {}", list->shown());
  else if (!list || list->items.empty())
    diagnostics_.error(list ? list->where : spec.where, "{} needs at least one child", spec.type);
  else
    node.children_ = read_list(list->items);
}

/// `{type: child}` if there is one slot, or `{type: {slot: child, ...}}`
void NodeReader::read_slots(AnyNode& node, const NodeSpec& spec) {
  const std::span<const std::string_view> slots = node.type_->child_keys;
  const Value& body = *spec.body;
  if (body.is_list() || body.find("children")) {
    if (slots.size() == 1)
      diagnostics_.error(
          spec.where,
          "{} takes exactly one '{}'; put several nodes under an arbiter or a control node",
          spec.type, slots.back());
    else
      diagnostics_.error(spec.where, "{0} takes its children by name: {0}: {{{1}: ...}}", spec.type,
                         fmt::join(slots, ": ..., "));
    return;
  }
  if (is_child_alone(*node.type_, body)) {
    bind(node, Value::map({}, spec.where), {});
    node.children_ = read_list(std::span(&body, 1));
    return;
  }
  bind(node, body, {slots.begin(), slots.end()});
  for (const std::string_view slot : slots) {
    if (const Value* child = body.find(slot))
      node.children_.push_back(read(*child));
    else
      diagnostics_.error(spec.where, "{} needs '{}'", spec.type, slot);
  }
}

/// `winner_takes_all: {navigate: ..., pursue: ...}` is meant as a list.
bool NodeReader::refuse_nodes_as_keys(const AnyNode& node, const NodeSpec& spec) {
  for (const auto& entry : spec.body->entries) {
    if (!registry_.find(entry.key) || entry.key == "children" || entry.key == "child" ||
        node.type_->parameters->find(entry.key))
      continue;
    diagnostics_.error(
        entry.where, "{} is a node, not a parameter of {}; write children as a list: {}: [{}, ...]",
        quote(entry.key), spec.type, spec.type, entry.key);
    return false;
  }
  return true;
}

}  // namespace eyrie::ubf
