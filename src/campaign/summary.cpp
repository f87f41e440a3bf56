// SPDX-License-Identifier: MIT
#include "campaign/summary.hpp"

#include <algorithm>

#include "campaign/store.hpp"

namespace eyrie::campaign {
namespace {

void read_measures(Database& database, const std::vector<std::string>& columns, Summary& summary) {
  const auto index = [&](const std::string& name) {
    const auto found = std::ranges::find(columns, name);
    if (found == columns.end())
      throw disk::Refused("the results are damaged: there is no column {}", quote(name));
    return static_cast<std::size_t>(found - columns.begin());
  };
  Statement all = database.prepare(
      "SELECT m.name, m.kind, m.of, m.per, c.unit FROM measures m "
      "LEFT JOIN columns c ON c.name = m.of ORDER BY measure");
  while (all.step()) {
    summary.measures.push_back({all.text(0),
                                enum_named<Measure::Kind>(all.text(1)).value_or(Measure::ratio),
                                index(all.text(2)), index(all.text(all.text(3).empty() ? 2 : 3))});
    summary.units.push_back(all.text(4));
  }
}

}  // namespace

Summary read_summary(const std::string& folder, double confidence) {
  Database database = open_results(folder);
  Summary summary;
  Statement said = database.prepare("SELECT name, value FROM campaign");
  while (said.step()) {
    const std::string key = said.text(0);
    for (const auto& [name, text] : {std::pair{"name", &summary.name},
                                     {"scenario", &summary.scenario},
                                     {"hash", &summary.hash},
                                     {"ended", &summary.ended}})
      if (key == name)
        *text = said.text(1);
  }
  summary.factors = columns_of(database, "cells", 2);
  // a part may have replicate 0 of one cell only, or of none
  Statement seeds =
      database.prepare("SELECT min(seed - replicate) < max(seed - replicate) FROM replicates");
  summary.paired = !seeds.step() || seeds.integer(0) == 0;
  read_measures(database, columns_of(database, "replicates", kFirstColumn), summary);

  Statement cells = database.prepare("SELECT * FROM cells ORDER BY cell");
  while (cells.step()) {
    Summary::OfCell& cell = summary.cells.emplace_back();
    cell.command = cells.text(1);
    for (int i = 2; i < cells.columns(); ++i)
      cell.values.push_back(cells.text(i));
  }
  std::vector<Estimator> fresh(summary.measures.begin(), summary.measures.end()), estimators;
  std::vector<double> values;
  Statement all = database.prepare("SELECT * FROM replicates ORDER BY cell, replicate");
  bool more = all.step();
  for (std::size_t c = 0; c < summary.cells.size(); ++c) {
    Summary::OfCell& cell = summary.cells[c];
    estimators = fresh;
    for (; more && static_cast<std::size_t>(all.integer(0)) == c; more = all.step()) {
      ++cell.replicates;
      if (all.text(3) == "fault") {
        ++cell.faults;
        continue;
      }
      read_values(all, kFirstColumn, all.columns(), values);
      for (Estimator& estimator : estimators)
        estimator.add(values);
    }
    for (const Estimator& estimator : estimators)
      cell.estimates.push_back(estimator.estimate(confidence));
  }
  Statement faults = database.prepare(
      "SELECT cell, seed, what, command FROM faults ORDER BY cell, replicate LIMIT 100");
  while (faults.step())
    summary.faults.push_back({static_cast<std::uint64_t>(faults.integer(0)),
                              static_cast<std::uint64_t>(faults.integer(1)), faults.text(2),
                              faults.text(3)});
  return summary;
}

std::string estimate_text(const Estimate& estimate, Measure::Kind kind) {
  if (!estimate.value)
    return "-";
  const bool share = kind == Measure::share;
  const auto number = [&](double x) {
    return share ? fmt::format("{:.1f}", 100 * x) : fmt::format("{:.4g}", x);
  };
  std::string text = number(*estimate.value) + (share ? " %" : "");
  if (const auto& interval = estimate.interval)
    text += fmt::format(" ({} to {})", number(interval->low), number(interval->high));
  else
    text += " (no bounds)";
  return text;
}

}  // namespace eyrie::campaign
