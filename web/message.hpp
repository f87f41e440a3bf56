// SPDX-License-Identifier: MIT
#pragma once
/// \file  What the module is asked and what it answers: structs whose members are listed once, from
/// which JSON, its reader and the TypeScript declaration come.
#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace eyrie::web {

using Json = nlohmann::ordered_json;

template <class Owner, class T>
struct Member {
  std::string_view name;
  T Owner::*at;
  std::string_view help;
};
template <class Owner, class T>
Member(std::string_view, T Owner::*, std::string_view) -> Member<Owner, T>;

/// What a message is called in TypeScript, what it says, and its members.
template <class... Members>
struct Description {
  std::string_view name, help;
  std::tuple<Members...> members;
  constexpr Description(std::string_view called, std::string_view says, Members... all)
      : name(called), help(says), members(all...) {}
};
/// Of structs that say it themselves; to be specialised for those of others.
template <class T>
inline constexpr auto described = nullptr;
template <class T>
requires requires {
  T::kMessage;
}
inline constexpr auto described<T> = T::kMessage;
template <class T>
concept Described = !std::same_as<std::remove_cvref_t<decltype(described<T>)>, std::nullptr_t>;

/// A request that is not what it should be: the page's mistake.
struct BadRequest : std::runtime_error {
  using std::runtime_error::runtime_error;
};

namespace detail {
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;
template <class T>
inline constexpr bool is_map = false;
template <class T>
inline constexpr bool is_map<std::map<std::string, T>> = true;
}  // namespace detail

/// What is not a finite number is null.
template <class T>
[[nodiscard]] Json to_json(const T& value) {
  if constexpr (Described<T>) {
    Json object = Json::object();
    std::apply(
        [&](const auto&... member) {
          [[maybe_unused]] const auto put = [&](const auto& one) {
            using V = std::remove_cvref_t<decltype(value.*one.at)>;
            if constexpr (detail::is_optional<V>) {
              if (value.*one.at)
                object[std::string(one.name)] = to_json(*(value.*one.at));
            } else {
              object[std::string(one.name)] = to_json(value.*one.at);
            }
          };
          (put(member), ...);
        },
        described<T>.members);
    return object;
  } else if constexpr (detail::is_list<T>) {
    Json list = Json::array();
    for (const auto& one : value)
      list.push_back(to_json<std::remove_cvref_t<decltype(one)>>(one));
    return list;
  } else if constexpr (detail::is_map<T>) {
    Json object = Json::object();
    for (const auto& [key, one] : value)
      object[key] = to_json(one);
    return object;
  } else if constexpr (std::floating_point<T>) {
    return std::isfinite(value) ? Json(value) : Json();
  } else {
    return Json(value);
  }
}

template <class T>
void from_json(const Json& json, T& value, const std::string& path) {
  const auto demand = [&](bool right, const char* what) {
    if (!right)
      throw BadRequest(fmt::format("{}: expected {}", path.empty() ? "request" : path, what));
  };
  if constexpr (Described<T>) {
    demand(json.is_object(), "an object");
    std::set<std::string, std::less<>> known;
    std::apply(
        [&](const auto&... member) {
          [[maybe_unused]] const auto take = [&](const auto& one) {
            known.emplace(one.name);
            using V = std::remove_cvref_t<decltype(value.*one.at)>;
            const auto found = json.find(std::string(one.name));
            const std::string there =
                path.empty() ? std::string(one.name) : fmt::format("{}.{}", path, one.name);
            if constexpr (detail::is_optional<V>) {
              if (found != json.end() && !found->is_null())
                from_json(*found, (value.*one.at).emplace(), there);
            } else if (found != json.end()) {
              from_json(*found, value.*one.at, there);
            } else {
              throw BadRequest(there + " is missing");
            }
          };
          (take(member), ...);
        },
        described<T>.members);
    for (const auto& [key, ignored] : json.items())
      if (!known.contains(key))
        throw BadRequest(fmt::format("there is no {}{}{}", path, path.empty() ? "" : ".", key));
  } else if constexpr (detail::is_list<T>) {
    demand(json.is_array(), "a list");
    value.clear();
    for (const Json& one : json)
      from_json(one, value.emplace_back(), fmt::format("{}[{}]", path, value.size()));
  } else if constexpr (detail::is_map<T>) {
    demand(json.is_object(), "an object");
    for (const auto& [key, one] : json.items())
      from_json(one, value[key], path + "." + key);
  } else if constexpr (std::same_as<T, bool>) {
    demand(json.is_boolean(), "true or false");
    value = json.get<bool>();
  } else if constexpr (std::integral<T>) {
    demand(json.is_number_unsigned() && json.get<std::uint64_t>() < (std::uint64_t{1} << 53),
           "a whole number from 0 to 2^53");
    value = json.get<T>();
  } else if constexpr (std::floating_point<T>) {
    demand(json.is_number(), "a number");
    value = json.get<T>();
  } else {
    demand(json.is_string(), "a text");
    value = json.get<std::string>();
  }
}

}  // namespace eyrie::web
