// SPDX-License-Identifier: MIT
#include "campaign/again.hpp"

#include <filesystem>

#include "campaign/in_order.hpp"
#include "campaign/store.hpp"
#include "core/hash.hpp"
#include "debrief/decision.hpp"
#include "record/acmi.hpp"
#include "record/event_table.hpp"
#include "record/names.hpp"

namespace eyrie::campaign {

Again::Again(Database& database, const std::vector<std::string>& plugins, unsigned workers)
    : database_(database) {
  Statement origin = database.prepare("SELECT name, text FROM origin");
  while (origin.step())
    files_[origin.text(0)] = origin.text(1);
  spec_ = parse_spec(files_[kCampaignText], "campaign.yaml");
  cells_ = cells_of(spec_);
  file_ = std::filesystem::path(spec_.scenario).replace_extension(".yaml").filename();
  scenarios_.emplace(
      spec_, cells_,
      [this, plugins](const std::vector<std::string>& sets) {
        return scenario::load({.file = file_, .sets = sets, .plugins = plugins},
                              scenario::Source::bundle(files_));
      },
      workers + 1);
}

std::vector<std::vector<std::string>> Again::sets() const {
  std::vector<std::vector<std::string>> all;
  for (const Cell& cell : cells_)
    all.push_back(sets_of(spec_, cell));
  return all;
}

std::vector<Again::Flight> Again::flights(const std::string& which, double parameter) {
  Statement found =
      database_.prepare("SELECT cell, replicate, seed, hash FROM (SELECT * FROM replicates " +
                        which + ") WHERE outcome <> 'fault' ORDER BY cell, replicate");
  found.with(parameter);
  std::vector<Flight> all;
  while (found.step()) {
    const auto whole = [&](int i) { return static_cast<std::uint64_t>(found.integer(i)); };
    all.push_back({whole(0), whole(1), whole(2), found.text(3)});
    if (all.back().cell >= cells_.size())
      throw disk::Refused("the results are damaged: there is no cell {}", all.back().cell);
  }
  return all;
}

void Again::demand_the_same(const Flight& flight, std::uint64_t hash) {
  if (hash_text(hash) != flight.hash)
    throw disk::Refused(
        "cell {}, replicate {} ends otherwise than it did: the campaign was flown by "
        "another program",
        flight.cell, flight.replicate);
}

namespace {

class WayWatcher final : public sim::Observer {
 public:
  explicit WayWatcher(const scenario::Scenario& scenario) : scenario_(scenario) {
    for (const auto& player : scenario.roster.players)
      ways.push_back(
          {.player = player.name, .side = std::string(scenario::side_name(player.side))});
    poses_.resize(ways.size());
    last_.resize(ways.size());
  }
  void begin(const sim::World& world, double) override { look(world, 0, true); }
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    look(world, info.time_after(), (info.step + 1) % record::steps_in(2, info.dt) == 0);
    for (const sim::Event& e : events)
      if (const auto fate = record::fate_of(e);
          fate && fate->end == "lost" && scenario_.roster.find(fate->who))
        ways[fate->who.value - 1].lost = true;
  }
  void finish(const sim::World&) override {
    // less than a point of the screen where a map shows 10 nmi
    constexpr record::Tolerance kNear{.position = 30, .attitude = 1};
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (last_[i].time > poses_[i].back().time)
        poses_[i].push_back(last_[i]);
      std::vector<bool> kept(poses_[i].size());
      kept.front() = kept.back() = true;
      record::thin(poses_[i], kept, kNear);
      for (std::size_t k = 0; k < kept.size(); ++k)
        if (kept[k])
          ways[i].places.push_back({poses_[i][k].position.x, poses_[i][k].position.y});
    }
  }
  std::vector<Way> ways;

 private:
  void look(const sim::World& world, double now, bool due) {
    scenario_.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
      const Vec3& p = fleet.motion(world, row).position;
      last_[id.value - 1] = {.time = now, .position = {p.x, p.y, 0}};
      if (due)
        poses_[id.value - 1].push_back(last_[id.value - 1]);
    });
  }

  const scenario::Scenario& scenario_;
  std::vector<std::vector<record::Pose>> poses_;  ///< two seconds apart
  std::vector<record::Pose> last_;
};

