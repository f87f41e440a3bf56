// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every JSON text that Eyrie writes.
#include <nlohmann/json.hpp>
#include <string>

namespace eyrie::record {

/// One line, in ASCII: what a terminal or another program could take for something else is a \u
/// escape, and bytes that are no UTF-8 become U+FFFD.
template <class Json>
[[nodiscard]] std::string json_text(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}
/// The same, indented, with a line end.
template <class Json>
[[nodiscard]] std::string json_lines(const Json& json) {
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + '\n';
}

/// What json_lines() makes of an array, one by one.
class JsonList {
 public:
  template <class Json>
  [[nodiscard]] std::string next(const Json& json) {
    std::string text = any_ ? ",\n  " : "[\n  ";
    any_ = true;
    const std::string own = json.dump(2, ' ', true, Json::error_handler_t::replace);
    for (std::size_t begin = 0, end = 0; end != own.npos; begin = end + 1) {
      end = own.find('\n', begin);
      text.append(own, begin, end == own.npos ? end : end + 1 - begin);
      text += end == own.npos ? "" : "  ";
    }
    return text;
  }
  [[nodiscard]] std::string end() const { return any_ ? "\n]\n" : "[]\n"; }

 private:
  bool any_ = false;
};

}  // namespace eyrie::record
