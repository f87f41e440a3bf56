// SPDX-License-Identifier: MIT
#include "campaign/ways.hpp"

#include "campaign/in_order.hpp"
#include "campaign/store.hpp"
#include "record/names.hpp"

namespace eyrie::campaign {
namespace {

class WayWatcher final : public sim::Observer {
 public:
  explicit WayWatcher(const scenario::Scenario& scenario) : scenario_(scenario) {
    for (const auto& player : scenario.roster.players)
      ways.push_back(
          {.player = player.name, .side = std::string(scenario::side_name(player.side))});
    last_.resize(ways.size());
  }
  void begin(const sim::World& world, double) override { look(world, true); }
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    const double now = info.time() + info.dt;
    const bool due = now >= next_;
    if (due)
      next_ += Way::kEvery;
    look(world, due);
    for (const sim::Event& e : events)
      if (const auto fate = record::fate_of(e);
          fate && fate->end == "lost" && scenario_.roster.find(fate->who))
        ways[fate->who.value - 1].lost = true;
  }
  void finish(const sim::World&) override {
    for (std::size_t i = 0; i < ways.size(); ++i)
      ways[i].places.push_back(last_[i]);
  }
  std::vector<Way> ways;

 private:
  void look(const sim::World& world, bool due) {
    scenario_.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
      const Vec3& p = fleet.motion(world, row).position;
      last_[id.value - 1] = {p.x, p.y};
      if (due)
        ways[id.value - 1].places.push_back(last_[id.value - 1]);
    });
  }

  const scenario::Scenario& scenario_;
  std::vector<std::array<double, 2>> last_;
  double next_ = Way::kEvery;
};

struct FlownWays {
  std::uint64_t hash = 0;
  std::vector<Way> ways;
};

}  // namespace

std::vector<Way> ways_flown(const std::string& folder, std::uint64_t count, unsigned workers,
                            const std::vector<std::string>& plugins,
                            const std::function<bool(std::uint64_t, std::uint64_t)>& tell) {
  Database database = open_results(folder);
  Again again(database, plugins, workers);
  const auto flights = again.flights("WHERE replicate < ?", static_cast<double>(count));
  std::vector<Way> all;
  in_order<FlownWays>(
      flights.size(), workers,
      [&](std::uint64_t i) {
        const auto scenario = again.scenario(flights[i].cell);
        WayWatcher watcher(*scenario);
        sim::Observer* const observer = &watcher;
        const std::uint64_t hash = fly(scenario, flights[i].seed, {&observer, 1}).hash;
        return FlownWays{hash, std::move(watcher.ways)};
      },
      [&](std::uint64_t i, FlownWays&& flown) {
        Again::demand_the_same(flights[i], flown.hash);
        for (Way& way : flown.ways) {
          way.cell = flights[i].cell;
          way.replicate = flights[i].replicate;
          all.push_back(std::move(way));
        }
        return tell(i + 1, flights.size());
      });
  return all;
}

}  // namespace eyrie::campaign
