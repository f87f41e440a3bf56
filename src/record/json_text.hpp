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

}  // namespace eyrie::record
