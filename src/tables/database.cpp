// SPDX-License-Identifier: MIT

#include "sql/database.hpp"
#include "core/text.hpp"
#include "tables/schema.hpp"
#include "tables/track_rows.hpp"

namespace eyrie::tables {
namespace {

constexpr double kNull = math::kNaN;

/// A number of a player, or NULL for nobody.
double id_of(PlayerId id) {
  return id ? id.value : kNull;
}

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

double scale_of(int decimals) {
  double scale = 1;
  while (decimals-- > 0)
    scale *= 10;
  return scale;
}

class Writer final : public sim::Observer {
 public:
  explicit Writer(const debrief::Recorded& recorded)
      : recorded_(recorded),
        scenario_(*recorded.scenario),
        columns_(action_columns(scenario_)),
        events_(scenario_),
        missiles_(scenario_),
        database_(":memory:", sql::Database::Access::create) {
    database_.run(
        "PRAGMA temp_store=MEMORY; PRAGMA foreign_keys=OFF; PRAGMA user_version=1; BEGIN");
    const double dt = scenario_.simulation->dt();
    const std::vector<Table> tables = tables_of(columns_, dt);
    for (const Table& table : tables) {
      database_.run(create(table));
      if (table.query.empty())
        into_.emplace(table.name, database_.prepare(insert(table)));
    }
    for (const Table& table : tables)
      for (const auto& [column, type, unit, help] : table.columns)
        into("units").with(table.name, column, unit, help).step();
  }

  [[nodiscard]] const std::vector<ActionColumn>& columns() const { return columns_; }

  void begin(const sim::World& world, double) override {
    for (std::uint32_t id = 1; id <= scenario_.roster.players.size(); ++id)
      ends_[id] = {};
    look(world);
  }
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override {
    const double time = info.time_after();
    for (const sim::Event& e : events) {
      put_event(e, info);
      missiles_.note(e);
      if (record::kind_of(e) == model::EventKind::launch)
        ends_[e.who.value].born = time;
      const auto fate = record::fate_of(e);
      if (End* const end =
              fate && ends_.contains(fate->who.value) ? &ends_[fate->who.value] : nullptr;
          end && end->fate.empty()) {
        end->fate = fate->end;
        end->gone = time;
      }
    }
    look(world);
  }
  void decide(const debrief::Decision& d);
  std::string bytes();

 private:
  struct End {
    double born = 0, gone = kNull;
    std::string fate;
  };
  /// Decisions at one distance.
  struct Span {
    std::uint64_t from = 0, to = 0, every = 0;
    std::int64_t root = 0;
    double leader = kNull, attacks = kNull;
    Answers answers;  ///< to the last one
  };
  using Key = std::pair<std::uint32_t, std::int64_t>;  // player, node
  /// For how many intervals a value has been the same.
  struct Steady {
    double value = kNull;
    std::uint32_t intervals = 0;
  };

  sql::Statement& into(const char* table) { return into_.at(table); }
  std::int64_t text(const std::string& words);
  std::int64_t first_node(const debrief::Decision& d);
  void put_event(const sim::Event& e, const sim::StepInfo& info);
  void put_span(PlayerId who, const Span& span);
  void put_answer(const Key& key, const Intervals<Key, AnswerRow>::Interval& interval);
  void put_players();
  void look(const sim::World& world);

