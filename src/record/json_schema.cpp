// SPDX-License-Identifier: MIT
#include "record/json_schema.hpp"

#include "record/json_text.hpp"
#include "ubf/spec.hpp"

namespace eyrie::record {
namespace {

using scenario::Catalog;
using scenario::FilePart;
using scenario::ModelKind;

constexpr const char* kFlightPattern = "^[a-z]([a-z0-9_]*[a-z_])?$";
constexpr const char* kPlayerPattern = "^[a-z]([a-z0-9_]*[a-z_])?[1-8]$";
constexpr const char* kLabel = "^[^/\\[\\]]+$";

Json any_of(Json first, Json second) {
  return {{"anyOf", Json::array({std::move(first), std::move(second)})}};
}
Json one_or_nothing(Json schema) {
  return any_of(std::move(schema), {{"type", "null"}});
}
Json list_of(Json item) {
  return {{"type", "array"}, {"minItems", 1}, {"items", std::move(item)}};
}
/// A map that has that key.
Json needing(std::string_view key) {
  return {{"required", Json::array({key})}};
}
/// A map with free names.
Json map_of(Json value) {
  return {{"type", "object"}, {"additionalProperties", std::move(value)}};
}

// nodes

bool has(const ubf::NodeInfo& node, std::string_view key) {
  return std::ranges::find(node.child_keys, key) != node.child_keys.end();
}

/// A vote that follows the state, in the place of a number (ubf/vote_curve.hpp).
Json vote_curve() {
  const Json end{{"type", Json::array({"string", "number"})}};
  const Json one{{"of", {{"type", "string"}}},
                 {"from", end},
                 {"to", end},
                 {"curve", {{"enum", enum_names<ubf::Curve>()}}}};
  Json all = one;
  all["most"] = all["least"] = {{"type", "number"}};
  all["product"] = list_of(closed_map(one, {"of"}));
  Json curve = closed_map(std::move(all));
  curve["oneOf"] = {needing("of"), needing("product")};
  return curve;
}

/// Parameters and label, not yet children.
Json node_map(const ubf::NodeInfo& node) {
  Json map = map_schema(node.parameters);
  if (map["properties"].contains("vote")) {
    Json& vote = map["properties"]["vote"];
    const std::string help = vote.value("description", "");
    vote = any_of(std::move(vote), vote_curve());
    vote["description"] = help;
  }
  map["properties"][std::string(ubf::kLabelKey)] = {
      {"type", Json::array({"string", "number", "boolean"})},
      {"pattern", kLabel},
      {"description", "what reports and traces call it; default: the type"}};
  return map;
}

void require(Json& map, std::string_view key) {
  map["required"].push_back(key);
}

Json sequencer(Json map) {
  Json name{{"type", "string"}, {"pattern", kLabel}};
  map["properties"]["start"] = {{"type", "string"}, {"description", "the first tree in charge"}};
  map["properties"]["trees"] = map_of(reference_to("node"));
  map["properties"]["trees"].update(
      {{"minProperties", 1},
       {"propertyNames", {{"pattern", kLabel}, {"not", {{"const", "any"}}}}},
       {"description", "the trees by name"}});
  const Json link =
      closed_map({{"from", {{"type", "string"}, {"description", "the tree that is left, or any"}}},
                  {"to", {{"type", "string"}, {"description", "the tree that is entered"}}},
                  {"when", reference_to("node")}},
                 {"from", "to", "when"});
  map["properties"]["transitions"] = one_or_nothing({{"type", "array"}, {"items", link}});
  map["properties"]["transitions"]["description"] =
      "asked in this order, at most one is taken per tick";
  require(map, "start");
  require(map, "trees");
  return map;
}

/// One list under `children`, one node under `child`, or the list alone.
Json composite(Json map, bool takes_one_child) {
  map["properties"]["children"] = list_of(reference_to("node"));
  Json parameters_left = map.value("required", Json::array());
  if (takes_one_child) {
    map["properties"]["child"] = reference_to("node");
    map["oneOf"] = {needing("children"), needing("child")};
  } else {
    require(map, "children");
  }
  return parameters_left.empty() ? any_of(list_of(reference_to("node")), std::move(map)) : map;
}

/// A node per slot, or the only one alone.
Json slots(const ubf::NodeInfo& node, Json map) {
  const bool alone = node.child_keys.size() == 1 && !map.contains("required");
  for (const std::string& slot : node.child_keys) {
    map["properties"][slot] = reference_to("node");
    require(map, slot);
  }
  return alone ? any_of(std::move(map), reference_to("node")) : map;
}

/// A node per value, and one for the others.
Json switch_body(Json map) {
  map["properties"]["cases"] = map_of(reference_to("node"));
  map["properties"]["cases"]["minProperties"] = 1;
  map["properties"]["default"] = reference_to("node");
  require(map, "cases");
  return map;
}

/// `tree: name`, or with arguments, which the tree describes.
Json reference_schema() {
  Json with{{"type", "object"},
            {"additionalProperties",
             one_or_nothing({{"type", "object"}, {"additionalProperties", true}})},
            {"minProperties", 1},
            {"maxProperties", 1}};
  Json schema = any_of({{"type", "string"}}, std::move(with));
  schema["description"] = "a copy of the tree of that name, with arguments if it has parameters";
  return schema;
}

/// What stands below the name of a node.
Json body(const ubf::NodeInfo& node) {
  Json map = node_map(node);
  if (std::ranges::equal(node.child_keys, ubf::kSequencerKeys))
    return sequencer(std::move(map));
  if (has(node, "cases"))
    return switch_body(std::move(map));
  if (!node.text_key.empty())
    return any_of(Json{{"type", "string"}}, std::move(map));
  if (has(node, "children"))
    return composite(std::move(map), has(node, "child"));
  if (!node.child_keys.empty())
    return slots(node, std::move(map));
  return map.contains("required") ? map : one_or_nothing(std::move(map));
}

bool stands_alone(const ubf::NodeInfo& node) {
  return node.child_keys.empty() && std::ranges::none_of(node.parameters, &ParamInfo::required);
}

Json node_definition(const Catalog& catalog) {
  Json names = Json::array();
  Json types{{std::string(ubf::kTreeReference), reference_schema()}};
  for (const ubf::NodeInfo& node : catalog.nodes) {
    if (stands_alone(node))
      names.push_back(node.name);
    Json schema = body(node);
    const std::string origin = node.origin == "eyrie" ? "" : " of " + node.origin;
    schema["description"] = node.help + " (" + std::string(to_text(node.kind)) + origin + ")";
    types[node.name] = std::move(schema);
  }
  // a pilot's node has every parameter of another agent's of the same name
  for (const scenario::OtherKind& kind : catalog.others)
    for (const ubf::NodeInfo& node : kind.nodes)
      if (!types.contains(node.name)) {
        if (stands_alone(node))
          names.push_back(node.name);
        types[node.name] = body(node);
        types[node.name]["description"] = fmt::format("{} (of {})", node.help, kind.plural);
      }
  Json words{{"type", "string"}, {"pattern", "[<>=!()]|^not | and | or "}};
  Json one = closed_map(std::move(types));
  one["minProperties"] = one["maxProperties"] = 1;
  Json node = any_of(any_of({{"enum", names}}, std::move(words)), std::move(one));
  node["description"] = "a node of a tree: its name, or its name with parameters or children";
  return node;
}

// models

Json model_definition(const ModelKind& kind) {
  Json map = map_schema(kind.parameters, Required::left_to_base);
  Json needed = Json::array();
  for (const ParamInfo& info : kind.parameters)
    if (info.required)
      needed.push_back(info.name);
  map["properties"]["base"] = {
      {"type", "string"},
      {"description", "another model of this kind, for everything that is not said here"}};
  map["properties"]["source"] = {{"description", "where the numbers come from"}};
  if (!needed.empty())
    map["anyOf"] = {needing("base"), {{"required", needed}}};
  std::string description = kind.help;
  for (const auto& [name, origin] : kind.origins)
    description += "; " + name + " is of " + origin;
  map["description"] = description;
  return map;
}

Json data_schema(const Catalog& catalog) {
  Json kinds = Json::object();
  for (const ModelKind& kind : catalog.models)
    kinds[kind.folder] = map_of(reference_to("model." + kind.folder));
  return closed_map(std::move(kinds));
}

// the file

Json include_schema() {
  const Json file{{"type", "string"}, {"minLength", 1}};
  return any_of(file, {{"type", "array"}, {"items", file}});
}

/// Where a change is made, and what is put there.
Json changes_schema(bool beside) {
  return {{"type", "object"},
          {"additionalProperties", true},
          {"propertyNames",
           {{"pattern", fmt::format("^{}[^.]+(\\.[^.]+)*$", beside ? "(before |after )?" : "")}}}};
}

class Root {
 public:
  explicit Root(const Catalog& catalog) : catalog_(catalog) {}

