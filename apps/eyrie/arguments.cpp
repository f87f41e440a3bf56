// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/diagnostics.hpp"
#include "core/text.hpp"
#include "dis/incoming.hpp"
#include "live.hpp"
#include "net/endpoint.hpp"

namespace eyrie::app {
namespace {

/// "" if it is right, else that the text is no such thing.
std::string unless(bool right, const std::string& text, std::string_view what) {
  return right ? std::string{} : fmt::format("{} is no {}", quote(text), what);
}

}  // namespace

std::function<std::string(std::string&)> whole_number(std::uint64_t least, std::uint64_t most) {
  return [=](std::string& text) {
    const auto value = number_from<std::uint64_t>(text);
    if (!value || *value < least || *value > most)
      return fmt::format("{} is no whole number from {} to {}", quote(text), least, most);
    text = std::to_string(*value);
    return std::string{};
  };
}

std::string address(const std::string& text) {
  const auto found = net::endpoint_of(text, {});
  return unless(found && found->address == text, text, "address such as 0.0.0.0");
}

std::string endpoint(const std::string& text) {
  return unless(net::endpoint_of(text, {}).has_value(), text,
                "port or address such as 42674, 0.0.0.0 or 192.168.1.5:42674");
}

std::string datagram_endpoint(const std::string& text) {
  const auto at = net::endpoint_of(text, kDisStandard);
  if (at && at->address == "0.0.0.0")
    return fmt::format(
        "{} is where one listens, and nobody is told: name a machine, a network or a "
        "group, such as 127.0.0.1, 192.168.1.255 or 239.1.2.3",
        quote(text));
  return unless(at && at->port != 0 && at->address.find(':') == std::string::npos, text,
                "port or IPv4 address such as 3000, 239.1.2.3 or 192.168.1.255:3000");
}

std::string own_ipv4(const std::string& text) {
  return unless(address(text).empty() && text.find(':') == std::string::npos && text != "0.0.0.0",
                text, "IPv4 address of this machine such as 192.168.1.7");
}

std::string station(const std::string& text) {
  return unless(dis::station_of(text).has_value(), text,
                "exercise (1 to 255), site and application (1 to 65534), such as 1.1.1");
}

std::string rate(std::string& text) {
  constexpr double kSlowest = 0.1, kFastest = 100;
  if (text == "max") {
    text = "0";
    return {};
  }
  const auto value = number_from<double>(text);
  return unless(value && *value >= kSlowest && *value <= kFastest, text,
                fmt::format("rate: {} to {}, or max", kSlowest, kFastest));
}

std::function<std::string(const std::string&)> one_of(std::vector<std::string_view> names) {
  return [=](const std::string& text) {
    const bool known = std::ranges::find(names, text) != names.end();
    return known ? std::string{}
                 : fmt::format("must be one of {}, got {}{}", fmt::join(names, ", "), quote(text),
                               did_you_mean(text, names));
  };
}

std::string empty_text(std::span<char*> words) {
  std::string_view before;
  for (const std::string_view word : words) {
    const bool option = word.starts_with("--") && word != "--";
    if (word.empty() || (option && word.ends_with('=')))
      return option ? fmt::format("{} must not be empty", word.substr(0, word.size() - 1))
             : before.starts_with("--") && before != "--"
                 ? fmt::format("{} must not be empty", before)
                 : "an argument must not be empty";
    before = word;
  }
  return "";
}

}  // namespace eyrie::app
