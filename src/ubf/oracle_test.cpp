// SPDX-License-Identifier: MIT
/// \file  Random trees decide, and forget, as the second interpreter says that the page says.
#include "support/ubf/oracle.hpp"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "core/draw.hpp"
#include "support/ubf/registry.hpp"

namespace eyrie::ubf::testing {
namespace {

using Types = std::vector<std::string>;
const Types kOfMany{"selector", "sequence",     "selector_with_memory", "sequence_with_memory",
                    "parallel", "parallel_all", "winner_takes_all",     "per_field",
                    "priority", "commitment"};
const Types kOfOne{"inverter", "force_success", "force_failure", "repeat",     "retry",
                   "run_once", "timeout",       "cooldown",      "rate_limit", "delay"};
const Types kOfSlots{"if_then_else", "while", "guard", "suppress", "inhibit", "sequencer"};

/// The same seed grows the same tree; each of its probes has a cue of its own.
class Grower {
 public:
  explicit Grower(std::uint64_t seed) : draw_(seed, PlayerId{1}, Stream::test, 0) {}

  Oracle node(int depth) {
    Oracle n;
    const Types& types = pick(5) < 2 ? kOfMany : pick(3) < 2 ? kOfOne : kOfSlots;
    n.type = types[static_cast<std::size_t>(pick(static_cast<int>(types.size())))];
    // a sequencer has up to seven children
    if (depth == 0 || pick(4) == 0 || cues_ > static_cast<int>(State::kCues) - 8) {
      n.type = "probe";
      n.number = cues_++;
      return n;
    }
    int count = &types == &kOfMany ? 1 + pick(3) : &types == &kOfOne ? 1 : 2;
    n.number = n.type == "parallel" ? pick(count + 1) : n.type == "run_once" ? pick(3) : pick(4);
    if (n.type == "sequencer") {
      n.number = 2 + pick(2);
      count = 2 * n.number + 1;
    } else if (n.is_one_of({"if_then_else", "while"})) {
      count = 3;
    }
    n.limit = 1 + pick(count);
    n.span = 0.5 * (1 + pick(5));
    n.flag = n.is_one_of({"parallel", "force_success", "force_failure"}) && pick(2);
    for (int i = 0; i < count; ++i)
      n.children.push_back(node(depth - 1));
    return n;
  }
  [[nodiscard]] int cues() const { return cues_; }

