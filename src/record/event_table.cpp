// SPDX-License-Identifier: MIT
#include "record/event_table.hpp"

#include <iterator>

#include "core/angle.hpp"
#include "core/text.hpp"
#include "model/command.hpp"
#include "model/emission.hpp"
#include "model/weapon/missile.hpp"

namespace eyrie::record {
namespace {
using model::EventCode;

constexpr std::size_t kFixed = 15;

/// Where the column of a value stands.
std::size_t place_of(std::string_view column) {
  const auto& all = event_columns();
  return static_cast<std::size_t>(std::ranges::find(all, column, &EventColumn::name) - all.begin());
}

Cell cell_of(std::string text) {
  return text.empty() ? Cell() : Cell(std::move(text));
}
template <class Enum>
Cell word(float number) {
  return std::string(enum_name(static_cast<Enum>(static_cast<int>(number))));
}

Cell source_words(float number) {
  constexpr std::array kNames{"radar", "eyes", "datalink", "truth", "infrared"};
  std::string text;
  for (std::size_t bit = 0; bit < kNames.size(); ++bit)
    if (static_cast<unsigned>(number) >> bit & 1U)
      text += (text.empty() ? "" : " ") + std::string(kNames[bit]);
  return cell_of(text);
}

Cell defense_word(float number) {
  constexpr std::array kNames{"turn_in", "break", "notch", "drag", "last_ditch", "out"};
  const auto i = static_cast<std::size_t>(std::max(number, 1.0F)) - 1;
  return std::string(kNames[std::min(i, kNames.size() - 1)]);
}

/// who and whom as the names of columns.
std::string marked(std::string_view help) {
  std::string text;
  while (!help.empty()) {
    const std::size_t end = std::min(help.find_first_of(" .,:;"), help.size());
    const std::string_view word = help.substr(0, end);
    const std::string_view after = help.substr(end, 1);
    const std::string_view mark = word == "who" || word == "whom" ? "`" : "";
    text += fmt::format("{0}{1}{0}{2}", mark, word, after);
    help.remove_prefix(end + after.size());
  }
  return text;
}

/// OWASP, "CSV injection" (2024); tabs and carriage returns are escapes already.
bool is_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  constexpr std::u32string_view kBegin = U"=+-@\uFF1D\uFF0B\uFF0D\uFF20";
  return !text.empty() && kBegin.find(first_character(text).point) != kBegin.npos;
}

std::string harmless(std::string_view text) {
  const std::string shown = printable(text);
  return is_formula(shown) ? '\'' + shown : shown;
}

std::string in_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text)
    quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace

std::string_view unit_of(const EventColumn& column) {
  const std::string_view last = column.name.substr(column.name.rfind('_') + 1);
  return last == "m" || last == "s" || last == "deg" || last == "kg" ? last : "";
}

const std::vector<EventColumn>& event_columns() {
  static const std::vector<EventColumn> all = [] {
    std::vector<EventColumn> columns{
        {"time_s", "since the beginning of the run, at the end of the step", "{:.3f}"},
        {"step", "of the simulation, from 0", "{:.0f}"},
        {"event", "its kind"},
        {"who", "who does it: a player, or a missile as `AIM-120 #7 of eagle1`"},
        {"who_id", "its number", "{:.0f}"},
        {"whom", "whom it is done to; empty: nobody"},
        {"whom_id", "its number", "{:.0f}"},
        {"weapon", "type of the missile that it is about, or `gun`"},
        {"shooter", "of that missile"},
        {"missile_id", "its number: the same from launch to end", "{:.0f}"},
        {"north_m",
         "where it happened, from the scenario's reference; of what somebody sees or decides, "
         "where he was at the beginning of the step",
         "{:.2f}"},
        {"east_m", "likewise", "{:.2f}"},
        {"latitude_deg", "likewise, WGS 84", "{:.7f}"},
        {"longitude_deg", "likewise", "{:.7f}"},
        {"altitude_m", "likewise, above the ellipsoid", "{:.2f}"},
    };
    for (const model::EventInfo& info : model::event_infos())
      for (const model::EventValue& value : model::event_values(info.kind))
        if (std::ranges::none_of(columns, [&](const auto& c) { return c.name == value.column; }))
          columns.push_back({value.column,
                             // of some kinds true, of others believed
                             value.column == "range_m"
                                 ? "from who to whom, or to where it believes whom"
                                 : value.help,
                             value.code == EventCode::number ? "{:g}" : ""});
    return columns;
  }();
  return all;
}

Cell EventTable::value(const sim::Event& e, const model::EventValue& what, float number) const {
  switch (what.code) {
    case EventCode::number:
      if (std::isnan(number))  // model::kNothing
        return {};
      return what.unit.dimension == Dimension::angle
                 ? degrees(wrap_tau(static_cast<double>(number)))
                 : static_cast<double>(number);
    case EventCode::weapon:
      return store_label(scenario_, number);
    case EventCode::sources:
      return source_words(number);
    case EventCode::identity:
      return word<model::Identity>(number);
    case EventCode::radar:
      return word<model::EmissionKind>(number);
    case EventCode::ending:
      return word<model::weapon::MissileEnd>(number);
    case EventCode::decoys:
      return word<model::Dispense>(number);
    case EventCode::child:
      return cell_of(child_label(scenario_, e, number));
    case EventCode::node:
      return cell_of(node_label(scenario_, e, number));
    case EventCode::flight: {
      const auto& flights = scenario_.roster.flights;
      const auto i = static_cast<std::size_t>(number);
      return number >= 0 && i < flights.size() ? cell_of(flights[i].name) : Cell();
    }
    case EventCode::defense:
      return defense_word(number);
    case EventCode::order:
      return std::string(order_word(e));
  }
  return {};
}