  const debrief::Recorded& recorded_;
  const scenario::Scenario& scenario_;
  std::vector<ActionColumn> columns_;
  record::EventTable events_;
  record::Missiles missiles_;
  sql::Database database_;
  std::map<std::string, sql::Statement, std::less<>> into_;
  std::int64_t event_count_ = 0, node_count_ = 0;
  std::map<std::string, std::int64_t> texts_;
  std::map<std::pair<std::uint8_t, std::string>, std::int64_t> trees_;  ///< by fleet and name
  std::map<std::int64_t, std::int64_t> roots_;                          ///< by node
  std::map<Key, std::vector<Steady>> steady_;
  std::map<std::vector<double>, std::int64_t> forms_;
  std::map<std::uint32_t, End> ends_;
  std::map<PlayerId, Span> spans_;
  Intervals<Key, AnswerRow> answers_;
};

std::int64_t Writer::text(const std::string& words) {
  const auto [at, is_new] = texts_.try_emplace(words, static_cast<std::int64_t>(texts_.size()) + 1);
  if (is_new)
    into("texts").with(at->second, printable(words)).step();
  return at->second;
}

/// The number of the root of the tree that decided.
std::int64_t Writer::first_node(const debrief::Decision& d) {
  const auto [at, is_new] =
      trees_.try_emplace({scenario_.roster.find(d.player)->fleet, d.tree}, node_count_ + 1);
  if (!is_new)
    return at->second;
  for (const debrief::Answer& node : d.nodes) {
    const double parent =
        node.parent == ubf::kNone ? kNull : static_cast<double>(at->second + node.parent);
    roots_[node_count_ + 1] = at->second;
    into("nodes")
        .with(++node_count_, at->second, parent, printable(d.tree), printable(node.label),
              printable(node.type), printable(node.path), std::int64_t{node.is_leaf})
        .step();
  }
  return at->second;
}

void Writer::put_event(const sim::Event& e, const sim::StepInfo& info) {
  sql::Statement& row = into("events");
  row.with(++event_count_);
  int index = 1;
  for (const Cell& cell : events_.row(e, info))
    if (++index; const auto* words = std::get_if<std::string>(&cell))
      row.bind(index, printable(*words));
    else
      row.bind(index, cell == Cell() ? kNull : std::get<double>(cell));
  row.step();
}

void Writer::put_span(PlayerId who, const Span& s) {
  into("decision_spans")
      .with(std::int64_t{who.value}, s.from, s.to, std::max<std::uint64_t>(s.every, 1), s.root,
            s.leader, s.attacks)
      .step();
}

/// What has stayed the same for some intervals goes into the form.
void Writer::put_answer(const Key& key, const Intervals<Key, AnswerRow>::Interval& interval) {
  const auto& [from, to, answer] = interval;
  constexpr std::uint32_t kSome = 3;
  const auto number = [&](const std::string& words) {
    return words.empty() ? kNull : static_cast<double>(text(words));
  };
  std::vector<double> form{number(answer.status), static_cast<double>(answer.halts),
                           answer.hands_on == ubf::kNone
                               ? kNull
                               : static_cast<double>(roots_.at(key.second) + answer.hands_on)};
  std::vector<double> row;
  std::vector<Steady>& steady = steady_[key];
  steady.resize(2 + columns_.size());
  const auto put = [&](double value, Steady& before) {
    before.intervals = same(before.value, value) ? before.intervals + 1 : 0;
    before.value = value;
    const bool stays = before.intervals >= kSome;
    form.push_back(stays ? value : kNull);
    row.push_back(stays ? kNull : value);
  };
  put(number(answer.why), steady[0]);
  put(answer.vote, steady[1]);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Cell& cell = answer.action[i];
    const auto* words = std::get_if<std::string>(&cell);
    const double value = words ? number(*words) : cell == Cell() ? kNull : std::get<double>(cell);
    if (columns_[i].is_real)
      put(value, steady[2 + i]);
    else
      form.push_back(value);
  }
  for (double& value : form)  // NaN is not equal to itself
    if (std::isnan(value))
      value = std::numeric_limits<double>::infinity();
  const auto [at, is_new] = forms_.try_emplace(form, static_cast<std::int64_t>(forms_.size()) + 1);
  if (is_new) {
    sql::Statement& into_forms = into("answer_forms");
    into_forms.with(at->second);
    for (int index = 1; const double value : form)
      into_forms.bind(++index, std::isinf(value) ? kNull : value);
    into_forms.step();
  }
  sql::Statement& into_spans = into("answer_spans");
  into_spans.with(std::int64_t{key.first}, key.second, from, to - from, at->second);
  for (int index = 5; const double value : row)
    into_spans.bind(++index, value);
  into_spans.step();
}

void Writer::decide(const debrief::Decision& d) {
  const std::int64_t root = first_node(d);
  const double leader = d.leader == ubf::kNone ? kNull : static_cast<double>(root + d.leader);
  const double attacks = id_of(d.attacks);
  const auto [at, is_new] = spans_.try_emplace(d.player, Span{});
  Span& span = at->second;
  const std::uint64_t before = span.to;
  Answers answers = answers_of(d, columns_, !is_new && span.root == root ? &span.answers : nullptr);
  for (std::size_t i = 0; i < answers.size(); ++i)
    if (answers[i])
      answers_.see({d.player.value, root + static_cast<std::int64_t>(i)}, before, d.step,
                   *answers[i], [&](const auto&... answer) { put_answer(answer...); });
  const std::uint64_t every = d.step - before;
  if (!is_new && span.root == root && same(span.leader, leader) && same(span.attacks, attacks) &&
      (span.every == 0 || span.every == every)) {
    span.every = every;
    span.to = d.step;
    span.answers = std::move(answers);
    return;
  }
  if (!is_new)
    put_span(d.player, span);
  span = {d.step, d.step, 0, root, leader, attacks, std::move(answers)};
}

void Writer::look(const sim::World& world) {
  each_track(scenario_, world, {}, [&](PlayerId id, const TrackRow& values) {
    sql::Statement& row = into("tracks");
    row.with(std::int64_t{id.value});
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double scale = scale_of(kTrackColumns[i].decimals);
      row.bind(static_cast<int>(i + 2), std::round(values[i] * scale) / scale);
    }
    row.step();
  });
}

