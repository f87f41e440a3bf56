// SPDX-License-Identifier: MIT
#include "tables/schema.hpp"

#include <fmt/ranges.h>

#include "driver/state.hpp"
#include "pilot/action.hpp"
#include "sql/database.hpp"
#include "tables/track_rows.hpp"

namespace eyrie::tables {
namespace {

using Columns = std::vector<TableColumn>;

const TableColumn kPlayerId{"player_id", "INTEGER REFERENCES players", "", "whose"};

Columns with(Columns columns, const Columns& more) {
  columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

Columns event_columns() {
  Columns columns{{"event_id", "INTEGER PRIMARY KEY", "", "in the order in which they happened"}};
  for (const record::EventColumn& column : record::event_columns()) {
    const std::string name(column.name);
    const bool refers = name == "who_id" || name == "whom_id" || name == "missile_id";
    columns.push_back({name,
                       refers                  ? "INTEGER REFERENCES players"
                       : name == "step"        ? "INTEGER"
                       : column.format.empty() ? "TEXT"
                                               : "REAL",
                       std::string(record::unit_of(column)), std::string(column.help)});
  }
  return columns;
}

/// Columns of one type that are described elsewhere.
template <class Described>
Columns columns_of(const Described& described, const char* type) {
  Columns columns;
  for (const auto& column : described)
    columns.push_back(
        {std::string(column.name), type, std::string(column.unit), std::string(column.help)});
  return columns;
}

/// The fields of an action, or only its quantities; words stand as numbers of the table texts where
/// `coded`.
Columns action(std::span<const ActionColumn> columns, bool coded, bool only_real = false) {
  Columns all;
  for (const ActionColumn& c : columns)
    if (c.is_real || !only_real)
      all.push_back({c.column,
                     c.is_words && coded ? "INTEGER REFERENCES texts"
                     : c.is_real         ? "REAL"
                                         : "INTEGER",
                     c.unit, "what it asks for; empty: nothing"});
  return all;
}

std::string text_of(std::string_view column) {
  return fmt::format("(SELECT content FROM texts WHERE text_id = {})", column);
}

/// The action of `own`, or where `handed_on` of the leaf whose it hands on.
std::string action_query(std::span<const ActionColumn> columns, bool handed_on = true) {
  std::string text;
  for (const ActionColumn& c : columns) {
    const std::string name = sql::sql_name(c.column);
    std::string value = "own_form." + name;
    if (c.is_real)
      value = fmt::format("own.{}, {}", name, value);
    if (handed_on)
      value = fmt::format(
          fmt::runtime(c.is_real ? "leaf.{0}, leaf_form.{0}, {1}" : "leaf_form.{0}, {1}"), name,
          value);
    if (handed_on || c.is_real)
      value = fmt::format("coalesce({})", value);
    text += fmt::format(",\n  {} AS {}", c.is_words ? text_of(value) : value, name);
  }
  return text;
}

/// Joins the answer `name` of `node` at the step of `one`, with what it has in common with others.
/// A cross join is made in the order in which it is written.
std::string answer_at(std::string_view join, std::string_view name, std::string_view node) {
  return fmt::format(
      "{0} answer_spans {1} ON {1}.player_id = one.player_id AND {1}.node_id = {2}\n"
      "  AND {1}.from_step = (SELECT max(from_step) FROM answer_spans\n"
      "    WHERE player_id = one.player_id AND node_id = {2} AND from_step <= one.step)\n"
      "  AND {1}.from_step + {1}.more_steps >= one.step\n"
      "{0} answer_forms {1}_form ON {1}_form.form_id = {1}.form_id\n",
      join, name, node);
}

/// Every decision, from the intervals.
constexpr const char* kEach = R"(WITH RECURSIVE one(player_id, step, to_step, every_steps, root_id,
    leader_id, attacks_id) AS (
  SELECT player_id, from_step, to_step, every_steps, root_id, leader_id, attacks_id
    FROM decision_spans
  UNION ALL
  SELECT player_id, step + every_steps, to_step, every_steps, root_id, leader_id, attacks_id
    FROM one WHERE step < to_step)
)";

}  // namespace

