// SPDX-License-Identifier: MIT
#pragma once
/// \file  What is wrong with an argument of the command line, or an empty text.
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace eyrie::app {

/// Of a text, which it writes without leading zeros: they are read as octal later.
[[nodiscard]] std::function<std::string(std::string&)> whole_number(
    std::uint64_t least = 0, std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
/// Of this machine.
[[nodiscard]] std::string address(const std::string& text);
/// Where to listen.
[[nodiscard]] std::string endpoint(const std::string& text);
/// Where datagrams go: likewise, by IPv4.
[[nodiscard]] std::string datagram_endpoint(const std::string& text);
/// From where they go.
[[nodiscard]] std::string own_ipv4(const std::string& text);
/// "1.1.1": exercise, site, application.
[[nodiscard]] std::string station(const std::string& text);
/// Of real time: a number, or max, of which it makes 0.
[[nodiscard]] std::string rate(std::string& text);
[[nodiscard]] std::function<std::string(const std::string&)> one_of(
    std::vector<std::string_view> names);
/// What is given as an empty text: mostly an empty variable of a shell. "" if nothing is.
[[nodiscard]] std::string empty_text(std::span<char*> words);

}  // namespace eyrie::app
