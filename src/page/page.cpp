// SPDX-License-Identifier: MIT
#include "page/page.hpp"

#include <zlib.h>

#include "core/assert.hpp"
#include "sim/trail.hpp"

namespace eyrie::page {
namespace {

std::string begin_of(std::string_view type) {
  return fmt::format("<script type=\"application/x-eyrie-{}\">", type);
}

}  // namespace

Part run_file_part(const record::RunFile& run) {
  record::RunFile light = run;
  light.trail = sim::without_digests(run.trail);
  return part_of("run-file", record::encode(light));
}

Part part_of(std::string_view type, std::string_view bytes) {
  return {type, packed(bytes)};
}

bool has_engine(std::string_view page) {
  return page.find(begin_of("engine")) != std::string_view::npos;
}

std::string page_with(std::string_view page, std::span<const Part> parts) {
  const std::size_t at = page.find(kPlaceOfParts);
  if (at == std::string_view::npos)
    return {};
  std::string whole(page.substr(0, at));
  for (const Part& part : parts)
    whole.append(begin_of(part.type)).append(part.data).append("</script>\n");
  whole.append(page.substr(at + kPlaceOfParts.size()));
  return whole;
}

std::string live_page(std::string_view page, std::span<const Part> parts) {
  constexpr std::string_view kNothing = "default-src 'none';";
  std::string whole = page_with(page, parts);
  if (const std::size_t at = whole.find(kNothing); at != whole.npos)
    whole.insert(at + kNothing.size(), " connect-src 'self';");
  return whole;
}

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

std::string packed(std::string_view bytes) {
  const std::string stream = deflated(bytes);
  std::string text;
  text.reserve(stream.size() / 4 * 5 + 5);
  for (std::size_t at = 0; at < stream.size(); at += 4) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
      word = word << 8 | (at + k < stream.size() ? static_cast<unsigned char>(stream[at + k]) : 0U);
    std::array<char, 5> digits;
    for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, word /= 85) {
      const char ascii = static_cast<char>('!' + word % 85);
      *digit = ascii == '<' ? 'v' : ascii;
    }
    text.append(digits.data(), std::min<std::size_t>(stream.size() - at + 1, 5));
  }
  return text;
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
  return packed(packer->packed(facts_of(recorded)));
}

}  // namespace eyrie::page