std::vector<Table> tables_of(std::span<const ActionColumn> columns, double step) {
  std::vector<Table> all;
  all.push_back({"about",
                 "What the run is: a name and a text each.",
                 {{"item", "TEXT PRIMARY KEY", "", "`scenario`, `seed`, `step_s`, `outcome`, ..."},
                  {"content", "TEXT", "", "its value"}},
                 ") WITHOUT ROWID"});
  all.push_back({"units",
                 "What every column of every table and view holds.",
                 {{"table_name", "TEXT", "", "the table or view"},
                  {"column_name", "TEXT", "", "the column"},
                  {"unit", "TEXT", "", "of its numbers; empty: none"},
                  {"meaning", "TEXT", "", "what it holds"}},
                 ", PRIMARY KEY (table_name, column_name)) WITHOUT ROWID"});
  all.push_back({"texts",
                 "Words that stand in other tables as numbers.",
                 {{"text_id", "INTEGER PRIMARY KEY", "", "stands for it"},
                  {"content", "TEXT", "", "the words"}}});
  all.push_back({"players",
                 "Players and the missiles that they shot.",
                 {{"player_id", "INTEGER PRIMARY KEY", "", "as in every other table"},
                  {"name", "TEXT", "", "`eagle1`, `AIM-120 #7 of eagle1`"},
                  {"kind", "TEXT", "", "`aircraft`, `vehicle`, `missile`, ..."},
                  {"type", "TEXT", "", "`F-15C`"},
                  {"side", "TEXT", "", "`blue`, `red`, `none`"},
                  {"flight", "TEXT", "", "of a player; of a missile its shooter's"},
                  {"shooter_id", "INTEGER REFERENCES players", "", "of a missile"},
                  {"aimed_at_id", "INTEGER REFERENCES players", "", "of a missile: at its launch"},
                  {"born_s", "REAL", "s", "when it appeared"},
                  {"gone_s", "REAL", "s", "when it left the run; empty: it was there at the end"},
                  {"fate", "TEXT", "",
                   "how it left: `home`, `lost`; of a missile `kill`, `miss`, `trashed`"}}});
  all.push_back({"nodes",
                 "The nodes of the trees that decided, a tree in pre-order.",
                 {{"node_id", "INTEGER PRIMARY KEY", "", "of all trees together"},
                  {"root_id", "INTEGER REFERENCES nodes", "", "the root of its tree"},
                  {"parent_id", "INTEGER REFERENCES nodes", "", "empty: it is the root"},
                  {"tree", "TEXT", "", "name of the tree"},
                  {"label", "TEXT", "", "as the tree calls it"},
                  {"type", "TEXT", "", "its kind, as in docs/reference.md"},
                  {"path", "TEXT", "", "labels from the root, `root/bvr/pursue`"},
                  {"is_leaf", "INTEGER", "", "1: it has no children"}}});
  all.push_back({"events", "Everything that happened: docs/events.md.", event_columns()});
  all.push_back({"tracks",
                 "Where everybody was: players every second, missiles five times a second.",
                 with({kPlayerId}, columns_of(kTrackColumns, "REAL")),
                 ", PRIMARY KEY (player_id, time_s)) WITHOUT ROWID"});
  all.push_back({"decision_spans",
                 "Decisions in a row at one distance, of one tree and with one leader. The view "
                 "decisions has each of them.",
                 {kPlayerId,
                  {"from_step", "INTEGER", "", "of the first decision"},
                  {"to_step", "INTEGER", "", "of the last one"},
                  {"every_steps", "INTEGER", "", "from one to the next"},
                  {"root_id", "INTEGER REFERENCES nodes", "", "of the tree"},
                  {"leader_id", "INTEGER REFERENCES nodes", "", "who led; empty: nobody"},
                  {"attacks_id", "INTEGER REFERENCES players", "", "who the target really is"}},
                 ", PRIMARY KEY (player_id, from_step)) WITHOUT ROWID"});
  const Columns changing{
      {"why", "INTEGER REFERENCES texts", "", "it failed, or what its vote followed"},
      {"vote", "REAL", "", "0: none"}};
  all.push_back(
      {"answer_forms",
       "What answers have in common that differ only in what changes all the time. A value stands "
       "either here or in answer_spans.",
       with(with({{"form_id", "INTEGER PRIMARY KEY", "", "of the form"},
                  {"status", "INTEGER REFERENCES texts", "", "`running`, `success`, `failure`"},
                  {"halts", "INTEGER", "", "how often the node was made to forget"},
                  {"hands_on_id", "INTEGER REFERENCES nodes", "",
                   "the leaf whose whole action it hands on; its own fields are empty then"}},
                 changing),
            action(columns, true))});
  all.push_back(
      {"answer_spans",
       "Decisions in a row in which a node answered the same. The views answers and "
       "answer_intervals have them in words. A node that was not asked has no row.",
       with(with({kPlayerId,
                  {"node_id", "INTEGER REFERENCES nodes", "", "the node"},
                  {"from_step", "INTEGER", "", "of the first decision"},
                  {"more_steps", "INTEGER", "", "from the first to the last one"},
                  {"form_id", "INTEGER REFERENCES answer_forms", "", "all that is empty here"}},
                 changing),
            action(columns, true, true)),
       ", PRIMARY KEY (player_id, node_id, from_step)) WITHOUT ROWID"});

  const std::string time = fmt::format("one.step * {}", step);
  all.push_back({"decisions",
                 "Every decision with the action that its tree recommends; what somebody outside "
                 "asked for instead is told by the events order.",
                 with(columns_of(kDecisionColumns, ""), action(columns, false)), "",
                 fmt::format("{}SELECT {} AS time_s, one.step, p.name AS player, root.tree,\n"
                             "  {} AS status, coalesce(own.vote, own_form.vote) AS vote,\n  "
                             "lead_node.label AS leader, lead_node.path AS "
                             "leader_path, aim.name AS attacks{}\n"
                             "FROM one CROSS JOIN players p ON p.player_id = one.player_id\n"
                             "CROSS JOIN nodes root ON root.node_id = one.root_id\n"
                             "LEFT JOIN nodes lead_node ON lead_node.node_id = one.leader_id\n"
                             "LEFT JOIN players aim ON aim.player_id = one.attacks_id\n{}{}",
                             kEach, time, text_of("own_form.status"), action_query(columns),
                             answer_at("CROSS JOIN", "own", "one.root_id"),
                             answer_at("LEFT JOIN", "leaf", "own_form.hands_on_id"))});
  const Columns answer_columns{{"player", "", "", "whose decision"},
                               {"tree", "", "", "that decided"},
                               {"node", "", "", "path of the node in it"},
                               {"label", "", "", "of the node"},
                               {"status", "", "", "`running`, `success`, `failure`"},
                               {"vote", "", "", "0: none"},
                               {"halts", "", "", "how often it was made to forget"},
                               {"why", "", "", "it failed, or what its vote followed"}};
  const std::string answer = fmt::format(
      "p.name AS player, n.tree, n.path AS node, n.label,\n  {} AS status,\n"
      "  coalesce(own.vote, own_form.vote) AS vote, own_form.halts,\n  {} AS why",
      text_of("own_form.status"), text_of("coalesce(own.why, own_form.why)"));
  all.push_back({"answers", "Every node's answer to every decision in which it was asked.",
                 with(with({{"time_s", "", "s", "when"}, {"step", "", "", "of the simulation"}},
                           answer_columns),
                      action(columns, false)),
                 "",
                 fmt::format("{}SELECT {} AS time_s, one.step, {}{}\n"
                             "FROM one CROSS JOIN players p ON p.player_id = one.player_id\n"
                             "CROSS JOIN nodes n ON n.root_id = one.root_id\n{}{}",
                             kEach, time, answer, action_query(columns),
                             answer_at("CROSS JOIN", "own", "n.node_id"),
                             answer_at("LEFT JOIN", "leaf", "own_form.hands_on_id"))});
  all.push_back(
      {"answer_intervals", "The rows of answer_spans with names and times.",
       with({{"from_s", "", "s", "of the first decision"}, {"to_s", "", "s", "of the last one"}},
            with(with(answer_columns,
                      {{"hands_on", "", "", "path of the leaf whose whole action it hands on"}}),
                 action(columns, false))),
       "",
       fmt::format("SELECT own.from_step * {0} AS from_s,\n"
                   "  (own.from_step + own.more_steps) * {0} AS to_s, {1},\n"
                   "  hands_on.path AS hands_on{2}\n"
                   "FROM answer_spans own JOIN players p ON p.player_id = own.player_id\n"
                   "JOIN nodes n ON n.node_id = own.node_id\n"
                   "JOIN answer_forms own_form ON own_form.form_id = own.form_id\n"
                   "LEFT JOIN nodes hands_on ON hands_on.node_id = own_form.hands_on_id",
                   step, answer, action_query(columns, false))});
  return all;
}

