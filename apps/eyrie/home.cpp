// SPDX-License-Identifier: MIT
#include "home.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "command.hpp"
#include "core/text.hpp"
#include "disk/file_system.hpp"
#include "home_page.hpp"
#include "locate.hpp"
#include "record/json_text.hpp"
#include "record/run_file.hpp"
#include "say.hpp"
#include "scenario/path.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

using Object = nlohmann::ordered_json;
using record::json_text;

constexpr std::size_t kMostRuns = 20;
constexpr const char* kJson = "application/json; charset=utf-8";
constexpr const char* kHtml = "text/html; charset=utf-8";

/// With who begins where, for a small picture: east, north (m) and side of each player.
Object about(const std::string& name) {
  Object one{{"name", name}, {"help", ""}, {"players", Object::array()}};
  try {
    const auto scenario = load_scenario(name, {}, {}, {});
    one["help"] = scenario->spec.help_text;
    one["seed"] = std::to_string(scenario->spec.seed);
    scenario->each_player(*scenario->start, [&](const auto& fleet, PlayerId id, std::size_t row) {
      const Vec3 at = fleet.motion(*scenario->start, row).position;
      const auto side = scenario->roster.find(id)->side;
      one["players"].push_back(
          {std::nearbyint(at.y), std::nearbyint(at.x), std::string(scenario::side_name(side))});
    });
  } catch (const std::exception& error) {
    one["help"] = words_for(error);
  }
  return one;
}

/// A folder of runs/ that a page can name: text, nothing hidden and nothing outside.
bool is_nameable(const std::string& name) {
  return !name.empty() && !name.starts_with('.') && name.find('/') == name.npos &&
         printable(name) == name;
}

/// "a%20b" is "a b".
std::string unescaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned value = 0;
    const char* digits = text.data() + i + 1;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2)
      i += 2;
    else
      value = static_cast<unsigned char>(text[i]);
    out += static_cast<char>(value);
  }
  return out;
}

/// Those in runs/, the last ones first.
std::vector<std::string> run_names() {
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  std::error_code failed;
  for (fs::directory_iterator at("runs", failed); at != end(at); at.increment(failed)) {
    const std::string name = at->path().filename().string();
    const auto written = fs::last_write_time(at->path() / record::kRunFileName, failed);
    if (!failed && is_nameable(name) && !at->is_symlink(failed))
      found.emplace_back(written, name);
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<std::string> names;
  for (auto& [written, name] : found)
    names.push_back(std::move(name));
  return names;
}

Object runs() {
  Object all = Object::array();
  for (const std::string& name : run_names()) {
    if (all.size() == kMostRuns)
      break;
    const record::Decoded read = record::read_run_file("runs/" + name + '/' + record::kRunFileName);
    Object one{{"name", name}, {"problem", read.error}};
    if (read.error.empty())
      one = {{"name", name},
             {"scenario", fs::path(read.run.scenario).stem().string()},
             {"seed", std::to_string(read.run.seed)},
             {"sets", read.run.sets},
             {"outcome", read.run.outcome}};
    all.push_back(std::move(one));
  }
  return all;
}

/// "/debrief?run=sweep-1&run=merge-4": the page of one run or two of runs/.
std::optional<net::WebPage> debrief_at(std::string_view target) {
  constexpr std::string_view kBegin = "/debrief?";
  if (!target.starts_with(kBegin))
    return {};
  std::vector<std::string> asked;
  for (std::string_view rest = target.substr(kBegin.size()); !rest.empty();) {
    const std::string word(rest.substr(0, rest.find('&')));
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
    if (!word.starts_with("run=") || asked.size() == 2)
      return {};
    const std::string name = unescaped(std::string_view(word).substr(4));
    if (!is_nameable(name))
      return {};
    asked.push_back("runs/" + name);
  }
  if (asked.empty())
    return {};
  try {
    return net::WebPage{kHtml, debrief_text(open_runs(asked, {}), false)};
  } catch (const std::exception& error) {
    return net::WebPage{"text/plain; charset=utf-8", words_for(error), 404};
  }
}

}  // namespace

