// SPDX-License-Identifier: MIT
#include "page/page.hpp"

#include "page/packed.hpp"
#include "sim/trail.hpp"

namespace eyrie::page {

PageRun run_for_page(const record::RunFile& run) {
  record::RunFile light = run;
  light.trail = sim::without_digests(run.trail);
  return {.columns = false, .data = base64(deflated(record::encode(light)))};
}

bool has_engine(std::string_view viewer) {
  return viewer.find("<script type=\"application/x-eyrie-engine\">") != std::string_view::npos;
}

std::string page_with(std::string_view viewer, std::span<const PageRun> runs) {
  const std::size_t at = viewer.find(kPlaceOfRuns);
  if (at == std::string_view::npos)
    return {};
  std::string page(viewer.substr(0, at));
  for (const PageRun& run : runs)
    page.append(run.columns ? "<script type=\"application/x-eyrie-run\">"
                            : "<script type=\"application/x-eyrie-run-file\">")
        .append(run.data)
        .append("</script>\n");
  page.append(viewer.substr(at + kPlaceOfRuns.size()));
  return page;
}

}  // namespace eyrie::page
