// SPDX-License-Identifier: MIT
#pragma once
/// \file  The run in the field's words, one line per thing worth telling, and in numbers.
#include <set>

#include "record/names.hpp"
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
  /// Whose decision it comes of, and the time of its step (s) or of one after it: of a launch the
  /// one to release, of a kill the victim's last one.
  PlayerId decider;
  double decided = 0;
};

/// Turns events into lines. Tells the first contact with and identification of each enemy by each
/// flight, not those of each aircraft, and what a flight's lead does for its flight.
class Story final : public sim::Observer {
 public:
  using Tell = std::function<void(const StoryLine&)>;
  Story(const scenario::Scenario& scenario, Tell tell);

  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;

 private:
  void tell(const sim::Event& e);
  void say(PlayerId who, std::string text, Tone tone = Tone::plain, PlayerId decider = {});
  void shot(const sim::Event& e);
  void ended(const sim::Event& e);
  bool first_in_flight(std::uint16_t what, PlayerId who, PlayerId whom);
  [[nodiscard]] std::string name(PlayerId id) const;
  [[nodiscard]] std::string weapon(const sim::Event& e) const;

  const scenario::Scenario& scenario_;
  Tell tell_;
  double time_ = 0, decided_ = 0;
  model::EventKind kind_ = model::EventKind::none;  ///< that is being told
  Missiles missiles_;
  std::map<std::pair<PlayerId, float>, double> released_;  ///< s, by whom and from which store
  std::set<std::tuple<std::uint16_t, std::uint16_t, PlayerId>> told_;
  std::vector<PlayerId> leads_;
  std::vector<std::string> phases_;  ///< per flight
};

/// "12:05.3"
[[nodiscard]] std::string clock_text(double time);

/// Counts a run as it is flown: shots, kills, losses, phases, and how it ended.
class Tally final : public sim::Observer {
 public:
  struct OfPlayer {
    std::uint32_t shots = 0, kills = 0;  ///< a burst of the gun is a shot; of the other side
    bool lost = false, home = false;
    double end_time = 0;  ///< s, when it was lost or came home
    std::string phase;    ///< of its outermost sequencer, "" if it has none
  };
  struct OfSide {
    std::uint32_t players = 0;  ///< that may come home: aircraft
    std::uint32_t losses = 0, shots = 0, kills = 0, home = 0;
  };
  /// A flight's phase is that of whoever leads it.
  struct Phase {
    std::uint16_t flight = 0;
    std::string phase;
    double time = 0;  ///< s, when the flight entered it
  };

  explicit Tally(const scenario::Scenario& scenario);

  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;

  [[nodiscard]] const std::vector<OfPlayer>& players() const { return players_; }
  [[nodiscard]] const std::vector<Phase>& phases() const { return phases_; }
  [[nodiscard]] OfSide side(model::Side side) const;
  /// The phase that a flight is in, "" if none yet.
  [[nodiscard]] std::string_view phase(std::uint16_t flight) const;

 private:
  void enter(PlayerId who, double time);

  const scenario::Scenario& scenario_;
  std::vector<OfPlayer> players_;  ///< index: id - 1
  std::set<PlayerId> hitting_;     ///< whose burst, which may still go on, has hit and is counted
  std::vector<Phase> phases_;
  std::vector<PlayerId> leads_;  ///< per flight
};

}  // namespace eyrie::record