void Writer::put_players() {
  for (const auto& [number, end] : ends_) {
    const PlayerId id{number};
    const record::Missiles::Missile* missile = missiles_.find(id);
    const auto* player = scenario_.roster.find(missile ? missile->shooter : id);
    if (!player)
      continue;
    into("players")
        .with(std::int64_t{number}, printable(missiles_.name(id)),
              missile ? std::string("missile")
                      : printable(scenario_.fleets[player->fleet]->words.name),
              printable(missile ? missile->label : player->label),
              scenario::side_name(player->side),
              printable(scenario_.roster.flights[player->flight].name),
              missile ? id_of(missile->shooter) : kNull, missile ? id_of(missile->target) : kNull,
              end.born, end.gone, end.fate)
        .step();
  }
}

std::string Writer::bytes() {
  for (const auto& [who, span] : spans_)
    put_span(who, span);
  answers_.finish([&](const auto&... answer) { put_answer(answer...); });
  put_players();
  const record::RunFile& run = recorded_.run;
  const std::map<std::string, std::string> about{
      {"scenario", scenario_.spec.name},
      {"scenario_file", run.scenario},
      {"seed", fmt::format("{}", run.seed)},
      {"recorded_by", run.build},
      {"outcome", run.outcome},
      {"step_s", fmt::format("{}", scenario_.simulation->dt())},
      {"until_s", fmt::format("{}", recorded_.until())},
      {"begins_at", "2026-01-01T12:00:00Z"}};
  for (const auto& [item, content] : about)
    into("about").with(item, printable(content)).step();
  into_.clear();
  database_.run("COMMIT; VACUUM");
  return database_.bytes();
}

}  // namespace

std::optional<std::string> run_database(const debrief::Recorded& recorded,
                                        const Selection& selection,
                                        const std::function<bool()>& stop) {
  Writer writer(recorded);
  debrief::Reflight flight(recorded);
  flight.attach(writer);
  Chooser chooser(selection, writer.columns());
  if (!each_decision(flight, *recorded.scenario, chooser, stop,
                     [&](const debrief::Decision& d) { writer.decide(d); }))
    return std::nullopt;
  return writer.bytes();
}

}  // namespace eyrie::tables
