// SPDX-License-Identifier: MIT
#pragma once
/// \file  What the children of an arbiter may say, for property tests of its laws.
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/angle.hpp"
#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {

using Cues = std::vector<Cue>;

/// A heading, rad, in whole degrees so that a failure can be read.
[[nodiscard]] rc::Gen<double> any_heading();
[[nodiscard]] rc::Gen<Cue> any_cue();
/// One to six.
[[nodiscard]] rc::Gen<Cues> any_cues();
/// At least one child is heard, and it sets a heading.
[[nodiscard]] rc::Gen<Cues> any_cues_with_a_heading();

/// Gives every child a vote of its own, so that there are no ties.
inline Cues without_ties(Cues cues) {
  for (std::size_t i = 0; i < cues.size(); ++i)
    if (cues[i].vote > 0)
      cues[i].vote += static_cast<float>(i + 1) / 64;
  return cues;
}

/// A child that an arbiter hears.
inline bool is_heard(const Cue& cue) {
  return cue.status != kFailure && cue.vote > 0;
}

/// What an arbiter over probes with these cues answers.
struct Answer {
  Status status = kFailure;
  RobotProposal proposal;
};

inline bool operator==(const Answer& a, const Answer& b) {
  return a.status == b.status && a.proposal.vote == b.proposal.vote &&
         equal(a.proposal.action, b.proposal.action);
}

inline Answer ask(Robot& robot, const Cues& cues) {
  std::copy(cues.begin(), cues.end(), robot.state.cues.begin());
  robot.tick();
  return {robot.status, robot.out};
}

template <class Arbiter>
Answer ask(const Cues& cues) {
  Robot robot(make<Arbiter>(probes(cues.size())));
  return ask(robot, cues);
}

/// The strongest child that is heard, the earlier of equals; cues.size() if none is.
inline std::size_t strongest(const Cues& cues) {
  std::size_t best = cues.size();
  for (std::size_t i = 0; i < cues.size(); ++i)
    if (is_heard(cues[i]) && (best == cues.size() || cues[i].vote > cues[best].vote))
      best = i;
  return best;
}

/// Votes times a power of two, which is exact.
inline Cues scaled(Cues cues, float factor) {
  for (Cue& cue : cues)
    cue.vote *= factor;
  return cues;
}

/// Laws that every memoryless arbiter obeys: vote and status are the strongest child's; children
/// that are not heard change nothing; common scaling of the votes only scales the vote.
template <class Arbiter>
void obeys_common_laws(const Cues& cues) {
  const Answer answer = ask<Arbiter>(cues);
  const std::size_t best = strongest(cues);
  if (best == cues.size()) {
    RC_ASSERT(answer.status == kFailure);
    RC_ASSERT(answer.proposal.is_empty());
    return;
  }
  RC_ASSERT(answer.status == cues[best].status);
  RC_ASSERT(answer.proposal.vote == cues[best].vote);

  Cues heard;
  std::copy_if(cues.begin(), cues.end(), std::back_inserter(heard), is_heard);
  RC_ASSERT(ask<Arbiter>(heard) == answer);

  Answer louder = ask<Arbiter>(scaled(cues, 4));
  RC_ASSERT(louder.proposal.vote == 4 * answer.proposal.vote);
  louder.proposal.vote /= 4;
  RC_ASSERT(louder == answer);
}

/// The same cues in another order, drawn by RapidCheck.
[[nodiscard]] Cues shuffled(const Cues& cues);

}  // namespace eyrie::ubf::testing