std::vector<Cell> EventTable::row(const sim::Event& e, const sim::StepInfo& info) {
  missiles_.note(e);
  std::vector<Cell> cells(event_columns().size());
  const model::EventKind kind = kind_of(e);
  const auto id = [](PlayerId who) { return who ? Cell(static_cast<double>(who.value)) : Cell(); };
  const bool by_weapon = kind == model::EventKind::hit || kind == model::EventKind::kill;
  const PlayerId missile = missiles_.find(e.who)    ? e.who
                           : missiles_.find(e.whom) ? e.whom
                           : by_weapon              ? PlayerId{e.detail}
                                                    : PlayerId{};
  Cell weapon, shooter;
  if (const Missiles::Missile* of = missiles_.find(missile)) {
    weapon = cell_of(of->label);
    shooter = cell_of(scenario_.roster.name(of->shooter));
  } else if (by_weapon) {
    weapon = std::string("gun");
    shooter = cell_of(scenario_.roster.name(e.who));
  }
  const Geodetic place = scenario_.library->reference.to_geodetic(e.place);
  std::size_t at = 0;
  for (Cell& cell : std::array<Cell, kFixed>{
           info.time_after(), static_cast<double>(info.step),
           cell_of(std::string(model::event_name(kind))), cell_of(missiles_.name(e.who)), id(e.who),
           cell_of(missiles_.name(e.whom)), id(e.whom), weapon, shooter, id(missile), e.place.x,
           e.place.y, degrees(place.latitude), degrees(place.longitude), place.altitude})
    cells[at++] = std::move(cell);
  for (const float* number = e.values.data();
       const model::EventValue& what : model::event_values(kind))
    cells[place_of(what.column)] = value(e, what, *number++);
  return cells;
}

std::string csv_text(std::string_view text) {
  std::string cell = harmless(text);
  return cell.find_first_of(",\";") == cell.npos ? cell : in_quotes(cell);
}

std::string csv_quoted(std::string_view text) {
  return in_quotes(harmless(text));
}

EventsCsv::EventsCsv(const scenario::Scenario& scenario, disk::Sink& sink)
    : table_(scenario), sink_(sink) {
  for (const EventColumn& column : event_columns())
    fmt::format_to(std::back_inserter(out_), "{}{}", out_.empty() ? "" : ",", column.name);
  out_ += '\n';
}

void EventsCsv::observe(const sim::World&, const sim::StepInfo& info,
                        std::span<const sim::Event> events) {
  for (const sim::Event& e : events) {
    const std::vector<Cell> row = table_.row(e, info);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0)
        out_ += ',';
      if (const auto* number = std::get_if<double>(&row[i]))
        out_ += without_minus_zero(fmt::format(fmt::runtime(event_columns()[i].format), *number));
      else if (const auto* text = std::get_if<std::string>(&row[i]))
        out_ += csv_text(*text);
    }
    out_ += '\n';
  }
  if (out_.size() > 1 << 16) {
    sink_.write(out_);
    out_.clear();
  }
}

void EventsCsv::finish(const sim::World&) {
  sink_.write(out_);
  out_.clear();
}

std::string events_markdown() {
  std::string text =
      "# Events\n\n<!-- made by `eyrie catalog --events`; a test compares them -->\n\n"
      "Everything that happens in a run, as `events.csv` and the table `events` of `run.sqlite` "
      "have it: a row for each event,\nin the order in which they happened. An empty cell is "
      "nothing (NULL).\n\n"
      "| column | what it holds |\n| --- | --- |\n";
  for (std::size_t i = 0; i < kFixed; ++i)
    text += fmt::format("| `{}` | {} |\n", event_columns()[i].name, event_columns()[i].help);
  text +=
      "| the others | the values of the kinds below |\n\n"
      "Units stand at the end of a name: m, s, kg, deg. A campaign's measures call a value by the "
      "name in brackets,\nin SI and, where the table has a word, by the number in brackets behind "
      "it. What has no name in brackets is no number.\n\n"
      "| event | what happened | values |\n| --- | --- | --- |\n";
  for (const model::EventInfo& info : model::event_infos()) {
    std::string values;
    for (const model::EventValue& value : model::event_values(info.kind))
      values +=
          fmt::format("{}`{}`{}: {}", values.empty() ? "" : "; ", value.column,
                      value.is_name() ? "" : fmt::format(" ({})", value.name), marked(value.help));
    text += fmt::format("| `{}` | {} | {} |\n", info.name, marked(info.help), values);
  }
  return text;
}

}  // namespace eyrie::record
