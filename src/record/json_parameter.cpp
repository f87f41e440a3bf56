// SPDX-License-Identifier: MIT
#include "record/json_schema.hpp"

#include "core/bind.hpp"
#include "core/units.hpp"
#include "scenario/catalog.hpp"

namespace eyrie::record {
namespace {

/// Up to here a double, and so a JSON number, counts every integer.
constexpr double kExact = 9007199254740992.0;

/// The key of a dimension among the definitions: "angular_rate".
std::string dimension_key(Dimension dimension) {
  std::string key(scenario::dimension_word(dimension));
  for (char& c : key)
    c = c == ' ' ? '_' : c;
  return key;
}

/// A unit as part of a regular expression. No symbol has a character that is special there.
std::string units_pattern(Dimension dimension) {
  std::string text;
  for (const UnitInfo& unit : units())
    if (unit.dimension == dimension)
      text += (text.empty() ? "" : "|") + std::string(unit.symbol);
  return text;
}

/// "help (length, 0 m to 50 km; default 2 nmi)"
std::string description(const ParamInfo& info) {
  std::string text = info.help + " (" + scenario::kind_text(info);
  if (const std::string range = scenario::range_text(info); !range.empty())
    text += ", " + range;
  if (const std::string value = scenario::default_text(info); !value.empty())
    text += info.required ? "; required" : "; default " + value;
  return text + ")";
}

Json plain_number(const ParamInfo& info, const char* type) {
  Json schema{{"type", type}};
  if (std::isfinite(info.limits.min) && info.limits.min >= -kExact)
    schema[info.limits.exclusive_min ? "exclusiveMinimum" : "minimum"] = info.limits.min;
  if (std::isfinite(info.limits.max) && info.limits.max <= kExact)
    schema["maximum"] = info.limits.max;
  return schema;
}

Json number(Unit unit, const ParamInfo& info) {
  return unit.dimension == Dimension::none ? plain_number(info, "number")
                                           : reference_to(dimension_key(unit.dimension));
}

/// The numbers of an axis or of the values: quantities, or plain numbers if `units` says of what.
Json numbers(Unit unit, const ParamInfo& limits) {
  Json item = number(unit, limits);
  if (unit.dimension != Dimension::none)
    item = {{"anyOf", {item, {{"type", "number"}}}}};
  return {{"type", "array"}, {"minItems", 1}, {"items", item}};
}

Json table(const ParamInfo& info) {
  Json properties, symbols = Json::object();
  std::vector<std::string_view> needed{"value"};
  const auto unit_of = [&](std::string_view key, Unit unit) {
    if (unit.dimension == Dimension::none)
      return;
    Json names = Json::array();
    for (const UnitInfo& one : units())
      if (one.dimension == unit.dimension)
        names.push_back(one.symbol);
    symbols[std::string(key)] = {{"enum", names}};
  };
  for (const TableAxis& axis : info.axes) {
    properties[std::string(axis.name)] = numbers(axis.unit, {});
    needed.push_back(axis.name);
    unit_of(axis.name, axis.unit);
  }
  Json values = numbers(info.unit, info);
  if (info.kind == ParamKind::table2)
    values = {{"type", "array"}, {"minItems", 1}, {"items", values}};
  properties["value"] = values;
  unit_of("value", info.unit);
  properties["units"] = closed_map(std::move(symbols));
  return closed_map(std::move(properties), needed);
}

Json list(const ParamInfo& info) {
  constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
  // a list replaces its base's as a whole, so nothing is left to a base inside
  ParamInfo item = info.children.front();
  item.help.clear();
  Json items = parameter_schema(item);
  items.erase("description");
  Json schema{{"type", "array"}, {"items", items}};
  if (info.min_items > 0)
    schema["minItems"] = info.min_items;
  if (info.max_items != kAny)
    schema["maxItems"] = info.max_items;
  return schema;
}

Json text(const ParamInfo& info) {
  Json schema{{"type", Json::array({"string", "number", "boolean"})}};  // `name: 12`
  if (info.min_items > 0)
    schema["minLength"] = info.min_items;
  if (info.max_items <= kLongestText)
    schema["maxLength"] = info.max_items;
  return schema;
}

Json shape(const ParamInfo& info, Required required) {
  switch (info.kind) {
    case ParamKind::number:
      return number(info.unit, info);
    case ParamKind::integer:
      return plain_number(info, "integer");
    case ParamKind::boolean:
      return {{"type", "boolean"}};
    case ParamKind::text:
      return text(info);
    case ParamKind::choice:
      return {{"enum", info.choices}};
    case ParamKind::list:
      return list(info);
    case ParamKind::table1:
    case ParamKind::table2:
      return table(info);
    case ParamKind::group:
      return map_schema(info.children, required);
    case ParamKind::custom:
      break;
  }
  return Json::object();
}

/// What an editor fills in. Lists and tables are too long for that.
void add_default(Json& schema, const ParamInfo& info) {
  const std::string& text = info.default_text;
  if (info.required || text.empty() || text == "null")
    return;
  const bool plain = info.kind == ParamKind::number && info.unit.dimension == Dimension::none;
  if (plain || info.kind == ParamKind::integer || info.kind == ParamKind::boolean)
    schema["default"] = Json::parse(text);
  else if (info.kind == ParamKind::number || info.kind == ParamKind::choice)
    schema["default"] = text;
}

}  // namespace

Json closed_map(Json properties, const std::vector<std::string_view>& required) {
  Json map{{"type", "object"}, {"properties", std::move(properties)}};
  if (!required.empty())
    map["required"] = required;
  map["additionalProperties"] = false;
  return map;
}

Json reference_to(const std::string& definition) {
  return {{"$ref", "#/definitions/" + definition}};
}

Json parameter_schema(const ParamInfo& info, Required required) {
  Json schema = shape(info, required);
  if (info.optional)
    schema = {{"anyOf", {schema, {{"type", "null"}}}}};
  else if (schema.contains("$ref"))
    schema = {{"allOf", Json::array({schema})}};  // beside $ref draft-07 ignores everything
  schema["description"] = description(info);
  add_default(schema, info);
  return schema;
}

Json map_schema(std::span<const ParamInfo> parameters, Required required) {
  Json properties = Json::object();
  std::vector<std::string_view> needed;
  bool north = false, latitude = false;
  for (const ParamInfo& info : parameters) {
    properties[info.name] = parameter_schema(info, required);
    if (info.required && required == Required::checked)
      needed.push_back(info.name);
    north = north || info.name == "north";
    latitude = latitude || info.name == "latitude";
  }
  Json schema = closed_map(std::move(properties), needed);
  if (north && latitude)  // a place: half of one is none, and nor are two
    schema["dependencies"] = {{"north", Json::array({"east"})},
                              {"east", Json::array({"north"})},
                              {"latitude", Json::array({"longitude"})},
                              {"longitude",
                               {{"required", Json::array({"latitude"})},
                                {"not", {{"required", Json::array({"north"})}}}}}};
  return schema;
}

Json dimension_definitions() {
  Json result = Json::object();
  for (const UnitInfo& unit : units()) {
    const std::string key = dimension_key(unit.dimension);
    if (result.contains(key))
      continue;
    const std::string pattern =
        "^[ \\t]*[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?[ \\t]*(" +
        units_pattern(unit.dimension) + ")[ \\t]*$";
    Json quantity{{"type", "string"}, {"pattern", pattern}};
    // without a unit 0 is 0, but not for a temperature
    result[key] = unit.dimension == Dimension::temperature
                      ? quantity
                      : Json{{"anyOf", {quantity, {{"const", 0}}}}};
    result[key]["description"] = std::string(dimension_noun(unit.dimension)) + ", such as '" +
                                 std::string(dimension_example(unit.dimension)) + "'";
  }
  return result;
}

}  // namespace eyrie::record