constexpr const char* kLossTables = R"(
CREATE TABLE IF NOT EXISTS losses (cell INTEGER, replicate INTEGER, loss INTEGER, time_s REAL, player TEXT,
                                   side TEXT, by TEXT, PRIMARY KEY (cell, replicate, loss)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS decisions (cell INTEGER, replicate INTEGER, loss INTEGER, time_s REAL, before_s REAL,
                                      field TEXT, value TEXT, winner TEXT, blended INTEGER, rival TEXT,
                                      votes REAL, rival_votes REAL);
CREATE INDEX IF NOT EXISTS decisions_of ON decisions (cell, replicate, loss);
CREATE TABLE IF NOT EXISTS looked_at (cell INTEGER, replicate INTEGER, window_s REAL,
                                      PRIMARY KEY (cell, replicate)) WITHOUT ROWID;
)";

class Losses final : public sim::Observer {
 public:
  explicit Losses(const scenario::Roster& roster) : roster_(roster) {}
  void observe(const sim::World&, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    for (const sim::Event& e : events)
      if (const auto fate = record::fate_of(e);
          fate && fate->end == "lost" && roster_.find(fate->who))
        all.push_back({fate->who, e.whom ? e.who : PlayerId{}, info.time_after()});
  }
  std::vector<Loss> all;

 private:
  const scenario::Roster& roster_;
};

/// Leaves the database in one file again, which can be read without permission to write.
struct OneFile {
  Database& database;
  ~OneFile() { database.leave_one_file(); }
};

void note(const team::Decision& decision, std::size_t loss, std::vector<Contest>& contests) {
  const auto label = [&](ubf::NodeIndex node) {
    return node < decision.nodes.size() ? decision.nodes[node].label : std::string();
  };
  for (const team::Won& won : decision.action) {
    Contest contest{loss,           decision.time,     won.value.name,
                    won.value.text, label(won.winner), won.blended};
    if (won.rivals.empty())
      contests.push_back(contest);
    for (const team::Rival& rival : won.rivals) {
      contest.rival = label(rival.node);
      contest.votes = rival.against;
      contest.rival_votes = rival.vote;
      contests.push_back(contest);
    }
  }
}

}  // namespace

std::vector<Way> ways_flown(const std::string& folder, std::uint64_t count, unsigned workers,
                            const std::vector<std::string>& plugins,
                            const std::function<bool(std::uint64_t, std::uint64_t)>& tell) {
  Database database = open_results(folder);
  Again again(database, plugins, workers);
  const auto flights = again.flights("WHERE replicate < ?", static_cast<double>(count));
  std::vector<Way> all;
  using FlownWays = std::pair<std::uint64_t, std::vector<Way>>;  // with the hash of the last world
  in_order<FlownWays>(
      flights.size(), workers,
      [&](std::uint64_t i) {
        const auto scenario = again.scenario(flights[i].cell);
        WayWatcher watcher(*scenario);
        const std::uint64_t hash = fly(scenario, flights[i].seed, &watcher).hash;
        return FlownWays{hash, std::move(watcher.ways)};
      },
      [&](std::uint64_t i, FlownWays&& flown) {
        Again::demand_the_same(flights[i], flown.first);
        for (Way& way : flown.second) {
          way.cell = flights[i].cell;
          way.replicate = flights[i].replicate;
          all.push_back(std::move(way));
        }
        return tell(i + 1, flights.size());
      });
  return all;
}

