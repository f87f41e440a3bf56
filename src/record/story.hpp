// SPDX-License-Identifier: MIT
#pragma once
/// \file  The run in the field's words, one line per thing worth telling.
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/events.hpp"
#include "scenario/scenario.hpp"
#include "sim/system.hpp"

namespace eyrie::record {

/// What a line is about, for colour and filters.
enum class Tone : unsigned char { plain, blue, red, kill, phase };

struct StoryLine {
  double time = 0;  ///< s
  Tone tone = Tone::plain;
  model::EventKind kind = model::EventKind::none;  ///< of the event that it tells
  PlayerId player;                                 ///< who does it
  std::string who, text;
};

/// Turns events into lines. Tells the first contact with and identification of each enemy by each
/// flight, not those of each aircraft, and what a flight's lead does for its flight.
class Story final : public sim::Observer {
 public:
  using Tell = std::function<void(const StoryLine&)>;
  Story(const scenario::Scenario& scenario, Tell tell);

  void begin(const sim::World& world, double dt) override;
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;

 private:
  struct Missile {
    PlayerId shooter, target;
    std::string label;
  };

  void tell(const sim::Event& e);
  void say(PlayerId who, std::string text, Tone tone = Tone::plain);
  void shot(const sim::Event& e);
  void ended(const sim::Event& e);
  bool first_in_flight(std::uint16_t what, PlayerId who, PlayerId whom);
  [[nodiscard]] std::string name(PlayerId id) const;
  [[nodiscard]] bool same_side(PlayerId a, PlayerId b) const;

  const scenario::Scenario& scenario_;
  Tell tell_;
  double time_ = 0;
  model::EventKind kind_ = model::EventKind::none;  ///< that is being told
  std::map<PlayerId, Missile> missiles_;
  std::set<std::tuple<std::uint16_t, std::uint16_t, PlayerId>> told_;
  std::vector<PlayerId> leads_;
  std::vector<std::string> phases_;  ///< per flight
};

/// "12:05.3"
[[nodiscard]] std::string clock_text(double time);

}  // namespace eyrie::record
