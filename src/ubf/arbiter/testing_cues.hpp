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
#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {

using Cues = std::vector<Cue>;

template <class T>
rc::Gen<std::optional<T>> maybe(rc::Gen<T> gen) {
  return rc::gen::map(rc::gen::pair(rc::gen::arbitrary<bool>(), std::move(gen)),
                      [](const std::pair<bool, T>& drawn) {
                        return drawn.first ? std::optional<T>(drawn.second) : std::nullopt;
                      });
}

/// A heading, rad, in whole degrees so that a failure can be read.
inline rc::Gen<double> any_heading() {
  return rc::gen::map(rc::gen::inRange(0, 360), [](int deg) { return radians(deg); });
}

inline rc::Gen<Cue> any_cue() {
  const auto drawn = rc::gen::exec([] {
    Cue cue;
    cue.status = static_cast<Status>(*rc::gen::inRange(0, 3));
    cue.vote = static_cast<float>(*rc::gen::inRange(0, 10)) / 2;
    cue.action.heading = *maybe(any_heading());
    cue.action.altitude =
        *maybe(rc::gen::map(rc::gen::inRange(0, 9000), [](int m) { return m / 7.0; }));
    cue.action.speed = *maybe(
        rc::gen::map(rc::gen::inRange(50, 300), [](int v) { return static_cast<float>(v) / 3; }));
    cue.action.release = *maybe(rc::gen::inRange<std::uint32_t>(0, 4));
    cue.action.mode = *maybe(rc::gen::inRange<std::uint8_t>(0, 2));
    return cue;
  });
  return rc::gen::resize(rc::kNominalSize, drawn);  // small sizes would make every status a failure
}

inline rc::Gen<Cues> any_cues() {
  const auto cues = rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 7), [](std::size_t count) {
    return rc::gen::container<Cues>(count, any_cue());
  });
  return rc::gen::resize(rc::kNominalSize, cues);
}

/// At least one child is heard, and it sets a heading.
inline rc::Gen<Cues> any_cues_with_a_heading() {
  return rc::gen::map(rc::gen::pair(any_cues(), any_heading()), [](std::pair<Cues, double> drawn) {
    Cue& first = drawn.first.front();
    first.status = kRunning;
    first.vote += 1;
    first.action.heading = drawn.second;
    return std::move(drawn.first);
  });
}

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

/// The same cues in another order.
inline Cues shuffled(const Cues& cues) {
  std::vector<std::size_t> order(cues.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[*rc::gen::inRange<std::size_t>(0, i)]);
  Cues result;
  for (const std::size_t i : order)
    result.push_back(cues[i]);
  return result;
}

}  // namespace eyrie::ubf::testing
