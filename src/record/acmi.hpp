// SPDX-License-Identifier: MIT
#pragma once
/// \file  Tacview ACMI 2.2 text: aircraft, missiles, kills, locks, fuel and who is in charge.
/// Format: https://www.tacview.net/documentation/acmi/ (as of 2024-06-20).
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/angle.hpp"
#include "core/id.hpp"
#include "core/vec.hpp"
#include "model/frames.hpp"
#include "record/story.hpp"
#include "scenario/scenario.hpp"
#include "sim/system.hpp"

namespace eyrie::record {

/// Where somebody was, and how it lay in the air.
struct Pose {
  double time = 0;                          ///< s
  Vec3 position = {};                       ///< m, local frame
  double roll = 0, pitch = 0, heading = 0;  ///< rad
};

/// How far what is left out may be from the line between what is kept.
struct Tolerance {
  double position = 0;  ///< m
  double attitude = 0;  ///< rad, of each angle
};

/// Marks what has to be kept besides what is marked already (the first and the last pose must be):
/// each line reaches as far as all poses that it leaves out are within the tolerance. Angles turn
/// the shorter way.
/// `keeps` is told of each pose in order whether it is kept so far, and says whether it is.
void thin(
    std::span<const Pose> poses, std::vector<bool>& kept, const Tolerance& tolerance,
    const std::function<bool(std::size_t, bool)>& keeps = [](std::size_t, bool is) { return is; });

/// A line of the file. Lines of one step stand in the order of their kind, then as they came.
struct AcmiLine {
  enum class Kind : std::uint8_t { object, event, removal };
  std::uint64_t step = 0;
  Kind kind = Kind::object;
  std::string text;  ///< with its end
};

/// An object at a time.
struct AcmiSample {
  std::uint64_t step = 0;
  Pose pose;
  double speed = -1;        ///< m/s; below 0: not told
  double mach = 0;          ///< 0: not told, nor the load factor
  double load_factor = 0;   ///< g
  double fuel = -1;         ///< kg; below 0: not told
  std::uint32_t lock = 0;   ///< id of the target, 0: none
  std::string_view winner;  ///< the behavior in charge, as acmi_name(); it outlives the sample
  float vote = 0;
  bool wanted = false;  ///< it is written, whatever its neighbors are
};

/// Collects samples and writes those that a reader needs who draws straight lines between them,
/// and of these what has changed.
class AcmiObject {
 public:
  /// What no reader draws by itself: what is left out is no farther than this from the line.
  static constexpr Tolerance kTolerance{.position = 3, .attitude = radians(1.5)};

  /// `introduction` ends its first line: ",Type=...".
  AcmiObject(PlayerId id, std::string introduction)
      : id_(id), introduction_(std::move(introduction)) {}

  /// Later than all before. The first one, a new lock, another behavior in charge, a vote that has
  /// changed by more than a twentieth and instruments that have moved far are wanted anyway.
  void see(AcmiSample sample);
  /// Where it is after a step.
  void pass(const Pose& pose) { last_ = pose; }
  /// It is gone; `step` is the last one in which it was there.
  void leave(std::uint64_t step);
  [[nodiscard]] bool gone() const { return gone_; }

  /// Everything since the last time, its last sample included.
  void write(const Reference& reference, std::vector<AcmiLine>& lines);
  /// Adds a line with everything that has been written of it, as it stands now.
  void write_whole(std::string& text) const;

 private:
  /// What stands in the file of it.
  struct Told {
    std::array<std::string, 6> place;
    double speed = -1, mach = -1, load_factor = -1e9, fuel = -1e9;
    std::optional<std::uint32_t> lock;  ///< none: it never had one
    std::string winner;
    float vote = -1;
  };
  [[nodiscard]] bool moved_far(const AcmiSample& sample) const;
  void line(const AcmiSample& sample, const Reference& reference, std::string& text);
  /// Adds the line that makes `before` what is told now.
  void write_line(const Told& before, std::string& text) const;

