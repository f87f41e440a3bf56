// SPDX-License-Identifier: MIT
#include "page/page.hpp"

#include <fmt/format.h>

#include "page/packed.hpp"
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
  return {"run-file", base64(deflated(record::encode(light)))};
}

Part zones_part(std::string_view zones) {
  return {"zones", base64(deflated(zones))};
}

Part texts_part(std::string_view json) {
  return {"texts", base64(deflated(json))};
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

}  // namespace eyrie::page