std::string create(const Table& table) {
  if (!table.query.empty())
    return fmt::format("CREATE VIEW {} AS\n{}", table.name, table.query);
  std::vector<std::string> columns;
  for (const TableColumn& column : table.columns)
    columns.push_back(fmt::format("{} {}", sql::sql_name(column.name), column.type));
  return fmt::format("CREATE TABLE {} ({}{}", table.name, fmt::join(columns, ", "), table.keys);
}

std::string insert(const Table& table) {
  std::vector<std::string_view> values;
  for (const TableColumn& column : table.columns)
    values.push_back(column.type == "TEXT" ? "nullif(?, '')" : "?");
  return fmt::format("INSERT INTO {} VALUES ({})", table.name, fmt::join(values, ", "));
}

std::string tables_markdown() {
  std::vector<ActionColumn> columns;
  add_columns(ubf::action_fields<pilot::Action>(), columns);
  add_columns(ubf::action_fields<driver::Action>(), columns);
  std::string text =
      "# Tables of a run\n\n<!-- made by `eyrie catalog --tables`; a test compares them -->\n\n"
      "What `eyrie export RUN --to sqlite` writes into `run.sqlite`; [formats.md](formats.md) has "
      "queries. The file says the same in\nits table `units`. Plug-ins with players of other kinds "
      "add columns for the fields of their actions.\n";
  for (const Table& table : tables_of(columns, 0.02)) {
    text += fmt::format(
        "\n## {} `{}`\n\n{}\n\n| column | unit | what it holds |\n| --- | --- | --- |\n",
        table.query.empty() ? "Table" : "View", table.name, table.help);
    for (const TableColumn& column : table.columns)
      text += fmt::format("| `{}` | {} | {} |\n", column.name, column.unit, column.help);
  }
  return text;
}

}  // namespace eyrie::tables
