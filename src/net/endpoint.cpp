// SPDX-License-Identifier: MIT
#include "net/endpoint.hpp"

#include <fmt/format.h>

#include <boost/asio/ip/address.hpp>

#include "core/text.hpp"

namespace eyrie::net {
namespace {

std::optional<boost::asio::ip::address> address_of(const std::string& text) {
  boost::system::error_code failed;
  const auto address = boost::asio::ip::make_address(text, failed);
  if (failed)
    return {};
  return address;
}

}  // namespace

bool Endpoint::loopback() const {
  const auto known = address_of(address);
  return known && known->is_loopback();
}

std::string Endpoint::text() const {
  const bool six = address.find(':') != std::string::npos;
  return fmt::format("{}{}{}:{}", six ? "[" : "", address, six ? "]" : "", port);
}

std::optional<Endpoint> endpoint_of(std::string_view text, const Endpoint& standard) {
  Endpoint found = standard;
  if (const auto port = number_from<std::uint16_t>(text)) {
    found.port = *port;
    return found;
  }
  // the port is behind the last colon, but for an address with colons that has no brackets
  std::string_view address = text;
  const std::size_t colon = text.rfind(':');
  const bool one = colon != text.npos && text.find(':') == colon;
  if (colon != text.npos && (one || text.substr(0, colon).ends_with(']'))) {
    const auto port = number_from<std::uint16_t>(text.substr(colon + 1));
    if (!port)
      return {};
    found.port = *port;
    address = text.substr(0, colon);
  }
  if (address.starts_with('[') && address.ends_with(']'))
    address = address.substr(1, address.size() - 2);
  found.address = address == "localhost" ? "127.0.0.1" : address;
  if (!address_of(found.address))
    return {};
  return found;
}

}  // namespace eyrie::net