  PlayerId id_;
  std::string introduction_;
  std::vector<AcmiSample> samples_;  ///< the first one has been written, if any has
  Pose last_;
  bool begun_ = false, gone_ = false;
  float noted_vote_ = -1;
  Told told_;
};

// Texts as values of a Tacview ACMI 2.2 file. The published rules escape the comma and, in
// free text, the line end, both by a backslash; they have no escape for the backslash itself, nor
// for the bar between the parts of an event, and readers that do not know the rule for line ends
// are common. So whatever could be taken for more than text is written as its look-alike:
// a backslash as U+FF3C, a bar of an event as U+FF5C, any other control character as U+FFFD.

/// Free text of several lines, such as Comments: their ends are escaped.
[[nodiscard]] std::string acmi_text(std::string_view text);
/// A name, of one line: line ends are blanks.
[[nodiscard]] std::string acmi_name(std::string_view text);
/// A part of an event, of one line.
[[nodiscard]] std::string acmi_event_text(std::string_view text);

/// Writes a flight recording while a run is flown. Players are sampled at 5 Hz and
/// missiles at 10 Hz; of these samples the file has those that a reader needs who draws straight
/// lines between them (AcmiObject::kTolerance), one in five seconds at least. The story is there as
/// messages; shots, defenses, losses and flights' phases are bookmarks, too. Births, deaths,
/// events, locks and whom the tree obeys stand at their time. Positions are relative to the
/// reference point, so that seven decimals of a degree (about 1 cm) stay short.
class AcmiWriter final : public sim::Observer {
 public:
  /// Takes the next lines of the file.
  using Out = std::function<void(std::string_view)>;
  /// Of a recording, and what somebody who watches does not mind to wait for: s, whole fifths.
  static constexpr double kRecorded = 5, kWatched = 1;

  /// `out` gets the lines of so many seconds (`window`) at once: what is left out of the file is
  /// left out between two of these times.
  AcmiWriter(const scenario::Scenario& scenario, Out out, double window = kRecorded);

  /// A file that begins here: all that `out` got so far made no more of what there is now. To be
  /// called by `out`.
  [[nodiscard]] std::string whole() const;

  void begin(const sim::World& world, double dt) override;
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;
  void finish(const sim::World& world) override;

 private:
  void introduce(PlayerId id);
  void see_players(const sim::World& world);
  void see_missiles(const sim::World& world);
  void see(PlayerId id, AcmiSample sample);
  [[nodiscard]] AcmiSample player(const scenario::Fleet& fleet, const sim::World& world,
                                  std::size_t row);
  [[nodiscard]] AcmiSample sample_of(const model::Kinematics& k) const;
  void born(const sim::Event& launch, const sim::World& world);
  void gone(PlayerId id);
  void happened(const sim::Event& event, const sim::World& world);
  void tell_story(const StoryLine& line);
  template <class... T>
  void tell(fmt::format_string<T...> format, T&&... values) {
    lines_.push_back(
        {step_, AcmiLine::Kind::event, fmt::format(format, std::forward<T>(values)...)});
  }
  void pass(const sim::World& world);
  void write_lines();

  const scenario::Scenario& scenario_;
  Out out_;
  double window_;
  std::string header_;
  std::uint64_t step_ = 0;
  double time_ = 0, dt_ = 0;
  std::uint64_t players_every_ = 10, missiles_every_ = 5, lines_every_ = 250;  // steps
  std::map<std::uint32_t, AcmiObject> objects_;                                ///< by id
  std::map<std::pair<const void*, std::uint32_t>, std::string> labels_;        ///< by tree and node
  std::vector<std::optional<std::uint64_t>> seen_;  ///< by player: the step of the last look
  std::vector<AcmiLine> lines_;
  Story story_;
  std::string written_frame_;
};

}  // namespace eyrie::record
