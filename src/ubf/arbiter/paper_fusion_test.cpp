// SPDX-License-Identifier: MIT
#include "ubf/arbiter/fusion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"

namespace eyrie::ubf::testing {

/// An order as a flag.
struct Launch {
  std::optional<bool> release{};
};

}  // namespace eyrie::ubf::testing

template <>
struct eyrie::ubf::ActionTraits<eyrie::ubf::testing::Launch> {
  static constexpr auto fields =
      std::tuple{field<blend::Strongest>("release", &testing::Launch::release)};
};

namespace eyrie::ubf::testing {
namespace {

/// Says a flag with a vote.
class Launcher final : public Behavior<int, Launch> {
 public:
  static constexpr std::string_view type_name = "launcher";
  Launcher(bool release, float vote) : release_(release), vote_(vote) {}
  Status tick(const Tick<int>&, Proposal<Launch>& out) const override {
    out.action.release = release_;
    out.vote = vote_;
    return kRunning;
  }

 private:
  bool release_;
  float vote_;
};

TEST(PaperFusion, LaunchesIfAHighlyVotedProposalSaysSoWhateverAStrongerOneSays) {
  const auto release = [](float no, float yes) {
    auto paper = make<PaperFusion<int, Launch>>(make<Launcher>(false, no),  //
                                                make<Launcher>(true, yes));
    paper->high_vote = 50;
    const Tree<int, Launch> tree("launch", std::move(paper));
    Proposal<Launch> out;
    EXPECT_EQ(tree.tick({.state = 0}, out), kRunning);
    return out.action.release;
  };
  EXPECT_EQ(release(90, 60), true);
  EXPECT_EQ(release(60, 90), true);
  EXPECT_EQ(release(90, 49), false) << "not voted highly enough";
  EXPECT_EQ(release(49, 49), std::nullopt);
}

using Paper = PaperFusion<State, Action>;

Answer ask_paper(const Cues& cues, float high_vote) {
  auto paper = make<Paper>(probes(cues.size()));
  paper->high_vote = high_vote;
  Robot robot(std::move(paper));
  return ask(robot, cues);
}

TEST(PaperFusion, AveragesAltitudeVelocityAndHeadingWhateverTheVotes) {
  const Cues cues{{kRunning, 1, {.heading = 1, .altitude = 1000, .speed = 100}},
                  {kRunning, 90, {.heading = 2, .altitude = 4000, .speed = 200}}};
  const Action action = ask_paper(cues, 50).proposal.action;
  EXPECT_DOUBLE_EQ(action.heading.value(), 1.5);
  EXPECT_DOUBLE_EQ(action.altitude.value(), 2500);
  EXPECT_FLOAT_EQ(action.speed.value(), 150);
}

TEST(PaperFusion, AveragesHeadingsAsPlainNumbersAsThePaperDoes) {
  const Cues cues{{kRunning, 1, {.heading = radians(350)}},
                  {kRunning, 1, {.heading = radians(10)}}};
  EXPECT_NEAR(ask_paper(cues, 50).proposal.action.heading.value(), radians(180), 1e-12);
}

TEST(PaperFusion, ReleasesOnlyIfAHighlyVotedProposalAsks) {
  Cues cues{{kRunning, 49, {.release = 1}}, {kRunning, 90, {.altitude = 5}}};
  EXPECT_EQ(ask_paper(cues, 50).proposal.action.release, std::nullopt);
  cues[0].vote = 50;
  EXPECT_EQ(ask_paper(cues, 50).proposal.action.release, 1u);
  cues[1].action.release = 2;
  EXPECT_EQ(ask_paper(cues, 50).proposal.action.release, 2u);
}

TEST(PaperFusion, DropsADisputedChoice) {
  const Cues cues{{kRunning, 1, {.mode = 1}}, {kRunning, 2, {.mode = 2}}};
  EXPECT_EQ(ask_paper(cues, 1).proposal.action.mode, std::nullopt);
}

RC_GTEST_PROP(PaperFusionLaw, VoteAndStatusAreTheStrongests, ()) {
  const Cues cues = *any_cues();
  const Answer answer = ask_paper(cues, 2);
  const std::size_t best = strongest(cues);
  RC_ASSERT(answer.status == (best < cues.size() ? cues[best].status : kFailure));
  RC_ASSERT(answer.proposal.vote == (best < cues.size() ? cues[best].vote : 0));
}

RC_GTEST_PROP(PaperFusionLaw, QuantitiesAreThePlainAverageOfWhoIsHeard, ()) {
  const Cues cues = *any_cues();
  double sum = 0;
  int count = 0;
  for (const Cue& cue : cues)
    if (is_heard(cue) && cue.action.heading) {
      sum += *cue.action.heading;
      ++count;
    }
  const auto heading = ask_paper(cues, 2).proposal.action.heading;
  RC_ASSERT(heading.has_value() == (count > 0));
  if (count)
    RC_ASSERT(std::fabs(*heading - sum / count) <= 1e-12);
}

RC_GTEST_PROP(PaperFusionLaw, VotesDoNotMoveTheAverages, ()) {
  Cues cues = *any_cues();
  const Action before = ask_paper(cues, 2).proposal.action;
  for (Cue& cue : cues)
    if (cue.vote > 0)
      cue.vote = static_cast<float>(*rc::gen::inRange(1, 50));
  const Action after = ask_paper(cues, 2).proposal.action;
  RC_ASSERT(after.heading == before.heading);
  RC_ASSERT(after.altitude == before.altitude);
  RC_ASSERT(after.speed == before.speed);
}

RC_GTEST_PROP(PaperFusionLaw, AnOrderIsThatOfTheStrongestAmongTheHighlyVoted, ()) {
  const Cues cues = *any_cues();
  const float high = static_cast<float>(*rc::gen::inRange(1, 8)) / 2;
  Cues orders;
  for (const Cue& cue : cues)
    if (is_heard(cue) && cue.vote >= high && cue.action.release)
      orders.push_back(cue);
  const std::size_t best = strongest(orders);
  const auto release = ask_paper(cues, high).proposal.action.release;
  if (best == orders.size())
    RC_ASSERT(!release);
  else
    RC_ASSERT(release == orders[best].action.release);
}

}  // namespace
}  // namespace eyrie::ubf::testing
