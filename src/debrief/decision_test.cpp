// SPDX-License-Identifier: MIT
#include "debrief/decision.hpp"

#include <gtest/gtest.h>

namespace eyrie::debrief {
namespace {

using ubf::Status;

Answer answer(std::string label, std::string type, std::uint16_t depth, std::uint16_t parent) {
  return {.label = std::move(label), .type = std::move(type), .depth = depth, .parent = parent};
}

/// A sequencer over two trees: far (pursue, navigate) and near (shoot), and a condition.
Decision in_two_phases(bool near) {
  Decision d;
  d.nodes = {answer("root", "sequencer", 0, ubf::kNone), answer("far", "winner_takes_all", 1, 0),
             answer("pursue", "pursue", 2, 1),           answer("navigate", "navigate", 2, 1),
             answer("near", "winner_takes_all", 1, 0),   answer("shoot", "shoot", 2, 4),
             answer("in_sight", "in_sight", 1, 0)};
  const auto says = [&](std::size_t node, Status status, float vote) {
    d.nodes[node].asked = true;
    d.nodes[node].status = status;
    d.nodes[node].vote = vote;
  };
  says(0, Status::running, near ? 60 : 40);
  says(6, near ? Status::success : Status::failure, 0);
  if (near) {
    says(4, Status::running, 60);
    says(5, Status::running, 60);
  } else {
    says(1, Status::running, 40);
    says(2, Status::running, 40);
    says(3, Status::running, 10);
  }
  d.leader = near ? 5 : 2;
  return d;
}

TEST(Decision, SaysWhyWhoLedBeforeDoesNotLeadNow) {
  Decision d = in_two_phases(false);
  EXPECT_EQ(why_not(d, 3), "navigate voted 10 against 40");
  d.nodes[3].status = Status::failure;
  d.nodes[3].why = "there is no such route";
  EXPECT_EQ(why_not(d, 3), "navigate failed: there is no such route");
  EXPECT_EQ(why_not(in_two_phases(true), 2), "far was left for near: in_sight holds");
}

TEST(Decision, NamesTheConditionsBelowATransitionThatHasNoWordsOfItsOwn) {
  Decision d = in_two_phases(true);
  d.nodes[6] = answer("sequence", "sequence", 1, 0);
  d.nodes.insert(d.nodes.end(),
                 {answer("not low", "inverter", 2, 6), answer("low", "low", 3, 7),
                  answer("delay", "delay", 2, 6), answer("in_sight", "in_sight", 3, 9)});
  for (const std::size_t holds : {6u, 7u, 9u, 10u}) {
    d.nodes[holds].asked = true;
    d.nodes[holds].status = Status::success;
  }
  EXPECT_EQ(why_not(d, 2), "far was left for near: not low holds, in_sight holds");
  d.nodes[6].label = "close enough";
  EXPECT_EQ(why_not(d, 2), "far was left for near: close enough holds");
}

TEST(Decision, SaysWhatHadToHoldForWhoWasNotAsked) {
  Decision d;
  d.nodes = {answer("root", "winner_takes_all", 0, ubf::kNone),
             answer("guard", "guard", 1, 0),
             answer("selector", "selector", 2, 1),
             answer("in_sight", "in_sight", 3, 2),
             answer("near", "hostile_track", 3, 2),
             answer("pursue", "pursue", 2, 1),
             answer("egress", "egress", 1, 0)};
  for (const std::size_t asked : {0u, 1u, 2u, 3u, 4u, 6u}) {
    d.nodes[asked].asked = true;
    d.nodes[asked].status = asked == 0 || asked == 6 ? Status::running : Status::failure;
  }
  d.nodes[3].why = "does not hold";
  d.nodes[4].why = "nobody is known";
  d.leader = 6;
  EXPECT_EQ(why_not(d, 5),
            "pursue was not asked: in_sight does not hold, near failed: nobody is known");
  d.nodes[2].status = Status::running;
  EXPECT_EQ(why_not(d, 5), "pursue was not asked");
}

TEST(Decision, ComparesTheVotesWhereTheBranchesMeet) {
  Decision d = in_two_phases(false);
  d.nodes[0].type = "winner_takes_all";
  d.nodes[4].asked = d.nodes[5].asked = true;
  d.nodes[4].status = d.nodes[5].status = Status::running;
  d.nodes[4].vote = 30;  // scaled down from 60 on the way up
  d.nodes[5].vote = 60;
  EXPECT_EQ(why_not(d, 5), "shoot voted 30 against 40");
  d.nodes[5].action = {{.name = "release"}};
  d.nodes[4].status = Status::failure;
  d.nodes[4].vote = 0;
  EXPECT_EQ(why_not(d, 5), "shoot was kept back by " + d.nodes[4].label);
  d.nodes[4].why = "refused: climb is out of bounds";
  EXPECT_EQ(why_not(d, 5), "shoot was kept back by near: refused: climb is out of bounds");
}

TEST(Decision, TellsWhereAVoteWasLostThatDidNotComeUp) {
  Decision d;
  d.nodes = {answer("root", "winner_takes_all", 0, ubf::kNone),
             answer("fight", "winner_takes_all", 1, 0),
             answer("pure_pursuit", "pure_pursuit", 2, 1), answer("navigate", "navigate", 2, 1),
             answer("extend", "extend", 1, 0)};
  const ubf::NodeIndex suppliers[] = {4, 2, 2, 3, 4};
  const float votes[] = {56, 40, 40, 1, 56};
  for (std::size_t n = 0; n < d.nodes.size(); ++n) {
    d.nodes[n].asked = true;
    d.nodes[n].status = Status::running;
    d.nodes[n].vote = votes[n];
    d.nodes[n].is_leaf = n > 1;
    d.nodes[n].action = {{.name = "heading", .supplier = suppliers[n]}};
  }
  d.leader = 4;
  EXPECT_EQ(why_not(d, 3), "navigate lost in fight, which voted 40 against 56");
  EXPECT_EQ(why_not(d, 2), "pure_pursuit voted 40 against 56");
}

TEST(Decision, ComparesTheVotesThatWereGivenInThePlaceOfTheirOwn) {
  Decision d = in_two_phases(false);
  d.nodes[2].given = 80.0F;
  d.nodes[3].given = 1.5F;
  EXPECT_EQ(why_not(d, 3), "navigate voted 1.5 against 80");
}

TEST(Decision, SaysWhatDecidedWhereVotesDidNot) {
  Decision d = in_two_phases(false);
  d.nodes[1].decided_by = "chance";
  EXPECT_EQ(why_not(d, 3), "navigate voted 10 against 40, and chance decided");
  for (ubf::NodeIndex node = 0; node < 4; ++node) {
    d.nodes[node].action = {{.name = "speed", .supplier = std::max<ubf::NodeIndex>(2, node)}};
    d.nodes[node].is_leaf = node > 1;
  }
  const auto contested = [&] { return team::contest(d.nodes).at(0); };
  EXPECT_EQ(reason(contested()), "40 against 10, and chance decided");
  d.nodes[1].decided_by.clear();
  EXPECT_EQ(reason(contested()), "voted 40 against 10");
  d.nodes[3].vote = 0;
  EXPECT_EQ(reason(contested()), "nobody else's came up to it") << "who does not vote abstains";
}

TEST(Decision, SaysWhyAnEqualVoteDidNotLead) {
  Decision d = in_two_phases(false);
  d.nodes[3].vote = d.nodes[2].vote;
  EXPECT_EQ(why_not(d, 3), "navigate voted 40 against 40, and comes later");
  d.leader = 3;
  EXPECT_EQ(why_not(d, 2), "pursue voted 40 against 40, and votes did not decide");
  d.nodes[2].set_aside = "refused: climb is out of bounds";
  EXPECT_EQ(why_not(d, 2), "pursue voted 40 against 40, refused: climb is out of bounds");
}

TEST(Decision, FindsWhereTwoWaysPart) {
  const Decision d = in_two_phases(false);
  const auto pair = [](ubf::NodeIndex a, ubf::NodeIndex b) { return std::pair(a, b); };
  EXPECT_EQ(parting(d.nodes, 2, 3), pair(2, 3)) << "siblings";
  EXPECT_EQ(parting(d.nodes, 2, 5), pair(1, 4));
  EXPECT_EQ(parting(d.nodes, 5, 6), pair(4, 6));
  EXPECT_EQ(parting(d.nodes, 1, 3), pair(1, 3)) << "one above the other";
}

TEST(Decision, SaysWhatANodeAnswered) {
  Answer node = answer("pursue", "pursue", 1, 0);
  EXPECT_EQ(words(node), "not asked");
  node.asked = true;
  EXPECT_EQ(words(node), "failed");
  node.why = "no target";
  EXPECT_EQ(words(node), "failed: no target");
  node.status = Status::running;
  node.vote = 40.5F;
  node.why.clear();
  EXPECT_EQ(words(node), "running, votes 40.5");
  node.why = "range 0.81";
  EXPECT_EQ(words(node), "running, votes 40.5 (range 0.81)");
}

TEST(Decision, SaysHowAFieldWasWon) {
  Won won{.value = {.name = "heading"}, .winner = 2};
  EXPECT_EQ(reason(won), "nobody else asked for it");
  won.rivals = {{.node = 3, .against = 50, .vote = 45.7F}};
  EXPECT_EQ(reason(won), "voted 50 against 45.7");
  won.rivals = {{.node = 3, .against = 50, .vote = 50}};
  EXPECT_EQ(reason(won), "voted 50 as the other did, and comes first");
  won.rivals = {{.node = 3, .against = 10, .vote = 50}};
  EXPECT_EQ(reason(won), "10 against 50, and votes did not decide");
  won.rivals = {{.node = 1, .against = 50, .vote = 50}};
  EXPECT_EQ(reason(won), "50 against 50, and votes did not decide")
      << "it stands before the winner";
  won.rivals[0].set_aside = "refused: climb is out of bounds";
  EXPECT_EQ(reason(won), "50 against 50, refused: climb is out of bounds");
  won.rivals[0].set_aside.clear();
  won.rivals[0].came_up = false;
  EXPECT_EQ(reason(won), "nobody else's came up to it");
  won.rivals[0].blended = true;
  EXPECT_EQ(reason(won), "blended of 1");
  won.held = true;
  EXPECT_EQ(reason(won), "held from an earlier decision");
}

TEST(Decision, TellsWhatIsHeldFromWhatIsProposedNow) {
  Decision d;
  d.nodes = {answer("root", "per_field", 0, ubf::kNone), answer("steady", "suppress", 1, 0),
             answer("climb", "climb", 2, 1), answer("low", "low", 2, 1),
             answer("follow", "follow", 1, 0)};
  const auto proposes = [&](std::size_t node, double number, bool held, float vote) {
    d.nodes[node].action = {{.name = "altitude", .number = number, .held = held, .supplier = 2}};
    d.nodes[node].vote = vote;
    d.nodes[node].is_leaf = node > 1;
  };
  proposes(0, 7000, true, 50);
  proposes(1, 7000, true, 50);
  proposes(2, 6000, false, 0);  // goes on asking for something else, without a vote
  proposes(3, 5000, false, 10);
  proposes(4, 4000, false, 20);
  const std::vector<Won> won = team::contest(d.nodes);
  ASSERT_EQ(won.size(), 1u);
  EXPECT_EQ(won[0].value.number, 7000);
  EXPECT_TRUE(won[0].held);
  EXPECT_FALSE(won[0].blended);
  ASSERT_EQ(won[0].rivals.size(), 2u);
  EXPECT_EQ(won[0].rivals[0].against, 50) << "of who holds it, against follow";
  EXPECT_EQ(won[0].rivals[0].vote, 20);
  EXPECT_EQ(won[0].rivals[1].against, 50) << "and against low, which it suppresses";
}

TEST(Decision, CountsOfABlendOnlyWhatItIsMadeOf) {
  Decision d;
  d.nodes = {answer("root", "winner_takes_all", 0, ubf::kNone),
             answer("mix", "fusion", 1, 0),
             answer("climb", "climb", 2, 1),
             answer("best", "winner_takes_all", 2, 1),
             answer("low", "low", 3, 3),
             answer("lower", "lower", 3, 3),
             answer("weak", "weak", 2, 1),
             answer("follow", "follow", 1, 0)};
  const ubf::NodeIndex suppliers[] = {1, 1, 2, 4, 4, 5, 6, 7};
  const float votes[] = {40, 40, 40, 30, 30, 20, 10, 35};
  for (std::size_t n = 0; n < d.nodes.size(); ++n) {
    d.nodes[n].action = {
        {.name = "altitude", .number = 1000.0 * double(n), .supplier = suppliers[n]}};
    d.nodes[n].vote = votes[n];
    d.nodes[n].is_leaf = suppliers[n] == n && n != 1;
  }
  d.nodes[6].given = 0;  // not among the two strongest
  const Won won = team::contest(d.nodes).at(0);
  EXPECT_EQ(reason(won), "blended of 2");
  ASSERT_EQ(won.rivals.size(), 5u);
  EXPECT_EQ(won.rivals[0].node, 2);
  EXPECT_EQ(won.rivals[1].node, 4);
  EXPECT_FALSE(won.rivals[2].blended);
}

TEST(Decision, ShowsOnlyWhatWasAsked) {
  Decision d = in_two_phases(true);
  d.player = PlayerId{1};
  d.tree = "both";
  d.vote = 60;
  scenario::Roster roster;
  roster.players.push_back({.name = "eagle1"});
  const std::string text = decision_text(d, roster);
  EXPECT_NE(text.find("eagle1 at 00:00.0 (step 0), by tree both: shoot leads with 60"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(">     shoot   running, votes 60\n"), std::string::npos) << text;
  EXPECT_NE(text.find("    far       not asked\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("pursue"), std::string::npos) << "below what was not asked";
}

}  // namespace
}  // namespace eyrie::debrief
