// SPDX-License-Identifier: MIT
#pragma once
/// \file  The pages that viewer/build.mjs makes, with what they are to show; and a flight as the
/// debrief page reads it (viewer/src/run/decode.ts).
#include "debrief/recorded.hpp"

namespace eyrie::page {

/// Where a page takes its parts.
inline constexpr std::string_view kPlaceOfParts = "<!--%PARTS%-->";

/// Something that a page carries, as `<script type="application/x-eyrie-TYPE">`.
struct Part {
  std::string_view type;
  std::string data;  ///< packed(); empty: it was given up
};
/// A run file, which the engine in the page flies again: its hashes say whether it flies as it did,
/// not in which field it does not.
[[nodiscard]] Part run_file_part(const record::RunFile& run);
/// Bytes as a part: "zones", the launch zones of the shipped missiles (model::KeptZones), which the
/// engine then need not fly; "texts", what a playground is made of: a JSON object with `files`, the
/// texts by name, and `schema`; "live", a JSON object with the `scenario` and `seed` of a mission
/// that is told of at /live.
[[nodiscard]] Part part_of(std::string_view type, std::string_view bytes);
/// Whether a page has the engine in it.
[[nodiscard]] bool has_engine(std::string_view page);
/// A page with its parts; empty if it has no place for them.
[[nodiscard]] std::string page_with(std::string_view page, std::span<const Part> parts);

/// The same of a page that may talk to whoever gave it, and to nobody else.
[[nodiscard]] std::string live_page(std::string_view page, std::span<const Part> parts);

/// A zlib stream as Ascii85, a quarter longer than its bytes; 'v' stands for '<', which HTML may
/// take for its own.
[[nodiscard]] std::string packed(std::string_view bytes);
/// zlib (RFC 1950), as the browser's DecompressionStream('deflate') reads it.
[[nodiscard]] std::string deflated(std::string_view bytes);

/// Told s of simulated time now and then while a run is flown again; false gives up.
using Progress = std::function<bool(double)>;

/// With more players than this decisions are kept when they are other ones than before, and once a
/// second, motions once a second, and what is seen every five seconds.
inline constexpr std::size_t kManyPlayers = 16;
/// With more simulated time than this, summed over the players (s), all of that is kept so much
/// less often that it stays as large as here; and of other decisions ten where one would be kept
/// anyway.
inline constexpr double kManyPlayerSeconds = 60'000;

/// What a page says of a flight besides what was seen of it.
struct FlightFacts {
  std::string file, build, outcome;
  std::uint64_t seed = 0, hash = 0, steps = 0;
};
[[nodiscard]] FlightFacts facts_of(const debrief::Recorded& recorded);

/// Watches a flight and packs what the page shows of it, of a part as well as of the whole.
class Packer : public sim::Observer {
 public:
  /// What had happened in a run before this flight branches off at `world`, step by step: its
  /// story, and whose missiles are in the air. Before it observes anything.
  virtual void remember(const sim::World& world, const debrief::Happened& happened) = 0;
  /// To be called after each step, with its orders: the decisions in it.
  virtual void look(const sim::World& before, const sim::World& after,
                    std::span<const sim::Order> orders) = 0;
  /// What has been seen so far.
  [[nodiscard]] virtual std::string packed(const FlightFacts& facts) const = 0;
  /// What has been seen since the last take(), which is then forgotten, with where everybody is
  /// now: for a page that has the rest (viewer/src/live/grown.ts).
  [[nodiscard]] virtual std::string take(const FlightFacts& facts) = 0;
};
/// The scenario must outlive it; `until` (s) is when the flight ends at the latest. `plenty` is for
/// tests.
[[nodiscard]] std::unique_ptr<Packer> make_packer(const scenario::Scenario& scenario, double until,
                                                  double plenty = kManyPlayerSeconds);

/// A recorded run, flown again for a page without the engine, packed(). Empty if `progress` gave
/// up.
[[nodiscard]] std::string page_data(const debrief::Recorded& recorded,
                                    const Progress& progress = {},
                                    double plenty = kManyPlayerSeconds);

}  // namespace eyrie::page
