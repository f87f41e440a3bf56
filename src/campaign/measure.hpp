// SPDX-License-Identifier: MIT
#pragma once
/// \file  What is counted and measured of each flight of a campaign, what the replicates say about
/// it, and how sure that is.
#include <cmath>

#include "core/describe.hpp"
#include "core/value.hpp"
#include "scenario/mission.hpp"
#include "stats/sample.hpp"
#include "ubf/expression.hpp"

namespace eyrie::campaign {

/// One number per replicate.
struct Column {
  std::string name, unit;  ///< SI
};

/// What is estimated from columns.
struct Measure {
  std::string name;
  enum Kind : std::uint8_t {
    share,  ///< of the replicates: the column is 0 or 1
    mean,   ///< over those to which it applies
    ratio,  ///< the sum of `column` over the sum of `per`
  } kind = mean;
  std::size_t column = 0, per = 0;

  /// To a replicate with these values by column.
  [[nodiscard]] bool applies(std::span<const double> values) const {
    return !std::isnan(values[column]) && (kind != ratio || !std::isnan(values[per]));
  }
};
constexpr auto names_of(Measure::Kind) {
  return names_from_zero<Measure::Kind>("share", "mean", "ratio");
}

/// What a measure is about.
enum class What : std::uint8_t {
  outcome,         ///< share: the flight ended as one of `is`
  end_time,        ///< s
  losses,          ///< players of `who` that were lost
  kills,           ///< by `who`, of the other side
  shots,           ///< by `who`
  shots_per_kill,  ///< ratio
  exchange_ratio,  ///< losses of the other sides per loss of `who`
  time_in_phase,   ///< s, that the flights of `who` spent in `phase`, added up
  fuel_left,       ///< kg, mean over the aircraft of `who` at home or alive at the end
  variety,         ///< bit, entropy of who leads the decisions of `who`, by type of node
  motion_variety,  ///< bit, entropy of how `who` bank and climb when they decide
  holds,           ///< share: `if` is true of the measures above it
  event,           ///< every event of that kind
  decision,        ///< every decision that a node of that label or type led
};
constexpr auto names_of(What) {
  return names_from_zero<What>("outcome", "end_time", "losses", "kills", "shots", "shots_per_kill",
                               "exchange_ratio", "time_in_phase", "fuel_left", "variety",
                               "motion_variety", "holds", "event", "decision");
}

/// What is made of the events or decisions of one flight.
enum class Take : std::uint8_t { any, count, first, last, sum, least, most };
constexpr auto names_of(Take) {
  return names_from_zero<Take>("any", "count", "first", "last", "sum", "least", "most");
}

/// A measure as the file gives it.
struct MeasureSpec {
  static constexpr std::string_view type_name = "measure";
  static constexpr std::string_view help = "what is counted or measured of each flight";
  static constexpr auto params() {
    using M = MeasureSpec;
    return Lines{param("what", &M::what, "what it is about").required(),
                 param("is", &M::is, "outcomes that count").items(1, 6),
                 param("who", &M::who, "a side, flight or player; not given: everybody"),
                 param("whom", &M::whom, "to whom it is done, likewise"),
                 param("phase", &M::phase, "name of a phase"),
                 param("event", &M::event, "kind of the events"),
                 param("node", &M::node, "label or type of the node that led the decisions"),
                 param("if", &M::condition,
                       "only those of which this is true; of holds: of the measures above"),
                 param("take", &M::take, "what is made of all in one flight"),
                 param("value", &M::value, "what is taken of each; not given: its time")};
  }
  std::string name;
  Value text;  ///< where all this stands
  What what = What::end_time;
  std::vector<scenario::Outcome> is;
  std::string who, whom, phase, event, node, condition;
  Take take = Take::count;
  std::string value;
};

/// All measures of a campaign.
struct Measures {
  std::vector<MeasureSpec> specs;
  std::vector<Column> columns;                                    ///< by measure, in its order
  std::vector<Measure> estimates;                                 ///< one per spec
  std::vector<std::vector<ubf::detail::Instruction>> conditions;  ///< by spec, of columns
};
[[nodiscard]] Measures read_measures(const Value& map, Diagnostics& diagnostics);

/// Watches one flight, from its first step to its end.
class Watch : public sim::Observer {
 public:
  /// By column; NaN where it does not apply. To be called once, after finish(); `time` (s) is when
  /// the flight ended.
  [[nodiscard]] virtual std::vector<double> values(scenario::Outcome outcome, double time) = 0;
};

/// Throws ConfigError if the scenario has nobody of that name, no such phase or node.
/// Both must outlive it.
[[nodiscard]] std::unique_ptr<Watch> watch(const Measures& measures,
                                           const scenario::Scenario& scenario);

struct Estimate {
  std::uint64_t n = 0;                        ///< replicates to which it applies
  std::optional<double> value{};              ///< nothing of none, and of a ratio to 0
  std::optional<stats::Interval> interval{};  ///< nothing if it has no bounds
  std::optional<double> error{};              ///< standard; nothing of fewer than two
};

/// Takes the replicates of a cell one by one. The same ones in the same order give the same bits.
class Estimator {
 public:
  /// The measure must outlive it.
  explicit Estimator(const Measure& measure) : measure_(&measure) {}
  /// The values of a replicate by column; those of one that has none are left out.
  void add(std::span<const double> values);
  /// Shares have Wilson's interval, means Student's, ratios Fieller's.
  [[nodiscard]] Estimate estimate(double confidence = 0.95) const;
  // what was added, as the kind of the measure wants it
  [[nodiscard]] const stats::Share& share() const { return share_; }
  [[nodiscard]] const stats::Ratio& ratio() const { return ratio_; }

 private:
  const Measure* measure_;
  stats::Share share_;
  stats::Moments numbers_;
  stats::Ratio ratio_;
};

}  // namespace eyrie::campaign
