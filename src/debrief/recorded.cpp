// SPDX-License-Identifier: MIT
#include "debrief/recorded.hpp"

#include "core/assert.hpp"
#include "core/text.hpp"
#include "debrief/decision.hpp"
#include "record/event_table.hpp"
#include "record/story.hpp"
#include "scenario/mission.hpp"
#include "scenario/path.hpp"
#include "scenario/source.hpp"
#include "sim/difference.hpp"

namespace eyrie::debrief {
namespace {

/// What the file says of its flight and no flight of its scenario can have: more time than any,
/// other orders.
std::vector<std::string> false_claims(const record::RunFile& run,
                                      const scenario::Scenario& scenario) {
  const sim::Simulation& simulation = *scenario.simulation;
  // more than anybody gives, whoever flies all players by hand
  constexpr std::uint64_t kOrdersPerStep = 16;
  const std::uint64_t most =
      kOrdersPerStep * (run.trail.last_step + 1) * scenario.roster.players.size();
  // what is heard of another program's missiles are orders, too
  const bool hears =
      std::ranges::any_of(scenario.roster.players, &scenario::Roster::Player::remote);
  std::vector<std::string> problems;
  if (static_cast<double>(run.trail.last_step) * simulation.dt() > scenario::kLongestFlight)
    problems.push_back(fmt::format("it claims {} steps, more than a run can have: {} s",
                                   run.trail.last_step, scenario::kLongestFlight));
  else if (run.orders.size() > most)
    problems.push_back(
        fmt::format("it claims {} orders, more than the {} that its players take in "
                    "its steps",
                    run.orders.size(), most));
  if (!problems.empty())
    return problems;
  const sim::Order* last = nullptr;
  for (const sim::Order& order : run.orders) {
    if (simulation.handler(order.kind) == nullptr)
      problems.push_back(
          fmt::format("nobody in its scenario accepts orders of kind {}", order.kind.value));
    else if (!hears && !scenario.roster.find(order.player))
      problems.push_back(fmt::format("nobody in its scenario is player {}", order.player.value));
    else if (last && order.step < last->step)
      problems.push_back(fmt::format("its orders for the steps {} and {} stand the wrong way round",
                                     last->step, order.step));
    if (!problems.empty())
      break;
    last = &order;
  }
  return problems;
}

/// The players, fleet by fleet and by id, who ask for something else.
std::vector<PlayerId> ask_otherwise(const scenario::Scenario& s, const sim::World& a,
                                    const sim::World& b) {
  std::vector<PlayerId> all;
  for (const auto& fleet : s.fleets)
    for (std::uint32_t i = 0; i < fleet->rows(a); ++i) {
      const PlayerId who = fleet->id(a, i);
      const auto j = fleet->row(b, who);
      if (j && !fleet->agents->want_alike(a, i, b, *j))
        all.push_back(who);
    }
  return all;
}

std::string leader_of(const scenario::Scenario& s, const sim::World& world, PlayerId who) {
  const auto found = s.find(world, who);
  return found ? found->fleet.leader(world, found->row) : "nobody";
}

/// Two values of that name, with as many decimals as tell them apart.
std::pair<std::string, std::string> apart(std::string_view name, Dimension dimension, double a,
                                          double b) {
  constexpr int kMost = 17;
  const auto unit = [](const std::string& text) { return text.substr(text.rfind(' ') + 1); };
  for (int more = 0;; ++more) {
    std::pair texts{team::number_text(name, dimension, a, more),
                    team::number_text(name, dimension, b, more)};
    if (dimension == Dimension::length && unit(texts.first) != unit(texts.second))
      texts = {format_range(a, more), format_range(b, more)};
    if (texts.first != texts.second || more == kMost)
      return texts;
  }
}

/// "pursue leads, heading 277°" as both have it: the leader, and the fields that are not the
/// same.
std::pair<std::string, std::string> wants_text(const Reflight& a, const Reflight& b,
                                               const Recorded& left, const Recorded& right,
                                               PlayerId who) {
  const auto decided = [&](const Reflight& flight, const Recorded& recorded) {
    return explain(*recorded.scenario, flight.before(), flight.after(), who, flight.orders());
  };
  std::string one = leader_of(*left.scenario, a.after(), who) + " leads",
              other = leader_of(*right.scenario, b.after(), who) + " leads";
  const auto mine = decided(a, left), its = decided(b, right);
  if (!mine || !its)
    return {one, other};
  const auto field = [](const Decision& decision, std::string_view name) -> const Value* {
    for (const Won& won : decision.action)
      if (won.value.name == name)
        return &won.value;
    return nullptr;
  };
  std::vector<std::string> names;
  for (const Decision* decision : {&*mine, &*its})
    for (const Won& won : decision->action)
      if (std::ranges::find(names, won.value.name) == names.end())
        names.push_back(won.value.name);
  for (const bool exact : {false, true}) {  // to the digit if all are the same for people
    const std::string before = one + other;
    for (const std::string& name : names) {
      const Value *x = field(*mine, name), *y = field(*its, name);
      if (x && y && (exact ? x->number == y->number : x->text == y->text))
        continue;
      std::pair texts{x ? x->text : "", y ? y->text : ""};
      if (exact && x && y && x->number && y->number) {
        const UnitInfo* unit = find_unit(x->unit);
        texts = apart(name, unit ? unit->dimension : Dimension::none, *x->number, *y->number);
      }
      one += x ? fmt::format(", {} {}", name, texts.first) : ", no " + name;
      other += y ? fmt::format(", {} {}", name, texts.second) : ", no " + name;
    }
    if (one + other != before || one != other)
      break;
  }
  return {one, other};
}

/// Of two events that are not the same, what each is in its scenario; null: there is none.
std::pair<std::string, std::string> event_texts(const sim::Event* x, const sim::Event* y,
                                                const scenario::Scenario& left,
                                                const scenario::Scenario& right) {
  const auto named = [](const sim::Event& e, const scenario::Scenario& scenario) {
    return fmt::format("{} {}{}", scenario.roster.name(e.who),
                       model::event_name(record::kind_of(e)),
                       e.whom ? " " + scenario.roster.name(e.whom) : "");
  };
  std::string one = x ? named(*x, left) : "nothing", other = y ? named(*y, right) : "nothing";
  if (one != other)
    return {one, other};
  const auto compare = [&](std::string_view name, Dimension dimension, double mine, double its) {
    if (mine != its && !(std::isnan(mine) && std::isnan(its))) {
      const auto [a, b] = apart(name, dimension, mine, its);
      one += fmt::format(", {} {}", name, a);
      other += fmt::format(", {} {}", name, b);
    }
  };
  const record::EventTable left_table(left), right_table(right);
  const auto values = model::event_values(record::kind_of(*x));
  for (std::size_t i = 0; i < x->values.size(); ++i) {
    const model::EventValue what = i < values.size() ? values[i] : model::EventValue{"value"};
    const auto word = [&](const sim::Event& e, const record::EventTable& table) {
      const record::Cell cell = table.value(e, what, e.values[i]);
      return std::holds_alternative<std::string>(cell) ? std::get<std::string>(cell) : "";
    };
    if (const std::string a = word(*x, left_table), b = word(*y, right_table); a != b) {
      one += fmt::format(", {} {}", what.name, a);
      other += fmt::format(", {} {}", what.name, b);
    } else {
      compare(what.name, what.unit.dimension, x->values[i], y->values[i]);
    }
  }
  compare("detail", Dimension::none, x->detail, y->detail);
  const ubf::AnyTree *mine = record::tree_of(left, *x), *its = record::tree_of(right, *y);
  if (std::ranges::none_of(values, &model::EventValue::is_of_tree) || !mine || !its) {
    compare("aux", Dimension::none, x->aux, y->aux);
  } else if (mine->name() != its->name()) {
    one += fmt::format(", tree '{}'", mine->name());
    other += fmt::format(", tree '{}'", its->name());
  }
  compare("x", Dimension::length, x->place.x, y->place.x);
  compare("y", Dimension::length, x->place.y, y->place.y);
  compare("z", Dimension::length, x->place.z, y->place.z);
  return {one, other};
}

/// The first event that is not the same, as both have it.
std::optional<std::string> other_event(const Reflight& a, const Reflight& b,
                                       const scenario::Scenario& its,
                                       const scenario::Scenario& others) {
  const auto left = a.events(), right = b.events();
  const auto same = [](const sim::Event& x, const sim::Event& y) {
    return std::memcmp(&x, &y, sizeof x) == 0;
  };
  const std::size_t shared = std::min(left.size(), right.size());
  for (std::size_t i = 0; i <= shared; ++i)
    if (i < shared ? !same(left[i], right[i]) : left.size() != right.size()) {
      const auto [one, other] = event_texts(i < left.size() ? &left[i] : nullptr,
                                            i < right.size() ? &right[i] : nullptr, its, others);
      if (one != other)
        return fmt::format("{}; and {} in the other", one, other);
    }
  return std::nullopt;
}

}  // namespace

Opened open(record::RunFile run, std::string file, std::vector<std::string> plugins,
            std::string_view build, const scenario::AddNodes& add) {
  if (!run.files.contains(run.scenario))
    return {std::nullopt,
            {fmt::format("it is corrupt: its scenario {} is not in it", quote_path(run.scenario))}};
  Recorded recorded{std::move(file), std::move(run), std::move(plugins), nullptr, add};
  try {
    recorded.scenario = with_overrides(recorded, {});
  } catch (const ConfigError& e) {
    if (recorded.run.build == build)
      return {std::nullopt,
              {"the scenario inside needs what is not here, such as a behavior of "
               "Python (behaviors=):\n" +
               e.diagnostics().text()}};
    return {std::nullopt,
            {fmt::format("recorded by {}; {} refuses the scenario inside:\n{}",
                         printable(recorded.run.build), build, e.diagnostics().text())}};
  }
  const auto& scenario = *recorded.scenario;
  if (scenario.simulation->schema().layout_hash() != recorded.run.layout_hash)
    return {std::nullopt,
            {fmt::format("recorded by {}, whose world has another layout than that of {}; fly it "
                         "again with that build",
                         printable(recorded.run.build), build)}};
  if (auto problems = false_claims(recorded.run, scenario); !problems.empty())
    return {std::nullopt, std::move(problems)};
  return {std::move(recorded), {}};
}

std::shared_ptr<const scenario::Scenario> with_overrides(
    const Recorded& recorded, const std::vector<std::string>& sets,
    std::vector<scenario::TreeChange> changes) {
  std::vector<std::string> all = recorded.run.sets;
  all.insert(all.end(), sets.begin(), sets.end());
  return scenario::load({.file = recorded.run.scenario,
                         .sets = std::move(all),
                         .plugins = recorded.plugins,
                         .changes = std::move(changes),
                         .add = recorded.add},
                        scenario::Source::bundle(recorded.run.files));
}

std::map<std::string, std::string> tree_paths(const Recorded& recorded) {
  Diagnostics none;  // open() has read the same
  scenario::Source source = scenario::Source::bundle(recorded.run.files);
  eyrie::Value document = scenario::load_document(recorded.run.scenario, source, none);
  scenario::apply_overrides(document, recorded.run.sets, none);
  std::map<std::string, std::string> paths;
  if (const eyrie::Value* trees = document.find("trees"))
    scenario::paths_below(*trees, "trees", paths);
  return paths;
}

Past past_at(const Recorded& recorded, std::uint64_t step) {
  Reflight flight(recorded);
  std::vector<Happened> events;
  while (flight.after().step() < step && flight.step())
    if (!flight.events().empty())
      events.push_back(flight.happened());
  return {flight.after(), std::move(events)};
}

Reflight::Reflight(const Recorded& recorded, sim::World from)
    : recorded_(recorded),
      run_(recorded.scenario->simulation, std::move(from)),
      before_(run_.world()) {
  for (const sim::Order& order : recorded.run.orders)
    if (order.step >= before_.step())
      EYRIE_DEMAND(run_.submit(order).empty(), "open() refuses such orders");
}

Reflight::Reflight(const Recorded& recorded)
    : Reflight(recorded, recorded.scenario->world(recorded.run.seed)) {
  run_.attach(checker_.emplace(recorded.run.trail));
}

Happened Reflight::happened() const {
  return {{before_.step(), recorded_.run.seed, run_.simulation().dt()},
          {events_.begin(), events_.end()}};
}

bool Reflight::step() {
  demand_the_same();  // also as it began
  if (run_.world().step() >= recorded_.last_step())
    return false;
  before_.become(run_.world());
  events_ = run_.step();
  if (const sim::Fault* fault = run_.fault())
    throw std::runtime_error(fmt::format(
        "{}: it cannot be flown again: {}", recorded_.file,
        scenario::fault_text(*fault, recorded_.scenario->roster, run_.simulation().dt())));
  demand_the_same();
  return true;
}

void Reflight::demand_the_same() {
  if (!checker_ || !checker_->departure())
    return;
  // up to the next mark, which knows the field
  while (!checker_->done() && !run_.fault() && run_.world().step() < recorded_.last_step())
    run_.step();
  throw std::runtime_error(fmt::format(
      "{}: this is not the run that was recorded by {}: {}{}", recorded_.file, recorded_.run.build,
      checker_->departure()->reason,
      recorded_.scenario->has_foreign_nodes
          ? "; a behavior of one's own must answer the same whenever it perceives and remembers "
            "the same: nothing kept beside its memory, no clock, no chance but draw()"
          : ""));
}

std::optional<RunDifference> compare(const Recorded& left, const Recorded& right,
                                     std::string& problem) {
  const scenario::Scenario& scenario = *left.scenario;
  if (!sim::same_but_for_bytes(scenario.simulation->schema(),
                               right.scenario->simulation->schema())) {
    problem = fmt::format("{} and {} have worlds of other tables: other kinds of players",
                          left.file, right.file);
    return std::nullopt;
  }
  const double steps = scenario.simulation->dt(), its_steps = right.scenario->simulation->dt();
  if (steps != its_steps) {
    problem = fmt::format("{} has steps of {:.4g} ms and {} of {:.4g} ms: they cannot be compared",
                          left.file, steps * 1e3, right.file, its_steps * 1e3);
    return std::nullopt;
  }
  const scenario::Roster &mine = scenario.roster, &its = right.scenario->roster;
  for (PlayerId who{1}; mine.find(who) || its.find(who); ++who.value)
    if (mine.name(who) != its.name(who)) {
      problem = fmt::format("{} and {} have other players: {} is {} in the other", left.file,
                            right.file, mine.name(who), its.name(who));
      return std::nullopt;
    }
  RunDifference found;
  if (left.run.layout_hash != right.run.layout_hash)
    found.world = {0, 0, "the trees of one remember more than those of the other"};
  Reflight a(left), b(right);
  const auto part = [&](std::optional<Parting>& place, std::string text) {
    place = {a.before().step(), a.time(), std::move(text)};
  };
  while (!(found.world && found.action && found.event)) {
    const bool more_left = a.step(), more_right = b.step();
    if (more_left != more_right) {
      const std::string text =
          fmt::format("{} is over, the other goes on", more_left ? right.file : left.file);
      for (auto* place : {&found.world, &found.action, &found.event})
        if (!*place)
          part(*place, text);
      break;
    }
    if (!more_left)
      break;
    ++found.steps;
    if (!found.action)
      for (const PlayerId who : ask_otherwise(scenario, a.after(), b.after()))
        if (const auto [one, other] = wants_text(a, b, left, right, who);
            one != other && !found.action)  // the same: nobody has decided anything yet
          part(found.action,
               fmt::format("{}: {}; and {} in the other", scenario.roster.name(who), one, other));
    const double end = a.time() + scenario.simulation->dt();
    if (!found.event)
      if (const auto text = other_event(a, b, scenario, *right.scenario))
        found.event = {a.before().step(), end, *text};
    if (!found.world && a.after().hash() != b.after().hash())
      if (const auto difference = sim::first_difference(a.after(), b.after()))
        found.world = {a.after().step(), end, difference->text()};
  }
  return found;
}

}  // namespace eyrie::debrief
