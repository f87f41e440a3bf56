// SPDX-License-Identifier: MIT
#pragma once
/// \file  A second interpreter of trees, written from docs/ubf.md: one struct per node, no
/// slab, nothing shared with the library but statuses and cues. oracle_test.cpp compares the two.
#include <algorithm>
#include <map>

#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {

struct Answer {
  Status status = kFailure;
  bool proposes = false;
  double altitude = 0;
  float vote = 0;
};
inline constexpr Answer kNobody{};
inline Answer bare(Status status) {
  return {.status = status};
}
inline bool is_heard(const Answer& a) {
  return a.status != kFailure && a.vote > 0;
}

struct Oracle {
  std::string type;
  std::vector<Oracle> children;
  int number = 0;     ///< the cue of a probe, the first parameter of others
  int limit = 1;      ///< failure_count
  double span = 0;    ///< s
  bool flag = false;  ///< once, running
  // memory
  int count = 0, chosen = 0;
  bool running = false;
  std::optional<double> since;
  Answer held;
  std::vector<int> marks;    ///< by child: it goes on, or how it ended
  std::vector<Status> ends;  ///< of a parallel, by child

  void halt() {
    count = chosen = 0;
    running = false;
    since.reset();
    marks.assign(children.size(), 0);
    ends.assign(children.size(), kRunning);
    for (Oracle& child : children)
      child.halt();
  }
  [[nodiscard]] bool is_one_of(std::initializer_list<std::string_view> types) const {
    return std::find(types.begin(), types.end(), type) != types.end();
  }
  /// Something below may be running although the node itself answered success or failure.
  [[nodiscard]] bool stands() const {
    if (is_one_of({"winner_takes_all", "per_field", "priority", "commitment", "suppress", "inhibit",
                   "sequencer"}))
      return true;
    if (is_one_of({"force_success", "force_failure"}) && flag)
      return true;
    return is_one_of({"selector", "sequence", "while", "guard", "inverter", "force_success",
                      "force_failure", "timeout"}) &&
           std::any_of(children.begin(), children.end(), [](const auto& c) { return c.stands(); });
  }
  void end() {
    if (stands())
      halt();
  }
};

/// One decision of one tree.
struct Asking {
  const State& state;
  double time;

  [[nodiscard]] bool passed(const Oracle& n) const {
    return n.since && time - *n.since >= n.span - 1e-6;
  }
  [[nodiscard]] bool is_within(const Oracle& n) const { return n.since && !passed(n); }

  Answer ask(Oracle& n) const {
    static const std::map<std::string_view, Answer (Asking::*)(Oracle&) const> kNodes{
        {"probe", &Asking::probe},
        {"selector", &Asking::reactive},
        {"sequence", &Asking::reactive},
        {"selector_with_memory", &Asking::resuming},
        {"sequence_with_memory", &Asking::resuming},
        {"parallel", &Asking::parallel},
        {"parallel_all", &Asking::parallel_all},
        {"winner_takes_all", &Asking::arbiter},
        {"per_field", &Asking::arbiter},
        {"priority", &Asking::arbiter},
        {"commitment", &Asking::commitment},
        {"suppress", &Asking::suppress},
        {"inhibit", &Asking::inhibit},
        {"if_then_else", &Asking::if_then_else},
        {"while", &Asking::branch},
        {"guard", &Asking::guard},
        {"inverter", &Asking::turned},
        {"force_success", &Asking::turned},
        {"force_failure", &Asking::turned},
        {"repeat", &Asking::repeating},
        {"retry", &Asking::repeating},
        {"run_once", &Asking::run_once},
        {"timeout", &Asking::timeout},
        {"cooldown", &Asking::cooldown},
        {"rate_limit", &Asking::rate_limit},
        {"delay", &Asking::delay},
        {"sequencer", &Asking::sequencer}};
    const Answer answer = (this->*kNodes.at(n.type))(n);
    return answer.status == kFailure ? kNobody : answer;
  }
  Answer ask_to_its_end(Oracle& child) const {
    const Answer answer = ask(child);
    if (answer.status != kRunning)
      child.end();
    return answer;
  }
  Answer ask_marked(Oracle& n, std::size_t i) const {
    const Answer answer = ask(n.children[i]);
    n.marks[i] = answer.status == kRunning || n.children[i].stands();
    return answer;
  }
  static void leave(Oracle& n, std::size_t i) {
    if (n.marks[i])
      n.children[i].halt();
    n.marks[i] = 0;
  }
  static void merge(Answer& into, const Answer& more) {
    if (more.proposes && (!into.proposes || more.vote > into.vote))
      into = {into.status, true, more.altitude, more.vote};
  }