LastDecisions last_decisions(const std::shared_ptr<const scenario::Scenario>& scenario,
                             std::uint64_t seed, double window) {
  Losses losses(scenario->roster);
  const std::uint64_t hash = fly(scenario, seed, &losses).hash;
  LastDecisions found{hash, std::move(losses.all), {}};
  if (found.losses.empty())
    return found;
  scenario::Mission again(scenario, seed);
  sim::World before = again.run().world();
  std::vector<std::size_t> near;
  do {
    for (const std::size_t i : near)
      if (const auto decision =
              debrief::explain(*scenario, before, again.run().world(), found.losses[i].who,
                               again.run().orders_for(before.step())))
        note(*decision, i, found.contests);
    near.clear();
    const double now = again.run().time();
    for (std::size_t i = 0; i < found.losses.size(); ++i)
      if (found.losses[i].time - window <= now && now < found.losses[i].time)
        near.push_back(i);
    if (!near.empty())
      before = again.run().world();
  } while (again.step());
  return found;
}

std::optional<LookedAt> looked_at(Database& database) {
  if (!database.prepare("SELECT 1 FROM sqlite_master WHERE name = 'looked_at'").step())
    return std::nullopt;
  Statement counted = database.prepare(
      "SELECT count(*), (SELECT count(*) FROM replicates WHERE outcome <> 'fault'), max(window_s) "
      "FROM looked_at WHERE window_s = (SELECT max(window_s) FROM looked_at)");
  counted.step();
  return LookedAt{static_cast<std::uint64_t>(counted.integer(0)),
                  static_cast<std::uint64_t>(counted.integer(1)), counted.number(2)};
}

void add_last_decisions(const std::string& folder, double window, unsigned workers,
                        const std::vector<std::string>& plugins,
                        const std::function<bool(std::uint64_t, std::uint64_t)>& tell) {
  {  // what refuses them leaves the file as it is
    Database there = open_results(folder);
    static_cast<void>(Again(there, plugins, workers).flights("WHERE ? IS NOT NULL", window));
  }
  const disk::Handle lock = lock_results(folder, true);
  Database database = open_results(folder, Database::Access::write);
  const OneFile one_file{database};
  Again again(database, plugins, workers);
  database.run(kLossTables);
  const std::vector<Again::Flight> asked = again.flights(
      "LEFT JOIN looked_at USING (cell, replicate) WHERE window_s IS NULL OR window_s < ?", window);
  Statement loss = database.prepare("INSERT INTO losses VALUES (?, ?, ?, ?, ?, ?, ?)");
  Statement decision =
      database.prepare("INSERT INTO decisions VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  Statement looked = database.prepare("INSERT OR REPLACE INTO looked_at VALUES (?, ?, ?)");
  Statement forget_losses = database.prepare("DELETE FROM losses WHERE cell = ? AND replicate = ?");
  Statement forget = database.prepare("DELETE FROM decisions WHERE cell = ? AND replicate = ?");
  in_order<LastDecisions>(
      asked.size(), workers,
      [&](std::uint64_t i) {
        return last_decisions(again.scenario(asked[i].cell), asked[i].seed, window);
      },
      [&](std::uint64_t i, LastDecisions&& found) {
        const Again::Flight& a = asked[i];
        Again::demand_the_same(a, found.hash);
        const auto scenario = again.scenario(a.cell);
        const scenario::Roster& roster = scenario->roster;
        database.run("BEGIN");
        forget_losses.with(a.cell, a.replicate).step();
        forget.with(a.cell, a.replicate).step();
        for (std::size_t l = 0; l < found.losses.size(); ++l) {
          const Loss& one = found.losses[l];
          loss.with(a.cell, a.replicate, l, one.time, roster.name(one.who),
                    scenario::side_name(roster.find(one.who)->side),
                    one.by ? roster.name(one.by) : std::string())
              .step();
        }
        for (const Contest& c : found.contests)
          decision
              .with(a.cell, a.replicate, c.loss, c.time, found.losses[c.loss].time - c.time,
                    c.field, c.value, c.winner, std::int64_t{c.blended}, c.rival,
                    static_cast<double>(c.votes), static_cast<double>(c.rival_votes))
              .step();
        looked.with(a.cell, a.replicate, window).step();
        database.run("COMMIT");
        return tell(i + 1, asked.size());
      });
}

}  // namespace eyrie::campaign