  Json write() {
    Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                {"$id", "urn:eyrie:scenario:1"},
                {"title", "Eyrie scenario"}};
    const FilePart& top = part("scenario");
    Json map = map_schema(top.parameters);
    schema["description"] = top.help;
    schema.update(map);
    schema["properties"].at("orders")["items"]["anyOf"] = {needing("swap_tree"), needing("lose")};
    put(schema, "extends",
        {{"type", "string"}, {"minLength", 1}, {"examples", catalog_.scenarios}});
    put(schema, "include", include_schema());
    put(schema, "insert", changes_schema(true));
    put(schema, "replace", changes_schema(false));
    put(schema, "remove", include_schema());
    put(schema, "plugins", include_schema());
    put(schema, "trees", trees());
    put(schema, "data", data_schema(catalog_));
    put(schema, "blue", reference_to("side"));
    put(schema, "red", reference_to("side"));
    demand_if_alone(schema);
    schema["definitions"] = definitions();
    return schema;
  }

 private:
  const FilePart& part(std::string_view name) const {
    return *std::ranges::find(catalog_.file, name, &FilePart::name);
  }

  /// The shape of a key that is read by hand, under the description it has already.
  static void put(Json& map, const std::string& key, Json shape) {
    Json& place = map["properties"].at(key);
    if (shape.contains("$ref"))
      shape = {{"allOf", Json::array({shape})}};
    shape["description"] = place.at("description");
    place = std::move(shape);
  }