void Home::furnish(net::WebOptions& site, std::string_view problem) {
  static_cast<void>(wishes_.take());  // of who was here before the flight that is over
  if (names_.empty()) {
    names_ = names_in("scenarios");
    Object all = Object::array();
    for (const std::string& name : names_)
      all.push_back(about(name));
    scenarios_ = json_text(all);
  }
  std::string page(kHomePage);
  constexpr std::string_view kMark = "@PROBLEM@";
  page.replace(page.find(kMark), kMark.size(), xml_text(problem));
  site.pages["/"] = {kHtml, std::move(page)};
  site.pages["/api/scenarios"] = {kJson, scenarios_};
  site.pages["/api/schema"] = {
      kJson,
      disk::read_file((fs::path(home()) / "data/eyrie.schema.json").string(), 16 << 20).bytes};
  site.made = [](std::string_view target) -> std::optional<net::WebPage> {
    if (target == "/api/runs")
      return net::WebPage{kJson, json_text(runs())};
    return debrief_at(target);
  };
  site.channel.said = [this](net::ViewerId who, std::string_view text) { return hear(who, text); };
}

/// {"do": "fly", "scenario": "sweep", "seed": "7", "sets": ["until=10 min"]}
std::string Home::hear(net::ViewerId who, std::string_view text) {
  constexpr const char* kWrong = "no wish to fly a scenario";
  const Object json = Object::parse(text, nullptr, false);
  if (!json.is_object() || json.value("do", Object()) != "fly")
    return kWrong;
  const Object scenario = json.value("scenario", Object()), seed = json.value("seed", Object("")),
               sets = json.value("sets", Object::array());
  if (!scenario.is_string() || !seed.is_string() || !sets.is_array())
    return kWrong;
  Wish wish{.who = who, .scenario = scenario, .seed = seed, .sets = {}};
  for (const Object& set : sets) {
    if (!set.is_string())
      return kWrong;
    wish.sets.push_back(set);
  }
  return wishes_.put(std::move(wish)) ? "" : "too many wishes";
}

std::string Home::problem(const Wish& wish, Choice& chosen) const {
  if (std::ranges::find(names_, wish.scenario) == names_.end())
    return "there is no scenario " + quote(wish.scenario);
  const auto seed = number_from<std::uint64_t>(wish.seed);
  if (!seed && !wish.seed.empty())
    return "seed: expected digits of a number below 2^64, got " + quote(wish.seed);
  constexpr const char* kNoPlugins = "it uses plug-ins, which browsers cannot";
  for (const std::string& set : wish.sets)  // before they are looked for, which tells of the disk
    if (scenario::covers("plugins", set))
      return kNoPlugins;
  try {
    std::vector<std::string> sets = wish.sets;
    sets.insert(sets.end(), ours_.begin(), ours_.end());
    chosen = {load_scenario(wish.scenario, sets, {}, {}), seed};
  } catch (const std::exception& error) {
    return words_for(error);
  }
  if (!chosen.scenario->plugins.empty())
    return kNoPlugins;
  if (chosen.scenario->remote && !linked_)
    return "some of its players are another program's, of whom 'eyrie serve --dis' hears";
  return "";
}

std::optional<Choice> Home::ask(net::WebHost& host) {
  while (!interrupted()) {
    std::optional<Choice> taken;
    for (const Wish& wish : wishes_.take()) {
      Choice chosen;
      const std::string words = taken ? "somebody else was first" : problem(wish, chosen);
      host.send(wish.who, json_text(words.empty() ? Object{{"flies", wish.scenario}}
                                                  : Object{{"refused", words}}));
      if (words.empty())
        taken = std::move(chosen);
    }
    if (taken) {
      std::this_thread::sleep_for(std::chrono::milliseconds(200));  // they hear of it
      return taken;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return {};
}

}  // namespace eyrie::app
