// SPDX-License-Identifier: MIT
/// \file  Any bytes as what a client of telemetry says first, as its password, and as an address.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "net/endpoint.hpp"
#include "net/telemetry_host.hpp"

namespace {

using namespace eyrie::net;

void demand(bool condition) {
  if (!condition)
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto client = client_greeting(text)) {
    demand(client->name.find('\n') == std::string::npos);
    demand(client->hash.find('\n') == std::string::npos);
    demand(client->name.size() + client->hash.size() < size);
    demand(is_hash_of(client->hash, ""));
  }
  demand(is_hash_of(password_hash(text), text));
  if (const auto found = endpoint_of(text, {})) {
    const auto again = endpoint_of(found->text(), {.address = "0.0.0.0", .port = 1});
    demand(again && again->text() == found->text());
  }
  return 0;
}
