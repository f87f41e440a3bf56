// SPDX-License-Identifier: MIT
#include "campaign/last_decisions.hpp"

#include "campaign/again.hpp"
#include "campaign/in_order.hpp"
#include "debrief/decision.hpp"
#include "record/names.hpp"

namespace eyrie::campaign {
namespace {

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
        all.push_back({fate->who, e.whom ? e.who : PlayerId{}, info.time() + info.dt});
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

LastDecisions last_decisions(const std::shared_ptr<const scenario::Scenario>& scenario,
                             std::uint64_t seed, double window) {
  Losses losses(scenario->roster);
  sim::Observer* const observer = &losses;
  const std::uint64_t hash = fly(scenario, seed, {&observer, 1}).hash;
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