  Answer probe(Oracle& n) const {
    ++n.count;
    const Cue& cue = state.cues[static_cast<std::size_t>(n.number)];
    return {cue.status, cue.action.altitude.has_value(), cue.action.altitude.value_or(0), cue.vote};
  }
  Answer reactive(Oracle& n) const {
    const Status go_on = n.type == "selector" ? kFailure : kSuccess;
    Answer all = bare(go_on);
    std::size_t asked = 0;
    while (asked < n.children.size() && all.status == go_on) {
      const Answer answer = ask_marked(n, asked++);
      if (answer.proposes)
        all = answer;
      all.status = answer.status;
    }
    for (std::size_t i = asked; i < n.children.size(); ++i)
      leave(n, i);
    return all;
  }
  Answer resuming(Oracle& n) const {
    const Status go_on = n.type == "selector_with_memory" ? kFailure : kSuccess;
    Answer all = bare(go_on);
    for (auto i = std::exchange(n.chosen, 0); i < std::ssize(n.children) && all.status == go_on;
         ++i) {
      const Answer answer = ask_to_its_end(n.children[static_cast<std::size_t>(i)]);
      if (answer.proposes)
        all = answer;
      all.status = answer.status;
      if (answer.status == kRunning)
        n.chosen = static_cast<int>(i);
    }
    return all;
  }
  Answer parallel(Oracle& n) const {
    Answer all;
    int successes = 0, failures = 0;
    for (std::size_t i = 0; i < n.children.size(); ++i) {
      Status& ended = n.ends[i];
      if (!n.flag || ended == kRunning) {
        const Answer answer = n.flag ? ask_to_its_end(n.children[i]) : ask_marked(n, i);
        ended = answer.status;
        n.marks[i] = n.flag ? ended == kRunning : n.marks[i];
        merge(all, answer);
      }
      successes += ended == kSuccess;
      failures += ended == kFailure;
    }
    const int count = static_cast<int>(n.children.size()), enough = n.number ? n.number : count;
    all.status = successes >= enough                                ? kSuccess
                 : failures >= n.limit || count - failures < enough ? kFailure
                                                                    : kRunning;
    for (std::size_t i = 0; i < n.children.size() && all.status != kRunning; ++i) {
      leave(n, i);
      n.ends[i] = kRunning;
    }
    return all;
  }
  Answer parallel_all(Oracle& n) const {
    Answer all = bare(kSuccess);
    for (std::size_t i = 0; i < n.children.size(); ++i) {
      if (n.marks[i])
        continue;
      const Answer answer = ask_to_its_end(n.children[i]);
      merge(all, answer);
      if (answer.status == kRunning)
        all.status = kRunning;
      else
        n.marks[i] = answer.status == kFailure ? 2 : 1;
    }
    if (all.status == kRunning)
      return all;
    if (std::count(n.marks.begin(), n.marks.end(), 2) >= n.limit)
      all.status = kFailure;
    n.marks.assign(n.children.size(), 0);
    return all;
  }
  Answer arbiter(Oracle& n) const {
    Answer best;
    for (Oracle& child : n.children)
      if (const Answer answer = ask(child); is_heard(answer))
        if (!best.proposes || (n.type != "priority" && answer.vote > best.vote))
          best = answer;
    return best;
  }
  /// With a margin of 1.
  Answer commitment(Oracle& n) const {
    Answer best, kept;
    int rival = 0;
    for (int i = 0; i < std::ssize(n.children); ++i) {
      const Answer answer = ask(n.children[static_cast<std::size_t>(i)]);
      if (!is_heard(answer))
        continue;
      if (i + 1 == n.chosen) {
        kept = answer;
      } else if (answer.vote > best.vote) {
        best = answer;
        rival = i + 1;
      }
    }
    if (!kept.proposes || (passed(n) && best.vote > kept.vote + 1)) {
      kept = best;
      n.chosen = rival;
      n.since = time;
    }
    if (kept.status == kSuccess)
      n.chosen = 0;
    return kept;
  }
  Answer suppress(Oracle& n) const {
    const Answer by = ask(n.children[0]), lower = ask(n.children[1]);
    if (is_heard(by)) {
      n.since = time;
      n.held = by;
      n.held.status = kRunning;
      return by;
    }
    return is_within(n) ? n.held : is_heard(lower) ? lower : kNobody;
  }
  Answer inhibit(Oracle& n) const {
    const Answer by = ask(n.children[0]), lower = ask(n.children[1]);
    if (by.status != kFailure)
      n.since = time;
    return !is_within(n) && is_heard(lower) ? lower : kNobody;
  }
  Answer if_then_else(Oracle& n) const {
    if (!n.chosen) {
      const Answer condition = ask_to_its_end(n.children[0]);
      if (condition.status == kRunning)
        return bare(kRunning);
      n.chosen = condition.status == kSuccess ? 1 : 2;
    }
    const Answer answer = ask_to_its_end(n.children[static_cast<std::size_t>(n.chosen)]);
    if (answer.status != kRunning)
      n.chosen = 0;
    return answer;
  }
  bool holds(Oracle& condition) const {
    const Status status = ask(condition).status;
    if (status == kRunning)
      condition.halt();
    return status == kSuccess;
  }
  Answer branch(Oracle& n) const {
    const std::size_t turn = holds(n.children[0]) ? 1 : 2;
    leave(n, 3 - turn);
    return ask_marked(n, turn);
  }
  Answer guard(Oracle& n) const {
    if (holds(n.children[0]))
      return ask_marked(n, 1);
    leave(n, 1);
    return kNobody;
  }
  Answer turned(Oracle& n) const {
    const Answer answer = ask(n.children[0]);
    if (n.flag && answer.status == kRunning)
      return n.type == "force_success"
                 ? Answer{kSuccess, answer.proposes, answer.altitude, answer.vote}
                 : kNobody;
    if (answer.status == kRunning || (n.type == "force_success" && answer.status == kSuccess))
      return answer;
    if (n.type == "inverter")
      return bare(answer.status == kSuccess ? kFailure : kSuccess);
    return bare(n.type == "force_success" ? kSuccess : kFailure);
  }
  Answer repeating(Oracle& n) const {
    const Status again = n.type == "repeat" ? kSuccess : kFailure;
    Answer answer = ask_to_its_end(n.children[0]);
    if (answer.status == kRunning)
      return answer;
    if (answer.status != again || ++n.count == n.number) {
      n.count = 0;
      return answer;
    }
    answer.status = kRunning;
    return answer;
  }
  Answer run_once(Oracle& n) const {
    if (n.running)  // it has ended
      return bare(n.number == 0 ? n.held.status : n.number == 1 ? kFailure : kSuccess);
    n.held = ask_to_its_end(n.children[0]);
    n.running = n.held.status != kRunning;
    return n.held;
  }
  Answer timeout(Oracle& n) const {
    if (passed(n)) {
      n.halt();
      return kNobody;
    }
    const Answer answer = ask(n.children[0]);
    n.since = answer.status == kRunning ? std::optional(n.since.value_or(time)) : std::nullopt;
    return answer;
  }
  Answer cooldown(Oracle& n) const {
    if (is_within(n))
      return kNobody;
    const Answer answer = ask_to_its_end(n.children[0]);
    const bool ended = answer.status == kSuccess || (answer.status == kFailure && n.running);
    n.since = ended ? std::optional(time) : std::nullopt;
    n.running = answer.status == kRunning;
    return answer;
  }
  Answer rate_limit(Oracle& n) const {
    if (!n.running && is_within(n))
      return kNobody;
    const Answer answer = ask_to_its_end(n.children[0]);
    if (!n.running && answer.status != kFailure)
      n.since = time;
    n.running = answer.status == kRunning;
    return answer;
  }
  Answer delay(Oracle& n) const {
    n.since = n.since.value_or(time);
    if (!n.running && !passed(n))
      return bare(kRunning);
    const Answer answer = ask_to_its_end(n.children[0]);
    n.running = answer.status == kRunning;
    if (!n.running)
      n.since.reset();
    return answer;
  }
  /// Its trees, and then what leads from each of them to the next, and from any to the first.
  Answer sequencer(Oracle& n) const {
    const auto trees = static_cast<std::size_t>(n.number);
    auto now = static_cast<std::size_t>(n.chosen);
    for (std::size_t c = trees; c < n.children.size(); ++c) {
      const bool is_any = c + 1 == n.children.size();
      if ((is_any ? now != 0 : now == c - trees) && ask(n.children[c]).status == kSuccess) {
        n.halt();
        n.chosen = static_cast<int>(is_any ? 0 : (now + 1) % trees);
        now = static_cast<std::size_t>(n.chosen);
        break;
      }
    }
    return ask(n.children[now]);
  }
};

}  // namespace eyrie::ubf::testing
