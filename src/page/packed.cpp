// SPDX-License-Identifier: MIT
#include "page/packed.hpp"

#include <zlib.h>

#include <cstdint>

#include "core/assert.hpp"
#include "page/page_data.hpp"

namespace eyrie::page {

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int result =
      compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()), 9);
  EYRIE_DEMAND(result == Z_OK, "zlib has no memory");
  out.resize(size);
  return out;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    const std::size_t there = bytes.size() - i < 3 ? bytes.size() - i : 3;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (k < there ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out.push_back(k <= there ? kDigits[three >> (18 - 6 * k) & 63] : '=');
  }
  return out;
}

std::string page_data(const debrief::Recorded& recorded, const Progress& progress, double plenty) {
  constexpr std::uint64_t kTell = 512;  // steps
  const auto packer = make_packer(*recorded.scenario, recorded.until(), plenty);
  debrief::Reflight flight(recorded);
  flight.attach(*packer);
  while (flight.step()) {
    packer->look(flight.before(), flight.after(), flight.orders());
    if (progress && flight.after().step() % kTell == 0 && !progress(flight.time()))
      return {};
  }
  packer->finish(flight.after());
  return base64(deflated(packer->packed(facts_of(recorded))));
}

}  // namespace eyrie::page
