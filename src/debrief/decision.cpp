// SPDX-License-Identifier: MIT
#include "debrief/decision.hpp"

#include <fmt/ranges.h>

#include <iterator>

#include "core/text.hpp"
#include "model/weapon/systems.hpp"
#include "record/event_table.hpp"
#include "record/json_text.hpp"
#include "record/names.hpp"
#include "record/story.hpp"

namespace eyrie::debrief {
namespace {

template <class Visit>
void each_value(Decision& d, Visit visit) {
  for (Answer& answer : d.nodes)
    std::ranges::for_each(answer.action, visit);
  for (Won& won : d.action) {
    visit(won.value);
    for (Rival& rival : won.rivals)
      visit(rival.value);
  }
  std::ranges::for_each(d.state, visit);
  for (Perceived& one : d.perceived)
    std::ranges::for_each(one.values, visit);
}

/// "#3 (bogey1)": as the agent knows it, and who it really was.
std::string debrief_name(const Perceived& one, const scenario::Scenario& scenario,
                         const sim::World& world) {
  const std::string number = fmt::format("#{}", one.number);
  return one.truth ? number + " (" + record::name_in(scenario, world, one.truth) + ")" : number;
}

using Json = nlohmann::ordered_json;

constexpr std::size_t kWidth = 100;

/// With every text in it fit for a terminal: labels and names come from files and plug-ins.
Decision printable_copy(Decision d) {
  const auto make = [](std::string& text) { text = printable(text); };
  make(d.tree);
  for (Answer& answer : d.nodes)
    for (std::string* text :
         {&answer.label, &answer.type, &answer.path, &answer.document, &answer.why})
      make(*text);
  for (Perceived& one : d.perceived)
    for (std::string* text : {&one.kind, &one.name})
      make(*text);
  each_value(d, [&](Value& value) {
    for (std::string* text : {&value.name, &value.unit, &value.text})
      make(*text);
  });
  return d;
}

std::string joined(const std::vector<Value>& values) {
  std::vector<std::string> words;
  for (const Value& value : values)
    words.push_back(value.name + " " + value.text);
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Breaks after commas so that no line is longer than kWidth; further lines are indented.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::string out(indent, ' ');
  std::size_t column = indent, begin = 0;
  while (begin < text.size()) {
    const std::size_t comma = text.find(", ", begin);
    const std::size_t end = comma == std::string::npos ? text.size() : comma + 2;
    const std::size_t wide = columns(std::string_view(text).substr(begin, end - begin));
    if (column + wide > kWidth && column > indent) {
      out.erase(out.find_last_not_of(' ') + 1);
      out += "\n" + std::string(indent, ' ');
      column = indent;
    }
    out.append(text, begin, end - begin);
    column += wide;
    begin = end;
  }
  return out + "\n";
}

bool leads(const Decision& d, std::size_t node) {
  for (ubf::NodeIndex n = d.leader; n != ubf::kNone; n = d.nodes[n].parent)
    if (n == node)
      return true;
  return false;
}

void tree_text(const Decision& d, std::string& text) {
  std::size_t width = 0;
  for (const Answer& answer : d.nodes)
    if (answer.parent == ubf::kNone || d.nodes[answer.parent].asked)
      width = std::max(width, 2u * answer.depth + columns(answer.label));
  width = std::min<std::size_t>(width, 48);
  for (std::size_t i = 0; i < d.nodes.size(); ++i) {
    const Answer& answer = d.nodes[i];
    const bool hidden = answer.parent != ubf::kNone && !d.nodes[answer.parent].asked;
    if (hidden)  // below what was not asked nothing was
      continue;
    const std::string name = std::string(2u * answer.depth, ' ') + answer.label;
    // what a composite hands on is what some leaf below it said
    const std::string said =
        answer.is_leaf && !answer.action.empty() ? ": " + joined(answer.action) : "";
    fmt::format_to(std::back_inserter(text), "{} {:<{}}  {}{}\n", leads(d, i) ? '>' : ' ', name,
                   width, words(answer), said);
  }
}

void action_text(const Decision& d, std::string& text) {
  std::size_t width = 14;
  for (const Won& won : d.action)
    width = std::max(width, columns(won.value.text));
  for (const Won& won : d.action) {
    std::string rivals;
    for (const Rival& rival : won.rivals)
      if (rival.blended == won.blended)  // of a blend what it is made of
        rivals += fmt::format("{}{} {}", rivals.empty() ? " (" : ", ", d.nodes[rival.node].label,
                              rival.value.text);
    fmt::format_to(std::back_inserter(text), "  {:<12} {:<{}} {:<16} {}{}\n", won.value.name,
                   won.value.text, width, label_of(d, won.winner), reason(won),
                   rivals.empty() ? "" : rivals + ")");
    if (!won.undone.empty())
      fmt::format_to(std::back_inserter(text), "  {:<12} not done: {}\n", "", won.undone);
  }
}

Json value_json(const Value& value) {
  Json j{{"name", value.name}, {"text", value.text}};
  if (value.number)
    j["value"] = *value.number;
  if (!value.unit.empty())
    j["unit"] = value.unit;
  return j;
}
/// What `make` gives for each.
template <class T, class Make>
Json list_json(const std::vector<T>& all, Make make) {
  Json list = Json::array();
  for (const T& one : all)
    list.push_back(make(one));
  return list;
}
Json values_json(const std::vector<Value>& values) {
  return list_json(values, value_json);
}

Json answer_json(const Answer& answer) {
  Json j{{"path", answer.path},
         {"label", answer.label},
         {"type", answer.type},
         {"depth", answer.depth},
         {"asked", answer.asked}};
  if (!answer.document.empty())
    j["document"] = answer.document;
  if (!answer.asked)
    return j;
  j["status"] = ubf::to_text(answer.status);
  j["vote"] = answer.vote;
  if (!answer.why.empty())
    j["why"] = answer.why;
  if (answer.halts > 0)
    j["halts"] = answer.halts;
  j["action"] = values_json(answer.action);
  return j;
}

Json won_json(const Decision& d, const Won& won) {
  Json j = value_json(won.value);
  j["winner"] = won.winner == ubf::kNone ? Json() : Json(d.nodes[won.winner].path);
  j["reason"] = reason(won);
  if (!won.undone.empty())
    j["undone"] = won.undone;
  j["rivals"] = list_json(won.rivals, [&](const Rival& rival) -> Json {
    return {{"node", d.nodes[rival.node].path},
            {"value", value_json(rival.value)},
            {"vote", rival.vote},
            {"against", rival.against},
            {"blended", rival.blended}};
  });
  return j;
}

}  // namespace

void put_names(std::string& text, const Decision& decision, const scenario::Scenario& scenario) {
  constexpr std::string_view kStore = "store ";  // as pilot::Release is written
  if (text.starts_with(kStore))
    text.replace(0, text.find(' ', kStore.size()),
                 record::store_label(scenario, std::strtof(text.c_str() + kStore.size(), nullptr)));
  const std::size_t number = text.rfind('#');
  if (number == std::string::npos)
    return;
  for (const Perceived& one : decision.perceived)
    if ((one.kind == "target" || one.kind == "track") &&
        std::string_view(text).substr(number + 1) == std::to_string(one.number))
      text.replace(number, std::string::npos, one.name);
}

std::optional<Decision> explain(const scenario::Scenario& scenario, const sim::World& before,
                                const sim::World& after, PlayerId who,
                                std::span<const sim::Order> orders) {
  std::optional<Decision> decision;
  if (const auto found = scenario.find(before, who))
    found->fleet.agents->look_again(before, after, who, orders, [&](const team::AnyMoment& m) {
      decision = m.decision();
      if (const auto now = scenario.find(after, who))
        decision->attacks = now->fleet.gauges(after, now->row).locked;
      const auto row = after.row(scenario.aircraft.table, who);
      if (row && model::weapon::waits_for_lock(after, scenario.aircraft, *scenario.library, *row,
                                               decision->time))
        for (team::Won& won : decision->action)
          if (won.value.name == "release")
            won.undone = "its seeker is not locked on yet";
      for (Perceived& one : decision->perceived)
        one.name = debrief_name(one, scenario, before);
      each_value(*decision, [&](Value& value) { put_names(value.text, *decision, scenario); });
      for (Changed& field : decision->overruled)
        for (std::string* text : {&field.flown, &field.other})
          put_names(*text, *decision, scenario);
    });
  return decision;
}

std::string label_of(const Decision& decision, ubf::NodeIndex node) {
  return node < decision.nodes.size() ? decision.nodes[node].label : "nobody";
}

std::string branch_of(const Decision& decision, ubf::NodeIndex node) {
  if (node >= decision.nodes.size() || decision.nodes[node].parent == ubf::kNone)
    return label_of(decision, node);
  return label_of(decision, decision.nodes[node].parent) + "/" + label_of(decision, node);
}

std::string decision_text(const Decision& decision, const scenario::Roster& roster) {
  const Decision d = printable_copy(decision);
  std::string text = fmt::format("{} at {} (step {}), by tree {}: {} leads with {:g}\n",
                                 printable(roster.name(d.player)), record::clock_text(d.time),
                                 d.step, d.tree, label_of(d, d.leader), d.vote);
  if (d.leader < d.nodes.size() && !d.nodes[d.leader].document.empty())
    text += fmt::format("{} is {}\n", d.nodes[d.leader].path, d.nodes[d.leader].document);
  text += "\nsees\n";
  text += wrapped(joined(d.state), 2);
  for (const Perceived& one : d.perceived)
    text += wrapped(fmt::format("{} {}: {}", one.kind, one.name, joined(one.values)), 2);
  text += "\ntree\n";
  tree_text(d, text);
  text += "\naction\n";
  action_text(d, text);
  if (!d.overruled.empty())
    text += "\nfrom outside\n";
  for (const team::Changed& field : d.overruled)
    fmt::format_to(std::back_inserter(text), "  {:<12} {:<14} instead of {}\n", field.name,
                   field.other, field.flown);
  return text;
}

std::string decision_line(const Decision& decision) {
  const Decision d = printable_copy(decision);
  std::vector<Value> values;
  for (const Won& won : d.action)
    values.push_back(won.value);
  return fmt::format("{:>8}  {:<16} {:>5g}  {}\n", record::clock_text(d.time),
                     label_of(d, d.leader), d.vote, joined(values));
}

Json decision_json(const Decision& d, const scenario::Roster& roster) {
  Json j{{"time_s", d.time},
         {"step", d.step},
         {"player", roster.name(d.player)},
         {"tree", d.tree},
         {"status", ubf::to_text(d.status)},
         {"vote", d.vote},
         {"leader", d.leader == ubf::kNone ? Json() : Json(d.nodes[d.leader].path)}};
  j["action"] = list_json(d.action, [&](const Won& won) { return won_json(d, won); });
  if (!d.overruled.empty())
    j["overruled"] = list_json(d.overruled, [](const Changed& field) -> Json {
      return {{"name", field.name}, {"tree", field.flown}, {"outside", field.other}};
    });
  j["nodes"] = list_json(d.nodes, answer_json);
  j["state"] = values_json(d.state);
  j["perceived"] = list_json(d.perceived, [](const Perceived& one) -> Json {
    return {{"kind", one.kind}, {"name", one.name}, {"values", values_json(one.values)}};
  });
  return j;
}

std::string decision_csv(const Decision& d, const scenario::Roster& roster) {
  std::string text;
  const auto to = std::back_inserter(text);
  for (std::size_t i = 0; i < d.nodes.size(); ++i) {
    const Answer& node = d.nodes[i];
    if (!node.asked)
      continue;
    const std::string who =
        fmt::format("{:.3f},{},{},{},{},{},{:g}", d.time, d.step,
                    record::csv_text(roster.name(d.player)), record::csv_text(d.tree),
                    record::csv_text(node.path), ubf::to_text(node.status), node.vote);
    if (node.action.empty())
      fmt::format_to(to, "{},,,,\n", who);
    for (const Value& value : node.action) {
      const bool won = std::ranges::any_of(d.action, [&](const Won& w) {
        return w.value.name == value.name && w.winner == i && !w.held;
      });
      const std::string shown = value.number        ? fmt::format("{}", *value.number)
                                : value.text == "-" ? ""  // no value
                                                    : record::csv_quoted(value.text);
      fmt::format_to(to, "{},{},{},{},{}\n", who, record::csv_text(value.name), shown,
                     record::csv_text(value.unit), won ? 1 : 0);
    }
  }
  return text;
}

std::string change_text(const Change& change) {
  return fmt::format("{:>8}  {:<16} -> {:<16} {}\n", record::clock_text(change.now.time),
                     printable(change.from), printable(change.to), printable(change.why));
}

Json change_json(const Change& change, const scenario::Roster& roster) {
  return {{"from", change.from},
          {"to", change.to},
          {"why", change.why},
          {"decision", decision_json(change.now, roster)}};
}

}  // namespace eyrie::debrief