  /// Neither a scenario that extends another nor a package needs what a scenario does.
  static void demand_if_alone(Json& schema) {
    static constexpr std::array<std::string_view, 4> kOfPackages{"include", "plugins", "trees",
                                                                 "data"};
    Json is_scenario = Json::array();
    for (const auto& [key, shape] : schema["properties"].items())
      if (std::ranges::find(kOfPackages, key) == kOfPackages.end())
        is_scenario.push_back(needing(key));
    schema["if"] = {{"anyOf", is_scenario}, {"not", needing("extends")}};
    schema["then"] = {{"required", schema["required"]},
                      {"anyOf", {needing("blue"), needing("red")}}};
    schema.erase("required");
  }

  static Json trees() {
    Json with_parameters = closed_map(
        {{std::string(ubf::kParametersKey),
          {{"type", "object"},
           {"additionalProperties", true},
           {"propertyNames",
            {{"pattern", "^[A-Za-z0-9_]+$"}, {"not", {{"const", ubf::kFieldsKey}}}}},
           {"description", "names and defaults; one without a default must be given"}}},
         {std::string(ubf::kRootKey), {{"description", "a node, with $name for parameters"}}}},
        {ubf::kParametersKey, ubf::kRootKey});
    return map_of(any_of(reference_to("node"), std::move(with_parameters)));
  }

  Json definitions() const {
    Json result = dimension_definitions();
    result["node"] = node_definition(catalog_);
    for (const ModelKind& kind : catalog_.models)
      result["model." + kind.folder] = model_definition(kind);
    result["player"] = map_schema(part("player").parameters);
    add_examples(result["player"]);
    result["flight"] = group("flight", "player");
    result["side"] = map_schema(part("side").parameters);
    Json flights = map_of(reference_to("flight"));
    flights.update({{"minProperties", 1}, {"propertyNames", {{"pattern", kFlightPattern}}}});
    put(result["side"], "flights", flights);
    result["vehicle"] = map_schema(part("vehicle").parameters);
    add_examples(result["vehicle"]);
    result["convoy"] = group("convoy", "vehicle");
    Json convoys = flights;
    convoys["additionalProperties"] = map_of(reference_to("convoy"))["additionalProperties"];
    put(result["side"], "convoys", convoys);
    result["side"]["anyOf"] = Json::array({needing("flights")});
    for (const scenario::OtherKind& kind : catalog_.others) {
      result["side"]["anyOf"].push_back(needing(kind.key));
      if (result.contains(kind.group))
        continue;
      result[kind.group] = map_schema(part(kind.group).parameters);
      put(result["side"], kind.key, map_of(reference_to(kind.group)));
    }
    return result;
  }

  /// A flight or a convoy, and its members.
  Json group(std::string_view name, const std::string& member) const {
    Json map = map_schema(part(name).parameters);
    add_examples(map);
    Json overrides{{"type", "object"},
                   {"minProperties", 1},
                   {"maxProperties", 1},
                   {"propertyNames", {{"pattern", kPlayerPattern}}},
                   {"additionalProperties", one_or_nothing(reference_to(member))}};
    Json players = list_of(any_of({{"type", "string"}, {"pattern", kPlayerPattern}}, overrides));
    players["maxItems"] = 8;
    put(map, "players", players);
    return map;
  }

  /// The models there are, for completion: others may stand in the file itself.
  void add_examples(Json& map) const {
    for (const ModelKind& kind : catalog_.models) {
      if (kind.folder == "aircraft" && map["properties"].contains("aircraft"))
        map["properties"]["aircraft"]["examples"] = kind.names;
      if (kind.folder == "vehicles" && map["properties"].contains("vehicle"))
        map["properties"]["vehicle"]["examples"] = kind.names;
      if (kind.folder == "missiles" && map["properties"].contains("loadout"))
        map["properties"]["loadout"]["examples"] = Json::array({kind.names});
    }
  }

  const Catalog& catalog_;
};

/// On one line what fits, the rest with a line for each of its parts: short for a file that is
/// kept, and one change is one line.
void write(const Json& json, std::size_t indent, std::string& out) {
  constexpr std::size_t kLine = 200;
  std::string line = json_text(json);
  if (!json.is_structured() || indent + line.size() < kLine) {
    out += line;
    return;
  }
  out += json.is_object() ? "{" : "[";
  for (const auto& [key, value] : json.items()) {
    if (out.back() != '{' && out.back() != '[')
      out += ",";
    out += "\n" + std::string(indent + 1, ' ');
    if (json.is_object())
      out += json_text(Json(key)) + ": ";
    write(value, indent + 1, out);
  }
  out += "\n" + std::string(indent, ' ') + (json.is_object() ? "}" : "]");
}

}  // namespace

std::string catalog_json_schema(const scenario::Catalog& catalog) {
  std::string text;
  write(Root(catalog).write(), 0, text);
  return text + "\n";
}

}  // namespace eyrie::record
