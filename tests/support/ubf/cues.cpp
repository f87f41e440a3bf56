// SPDX-License-Identifier: MIT
#include "support/ubf/cues.hpp"

namespace eyrie::ubf::testing {
namespace {

template <class T>
rc::Gen<std::optional<T>> maybe(rc::Gen<T> gen) {
  return rc::gen::map(rc::gen::pair(rc::gen::arbitrary<bool>(), std::move(gen)),
                      [](const std::pair<bool, T>& drawn) {
                        return drawn.first ? std::optional<T>(drawn.second) : std::nullopt;
                      });
}

}  // namespace

rc::Gen<double> any_heading() {
  return rc::gen::map(rc::gen::inRange(0, 360), [](int deg) { return radians(deg); });
}

rc::Gen<Cue> any_cue() {
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

rc::Gen<Cues> any_cues() {
  const auto cues = rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 7), [](std::size_t count) {
    return rc::gen::container<Cues>(count, any_cue());
  });
  return rc::gen::resize(rc::kNominalSize, cues);
}

rc::Gen<Cues> any_cues_with_a_heading() {
  return rc::gen::map(rc::gen::pair(any_cues(), any_heading()), [](std::pair<Cues, double> drawn) {
    Cue& first = drawn.first.front();
    first.status = kRunning;
    first.vote += 1;
    first.action.heading = drawn.second;
    return std::move(drawn.first);
  });
}

Cues shuffled(const Cues& cues) {
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