 private:
  int pick(int count) { return static_cast<int>(draw_.uniform() * count); }
  Draw draw_;
  int cues_ = 0;
};

std::string text_of(const Oracle& n) {
  if (n.type == "probe")
    return fmt::format("{{probe: {{cue: {}}}}}", n.number);
  std::vector<std::string> all;
  for (const Oracle& child : n.children)
    all.push_back(text_of(child));
  std::string body;
  const auto say = [&]<class T>(std::string_view key, const T& value) {
    body += fmt::format("{}: {}, ", key, value);
  };
  const auto span_as = [&](std::string_view key) { say(key, fmt::format("{} s", n.span)); };
  if (n.type == "parallel" && n.number)
    say("success_count", n.number);
  if (n.is_one_of({"parallel", "parallel_all"}))
    say("failure_count", n.limit);
  if (n.is_one_of({"repeat", "retry"}) && n.number)
    say(n.type == "repeat" ? "count" : "attempts", n.number);
  if (n.type == "run_once")
    say("then", n.number == 0 ? "same" : n.number == 1 ? "failure" : "success");
  if (n.flag)
    say(n.type == "parallel" ? "once" : "running", true);
  if (n.type == "commitment")
    say("margin", 1), span_as("min_time");
  else if (n.is_one_of({"suppress", "inhibit"}))
    span_as("hold"), say("by", all[0]), say("child", all[1]);
  else if (n.is_one_of({"cooldown", "delay"}))
    span_as("duration");
  else if (n.type == "timeout")
    span_as("after");
  else if (n.type == "rate_limit")
    span_as("period");
  else if (n.type == "guard")
    say("when", all[0]), say("child", all[1]);
  else if (n.type == "while")
    say("when", all[0]), say("do", all[1]), say("else", all[2]);
  else if (n.type == "if_then_else")
    say("if", all[0]), say("then", all[1]), say("else", all[2]);
  if (n.type == "sequencer") {
    std::string trees, links;
    for (int i = 0; i < n.number; ++i) {
      trees += fmt::format("t{}: {}, ", i, all[static_cast<std::size_t>(i)]);
      links += fmt::format("{{from: t{}, to: t{}, when: {}}}, ", i, (i + 1) % n.number,
                           all[static_cast<std::size_t>(n.number + i)]);
    }
    return fmt::format(
        "{{sequencer: {{start: t0, trees: {{{}}}, transitions: [{}{{from: any, to: "
        "t0, when: {}}}]}}}}",
        trees, links, all.back());
  }
  if (std::find(kOfMany.begin(), kOfMany.end(), n.type) != kOfMany.end())
    say("children", fmt::format("[{}]", fmt::join(all, ", ")));
  else if (std::find(kOfOne.begin(), kOfOne.end(), n.type) != kOfOne.end())
    say("child", all[0]);
  return fmt::format("{{{}: {{{}}}}}", n.type, body);
}

/// How often each probe was asked since it last forgot, by its cue.
void note_counts(const Oracle& n, std::vector<std::uint32_t>& counts) {
  if (n.type == "probe")
    counts[static_cast<std::size_t>(n.number)] = static_cast<std::uint32_t>(n.count);
  for (const Oracle& child : n.children)
    note_counts(child, counts);
}
std::vector<std::uint32_t> counts_of(const Robot& robot) {
  std::vector<std::uint32_t> counts(State::kCues);
  for (std::size_t i = 0; i < robot.tree.size(); ++i) {
    const auto& node = robot.tree.node(static_cast<NodeIndex>(i));
    if (node.type() == "probe") {
      const auto& probe = static_cast<const Probe&>(node);
      counts[probe.cue] = probe.asked(robot.slab.data());
    }
  }
  return counts;
}

TEST(Oracle, DecidesAndForgetsAsTheLibraryDoes) {
  std::map<std::string, int> seen;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Grower grower(seed);
    Oracle oracle = grower.node(1 + static_cast<int>(seed % 5));
    if (grower.cues() > static_cast<int>(State::kCues))
      continue;
    oracle.halt();
    ++seen[oracle.type];
    const std::string text = text_of(oracle);
    Robot robot(build(text));
    Draw draw(seed, PlayerId{2}, Stream::test, 0);
    for (int i = 0; i < 40; ++i) {
      for (Cue& cue : robot.state.cues) {
        cue = {.status = static_cast<Status>(draw.uniform() * 3)};
        if (draw.uniform() < 0.7) {
          cue.action.altitude = std::floor(draw.uniform() * 1000);
          cue.vote = std::floor(static_cast<float>(draw.uniform()) * 4);
        }
      }
      robot.tick_at(0.5 * i);
      const Answer said = Asking{robot.state, robot.time}.ask(oracle);
      ASSERT_EQ(robot.status, said.status) << text << " in tick " << i;
      ASSERT_EQ(robot.out.action.altitude.has_value(), said.proposes) << text << " in tick " << i;
      if (said.proposes) {
        ASSERT_EQ(*robot.out.action.altitude, said.altitude) << text << " in tick " << i;
        ASSERT_EQ(robot.out.vote, said.vote) << text << " in tick " << i;
      }
      std::vector<std::uint32_t> counts(State::kCues);
      note_counts(oracle, counts);
      ASSERT_EQ(counts_of(robot), counts) << text << " in tick " << i;
    }
  }
  EXPECT_EQ(seen.size(), kOfMany.size() + kOfOne.size() + kOfSlots.size() + 1);
}

}  // namespace
}  // namespace eyrie::ubf::testing
