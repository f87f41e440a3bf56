// SPDX-License-Identifier: MIT
/// \file  What is in the debrief page is what the explainer says.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "core/text.hpp"
#include "debrief/decision.hpp"
#include "model/remote.hpp"
#include "page/decisions.hpp"
#include "page/page.hpp"
#include "support/packed.hpp"
#include "support/recorded.hpp"

namespace eyrie::page {
namespace {

using nlohmann::json;

/// The page's data, read again.
class Reader {
 public:
  explicit Reader(const std::string& packed) : all_(test::unpacked(packed)) {
    std::size_t length = 0;
    for (int i = 3; i >= 0; --i)
      length = length << 8 | static_cast<unsigned char>(all_[static_cast<std::size_t>(i)]);
    document = json::parse(all_.substr(4, length));
    columns_ = 4 + length;
  }
  [[nodiscard]] std::vector<double> column(const json& place) const {
    std::vector<double> out;
    for (const std::int64_t quanta :
         test::read_column(std::string_view(all_).substr(columns_ + place[0].get<std::size_t>()),
                           place[1], place[3]))
      out.push_back(static_cast<double>(quanta) * place[2].get<double>());
    return out;
  }
  json document;

 private:
  std::string all_;
  std::size_t columns_ = 0;
};

struct Case {
  const char* scenario;
  const char* player;
  double until;
};

class PageData : public testing::TestWithParam<Case> {};

TEST_P(PageData, SaysOfEveryDecisionWhatTheExplainerSays) {
  const debrief::Recorded recorded = test::recorded_flight(GetParam().scenario, GetParam().until);
  const Reader page(page_data(recorded));
  const auto who = *recorded.scenario->roster.find(GetParam().player);
  const json& player = page.document["players"][who.value - 1];
  EXPECT_EQ(player["name"], GetParam().player);
  const auto steps = page.column(player["decisions"]["step"]);
  const auto shapes = page.column(player["decisions"]["shape"]);
  const auto why_not = page.column(player["decisions"]["why_not"]);
  const json& texts = page.document["texts"];
  std::optional<debrief::Decision> before;
  struct Values {
    std::vector<double> all;
    std::size_t next = 0;
  };
  std::map<std::pair<int, int>, Values> values;
  for (const json& one : player["decisions"]["values"])
    values[{one[0], one[1]}].all = page.column(one[2]);
  const json& fields = page.document["platforms"][player["kind"].get<std::string>()]["action"];

  debrief::Reflight flight(recorded);
  std::size_t at = 0, compared = 0, held = 0, led = 0;
  while (flight.step()) {
    const auto decision =
        debrief::explain(*recorded.scenario, flight.before(), flight.after(), who, flight.orders());
    if (!decision)
      continue;
    ASSERT_LT(at, steps.size());
    ASSERT_EQ(static_cast<std::uint64_t>(steps[at]), decision->step);
    const json& shape = page.document["shapes"][static_cast<std::size_t>(shapes[at])];
    const json& tree = page.document["trees"][shape["tree"].get<std::size_t>()];
    const double why = why_not[at];
    ++at;
    const bool leads_anew =
        before && before->tree == decision->tree && before->leader != decision->leader;
    ASSERT_EQ(why >= 0, leads_anew);
    if (leads_anew) {
      ASSERT_EQ(texts[static_cast<std::size_t>(why)], debrief::why_not(*decision, before->leader));
      ++led;
    }
    before = decision;
    ASSERT_EQ(tree["name"], decision->tree);
    ASSERT_EQ(shape["leader"].get<int>(),
              decision->leader == ubf::kNone ? -1 : static_cast<int>(decision->leader));
    struct Supplier {
      std::size_t node;
      bool held;
    };
    std::map<std::pair<std::size_t, int>, Supplier> supplier;
    for (const json& row : shape["supplier"])
      for (std::size_t f = 0; f + 1 < row.size(); ++f)
        if (const int from = row[f + 1]; from != -1)
          supplier[{row[0].get<std::size_t>(), static_cast<int>(f)}] = {
              static_cast<std::size_t>(from < 0 ? -2 - from : from), from < 0};
    for (std::size_t i = 0; i < decision->nodes.size(); ++i) {
      const debrief::Answer& answer = decision->nodes[i];
      ASSERT_EQ(tree["nodes"][i]["path"], answer.path);
      ASSERT_EQ(shape["vote"][i].get<float>(), answer.vote);
      const char letter = shape["status"].get<std::string>()[i];
      ASSERT_EQ(letter, !answer.asked                           ? '-'
                        : answer.status == ubf::Status::failure ? 'F'
                        : answer.status == ubf::Status::success ? 'S'
                                                                : 'R');
    }
    std::map<std::pair<std::size_t, int>, double> said;
    for (auto& [key, column] : values) {  // every value in its column, in the same order
      const auto node = static_cast<std::size_t>(key.first);
      const auto own = supplier.find({node, key.second});
      if (own == supplier.end() || (own->second.held ? node != 0 : own->second.node != node))
        continue;
      const std::string& name = fields[static_cast<std::size_t>(key.second)]["name"];
      const double value = column.all.at(column.next++);
      said[{node, key.second}] = value;
      for (const debrief::Value& flown : decision->nodes[node].action)
        if (flown.name == name && flown.number) {
          ASSERT_NEAR(value, *flown.number, 1.501e-3) << name;  // or moved on from an equal
          ++compared;
        }
    }
    ASSERT_EQ(shape["won"].size(), decision->action.size());
    for (std::size_t i = 0; i < decision->action.size(); ++i) {
      const debrief::Won& won = decision->action[i];
      json rivals = json::array();
      for (const debrief::Rival& rival : won.rivals)
        rivals.push_back({rival.node, rival.vote});
      const json& told = shape["won"][i];
      ASSERT_EQ(fields[told[0].get<std::size_t>()]["name"], won.value.name);
      ASSERT_EQ(told[1], won.winner);
      ASSERT_EQ(texts[told[2].get<std::size_t>()], debrief::reason(won));
      ASSERT_EQ(told[3], rivals);
      const auto field = std::find_if(fields.begin(), fields.end(),
                                      [&](const json& f) { return f["name"] == won.value.name; });
      ASSERT_NE(field, fields.end());
      const auto index = static_cast<int>(field - fields.begin());
      ASSERT_EQ((supplier.at({0, index}).node), won.winner);
      ASSERT_EQ((supplier.at({0, index}).held), won.held);
      held += won.held;
      const double value = said.at({won.held ? 0 : won.winner, index});
      if (won.value.number) {
        ASSERT_NEAR(value, *won.value.number, 1.501e-3) << won.value.name;
      }
    }
  }
  EXPECT_EQ(at, steps.size());
  // looking changed nothing: the same world as flown without a trace
  EXPECT_EQ(flight.after().hash(), recorded.run.trail.last_hash);
  EXPECT_GT(compared, 1000U);
  EXPECT_EQ(led > 3, std::string_view(GetParam().player) != "supply1");  // it follows its route
  EXPECT_EQ(held > 100, std::string_view(GetParam().scenario) == "layers");
}

TEST(PageShapes, HaveTheVotesThatWereGivenInThePlaceOfTheirOwn) {
  ubf::Trace<pilot::Action> trace(3);
  ubf::Proposal<pilot::Action> said;
  said.action.heading = 1;
  said.vote = 40;
  TextBook texts;
  ShapeBook shapes(texts);
  const debrief::Answer leaf{.depth = 1, .parent = 0};
  const std::vector<debrief::Answer> nodes{{.is_leaf = false}, leaf, leaf};
  const auto number = [&](float given) {
    trace.begin(3);
    for (const ubf::NodeIndex node : std::array<ubf::NodeIndex, 3>{1, 2, 0}) {
      if (node == 0)
        trace.took(0, 1);
      trace.record(node, ubf::Status::running, said);
      if (node == 2)
        trace.voted(node, given);
    }
    return shapes.number(0, nodes, 1, trace);
  };
  EXPECT_EQ(number(1.5F), 0);
  EXPECT_EQ(number(2.5F), 1);
  EXPECT_EQ(number(1.5F), 0);
  EXPECT_EQ(shapes.json().at(0).at("vote"), json::parse("[40, 40, 40]"));
  EXPECT_EQ(texts.texts().at(shapes.json().at(0).at("won")[0][2]), "voted 40 against 1.5");
}

/// A page that grows gets everything once.
TEST(PageInParts, AreWhatItGivesAtOnce) {
  const debrief::Recorded recorded = test::recorded_flight("sweep", 660);
  const auto at_once = make_packer(*recorded.scenario, 660),
             in_parts = make_packer(*recorded.scenario, 660);
  debrief::Reflight flight(recorded);
  flight.attach(*at_once);
  flight.attach(*in_parts);
  std::map<std::string, std::vector<double>> grown;
  json texts = json::array(), story = json::array(), shapes = json::array();
  const auto put = [&](const Reader& part, const std::string& name, const json& place) {
    const std::vector<double> more = part.column(place);
    grown[name].insert(grown[name].end(), more.begin(), more.end());
  };
  const auto each_column = [](const json& document, const auto& use) {
    for (std::size_t i = 0; i < document["players"].size(); ++i) {
      const json& player = document["players"][i];
      for (const char* name : {"t", "north", "roll"})
        use(fmt::format("{} {}", i, name), player["motion"][name]);
      use(fmt::format("{} fuel", i), player["gauges"]["fuel"]);
      if (player["decisions"].is_null() || player["sights"].is_null())
        continue;  // of a part
      use(fmt::format("{} shape", i), player["decisions"]["shape"]);
      for (const json& one : player["decisions"]["values"])
        use(fmt::format("{} {} {}", i, one[0].dump(), one[1].dump()), one[2]);
      for (const char* name : {"count", "east"})
        use(fmt::format("{} tracks {}", i, name), player["sights"]["tracks"][name]);
      use(fmt::format("{} state", i), player["sights"]["state"][3]);
    }
    for (const json& missile : document["missiles"])
      use(fmt::format("missile {}", missile["id"].dump()), missile["motion"]["east"]);
  };
  const auto take = [&](std::uint64_t step) {
    const Reader part(packed(in_parts->take({.steps = step})));
    each_column(part.document,
                [&](const std::string& name, const json& place) { put(part, name, place); });
    for (const auto& [all, name] :
         {std::pair{&texts, "texts"}, {&story, "story"}, {&shapes, "shapes"}})
      all->insert(all->end(), part.document[name].begin(), part.document[name].end());
    EXPECT_EQ(part.document.contains("trees"), step == 7);
    EXPECT_EQ(part.document["now"]["players"].size(), recorded.scenario->roster.players.size());
  };
  while (flight.step()) {
    for (const auto& packer : {&at_once, &in_parts})
      (*packer)->look(flight.before(), flight.after(), flight.orders());
    if (flight.after().step() % 777 == 7)
      take(flight.after().step());
  }
  for (const auto& packer : {&at_once, &in_parts})
    (*packer)->finish(flight.after());
  take(flight.after().step());
  const Reader whole(packed(at_once->packed({})));
  std::size_t columns = 0;
  each_column(whole.document, [&](const std::string& name, const json& place) {
    EXPECT_EQ(grown[name], whole.column(place)) << name;
    ++columns;
  });
  EXPECT_EQ(columns, grown.size());
  EXPECT_FALSE(whole.document["missiles"].empty());
  EXPECT_EQ(texts, whole.document["texts"]);
  EXPECT_EQ(story, whole.document["story"]);
  EXPECT_EQ(shapes, whole.document["shapes"]);
}

INSTANTIATE_TEST_SUITE_P(Flown, PageData,
                         testing::Values(Case{"sweep", "eagle1", 660}, Case{"sweep", "bogey1", 660},
                                         Case{"convoy", "supply1", 200},
                                         Case{"layers", "viper1", 200}),
                         [](const auto& flown) { return std::string(flown.param.player); });

TEST(PageData, NamesTheTracksOfDecisionsAsTheyAreThen) {
  const debrief::Recorded recorded = test::recorded_flight("commitment", 60);
  const Reader page(page_data(recorded));
  const auto who = *recorded.scenario->roster.find("bogey1");
  const json& players = page.document["players"];
  const json& sights = players[who.value - 1]["sights"];
  const auto times = page.column(sights["t"]), counts = page.column(sights["tracks"]["count"]),
             ids = page.column(sights["tracks"]["id"]),
             truths = page.column(sights["tracks"]["truth"]);
  const std::regex is_named("#(\\d+) \\((\\w+)\\)");
  std::set<std::string> named;
  debrief::Reflight flight(recorded);
  std::size_t last = 0, first_track = 0;  // the last look, and where its tracks begin
  while (flight.step()) {
    const auto decision =
        debrief::explain(*recorded.scenario, flight.before(), flight.after(), who, flight.orders());
    for (; decision && last + 1 < times.size() && times[last + 1] < decision->time + 1e-3; ++last)
      first_track += static_cast<std::size_t>(counts[last]);
    const auto action = decision ? decision->action : std::vector<debrief::Won>{};
    for (const debrief::Won& won : action) {
      std::smatch words;
      if (!std::regex_search(won.value.text, words, is_named))
        continue;
      std::size_t track = first_track;
      while (ids.at(track) != std::stod(words[1]))
        ++track;
      ASSERT_LT(track, first_track + static_cast<std::size_t>(counts[last])) << decision->time;
      ASSERT_EQ(players[static_cast<std::size_t>(truths[track])]["name"], words[2].str())
          << decision->time;
      named.insert(words[2]);
    }
  }
  EXPECT_EQ(named.size(), 2U) << "the track becomes another one's";
}

TEST(PageOfASequencer, SaysFromWhichTreeToWhichEachConditionLeads) {
  const debrief::Recorded recorded = test::recorded_flight("sweep_phases", 1);
  const json trees = Reader(page_data(recorded)).document["trees"];
  const auto sweep = std::find_if(trees.begin(), trees.end(),
                                  [](const json& tree) { return tree["name"] == "sweep"; });
  ASSERT_NE(sweep, trees.end());
  const json& rules = (*sweep)["nodes"][0]["rules"];
  ASSERT_EQ(rules.size(), 10U);
  EXPECT_EQ(rules[0], json::parse("[-1, 3]")) << "from any tree to egress";
  EXPECT_EQ(rules[6], json::parse("[1, 2]")) << "from bvr to wvr";
  EXPECT_EQ(rules[9], json::parse("[2, 1]")) << "and back";
  EXPECT_FALSE((*sweep)["nodes"][1].contains("rules")) << "an arbiter has none";
}

/// A run with ten times as much time as a page holds: everything is kept ten times less often, and
/// the page says so.
TEST(PageOfALongRun, IsAsLargeAsThatOfAShortOne) {
  const debrief::Recorded recorded = test::recorded_flight("sweep", 100);
  const auto players = recorded.scenario->roster.players.size();
  const std::string whole = page_data(recorded);
  const std::string thinned = page_data(recorded, {}, 10 * static_cast<double>(players));
  EXPECT_LT(thinned.size() * 5, whole.size() * 2) << "the trees are as large";
  const Reader page(thinned), all(whole);
  EXPECT_EQ(page.document["about"]["thinned"], true);
  EXPECT_EQ(page.document["about"]["decision_period"], 10);
  EXPECT_EQ(all.document["about"]["thinned"], false);
  for (std::size_t i = 0; i < players; ++i) {
    const json& player = page.document["players"][i];
    const auto steps = page.column(player["decisions"]["step"]);
    EXPECT_GE(steps.size(), 10U);
    for (std::size_t k = 1; k < steps.size(); ++k)
      EXPECT_GE(steps[k] - steps[k - 1], 50) << "one second, a tenth of ten";
    EXPECT_LE(page.column(player["motion"]["t"]).size(), 12U);
    EXPECT_GT(all.column(all.document["players"][i]["decisions"]["step"]).size(), 900U);
  }
}

TEST(Page, TakesRunsWhereTheViewerHasAPlaceForThem) {
  const std::vector<Part> runs{{"run", "QQ=="}, {"run-file", "Qg=="}};
  EXPECT_EQ(page_with("<p><!--%PARTS%--></p>", runs),
            "<p><script type=\"application/x-eyrie-run\">QQ==</script>\n"
            "<script type=\"application/x-eyrie-run-file\">Qg==</script>\n</p>");
  EXPECT_EQ(page_with("<p></p>", runs), "");
}

TEST(Page, CarriesARunFileThatFliesAsTheRunDid) {
  const debrief::Recorded recorded = test::recorded_flight("sweep", 60);
  const Part light = run_file_part(recorded.run);
  EXPECT_LT(light.data.size(), 200'000u);
  EXPECT_FALSE(has_engine("<p></p>"));
}

TEST(PageData, GivesUpWhenItsProgressSaysSo) {
  const debrief::Recorded recorded = test::recorded_flight("sweep", 60);
  EXPECT_EQ(page_data(recorded, [](double) { return false; }), "");
}

TEST(PageOfAnExercise, SaysWhoIsNotHeardOfAnyMoreAndWhoNeverWas) {
  const auto scenario = test::load_scenario("sweep_even", {"ours=[blue]"});
  const PlayerId shooter = *scenario->roster.find("bogey1"), missile = model::remote_missile(1);
  const auto order = [](std::uint64_t step, PlayerId who, model::RemoteOrder kind,
                        const auto& what) {
    return sim::order_for(step, who, sim::OrderKind(kind), what);
  };
  using enum model::RemoteOrder;
  const debrief::Recorded recorded = test::recorded_flight(
      scenario, "sweep_even", 10, {},
      {order(50, shooter, place, model::RemotePlace{.position = {0, 30e3, -6e3}}),
       order(100, missile, launch,
             model::RemoteLaunch{.shooter = shooter,
                                 .target = *scenario->roster.find("eagle1"),
                                 .range = 20e3F,
                                 .side = model::Side::red}),
       order(100, missile, place, model::RemotePlace{.position = {0, 29e3, -6e3}}),
       order(250, shooter, leave, model::RemoteLeave{})});
  const Reader page(page_data(recorded));
  const json& players = page.document["players"];
  const json& heard = players[shooter.value - 1];
  EXPECT_EQ(heard["end"], "unheard");
  EXPECT_TRUE(heard["remote"]);
  EXPECT_NEAR(heard["born"], 1, 0.05);
  EXPECT_NEAR(heard["gone"], 5, 0.05);
  EXPECT_EQ(page.column(heard["gauges"]["fuel"]).front(), double{Column::kNothing})
      << "nobody tells it";
  const json& never = players[scenario->roster.find("bogey2")->value - 1];
  EXPECT_EQ(never["end"], "");
  EXPECT_GT(never["born"], 1e6);
  const json& ours = players[scenario->roster.find("eagle1")->value - 1];
  EXPECT_FALSE(ours["remote"]);
  EXPECT_NEAR(ours["gone"], 10, 0.05);
  std::vector<double> decided;
  for (const json& line : page.document["story"])
    if (line["kind"] == "launch")
      decided.push_back(line["decided"]);
  ASSERT_EQ(decided.size(), 1u) << page.document["story"];
  EXPECT_NEAR(decided[0], 2, 0.1) << "when that was decided is not known";
}

}  // namespace
}  // namespace eyrie::page
