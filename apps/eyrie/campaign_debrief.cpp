// SPDX-License-Identifier: MIT
#include "campaign_debrief.hpp"

#include <nlohmann/json.hpp>

#include "campaign/again.hpp"
#include "campaign/store.hpp"
#include "command.hpp"
#include "core/text.hpp"
#include "locate.hpp"
#include "page/page.hpp"

namespace eyrie::app {

CampaignDebrief campaign_debrief(const std::string& folder,
                                 const std::vector<std::string>& plugins) {
  const auto none = [](std::string problem) { return CampaignDebrief{{}, std::move(problem)}; };
  const disk::FileRead shell = read_page(viewer_file(), "the debrief page was not built");
  if (!shell.problem.empty())
    return none(shell.problem);
  if (!page::has_engine(shell.bytes))
    return none("the debrief page was built without its engine");
  try {
    campaign::Database database = campaign::open_results(folder);
    campaign::Again again(database, plugins, 1);
    const auto sets = again.sets();
    if (sets.empty() || !again.scenario(0)->plugins.empty())
      return none("it needs plug-ins, which a page cannot open");
    nlohmann::ordered_json texts{{"scenario", again.file()}, {"sets", sets}};
    for (const auto& [name, text] : again.files())
      if (name != campaign::kCampaignText && name != campaign::kProgramText)
        texts["files"][name] = text;
    const std::array parts{
        page::part_of("campaign",
                      texts.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)),
        page::part_of("zones", launch_zones())};
    return {base64(page::deflated(page::page_with(shell.bytes, parts))), {}};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return none(words_for(e));
  }
}

}  // namespace eyrie::app
