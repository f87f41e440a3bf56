// SPDX-License-Identifier: MIT
#include "page/page.hpp"

namespace eyrie::page {

std::string page_with(std::string_view viewer, std::span<const std::string> runs) {
  const std::size_t at = viewer.find(kPlaceOfRuns);
  if (at == std::string_view::npos)
    return {};
  std::string page(viewer.substr(0, at));
  for (const std::string& run : runs)
    page.append("<script type=\"application/x-eyrie-run\">").append(run).append("</script>\n");
  page.append(viewer.substr(at + kPlaceOfRuns.size()));
  return page;
}

}  // namespace eyrie::page
