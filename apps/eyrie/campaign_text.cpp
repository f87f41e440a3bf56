// SPDX-License-Identifier: MIT
#include "campaigns.hpp"

#include "core/text.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {

/// Texts in columns, the first row above the others.
void print_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], columns(printable(row[i])));
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += fmt::format("{:<{}}  ", printable(row[i]), widths[i]);
    say("{}\n", Composed{line.substr(0, line.find_last_not_of(' ') + 1)});
  }
}

}  // namespace

std::string duration_text(double seconds) {
  if (seconds < 90)
    return fmt::format("{:.0f} s", seconds);
  if (seconds < 90 * 60)
    return fmt::format("{:.0f} min", seconds / 60);
  const auto minutes = static_cast<std::uint64_t>(seconds / 60 + 0.5);
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

void print_cells(const campaign::Summary& summary) {
  constexpr std::size_t kMostRows = 50, kMostFaults = 5;
  std::vector<std::vector<std::string>> rows(1, {"cell"});
  rows[0].insert(rows[0].end(), summary.factors.begin(), summary.factors.end());
  rows[0].push_back("n");
  for (std::size_t m = 0; m < summary.measures.size(); ++m)
    rows[0].push_back(summary.measures[m].name +
                      (summary.units[m].empty() ? "" : ", " + summary.units[m]));
  for (std::size_t c = 0; c < std::min(summary.cells.size(), kMostRows); ++c) {
    const auto& cell = summary.cells[c];
    auto& row = rows.emplace_back(1, std::to_string(c));
    row.insert(row.end(), cell.values.begin(), cell.values.end());
    row.push_back(std::to_string(cell.replicates));
    for (std::size_t m = 0; m < summary.measures.size(); ++m) {
      const campaign::Estimate& e = cell.estimates[m];
      row.push_back(estimate_text(e, summary.measures[m].kind));
      if (e.value && e.n != cell.replicates - cell.faults)
        row.back() += fmt::format(" of {}", e.n);  // to so many it applies
    }
  }
  print_table(rows);
  if (summary.cells.size() > kMostRows)
    say("... and {}\n", counted(summary.cells.size() - kMostRows, "more cell"));
  for (std::size_t i = 0; i < std::min(summary.faults.size(), kMostFaults); ++i)
    say("fault in cell {}: {}\n  {}\n", summary.faults[i].cell, summary.faults[i].what,
        summary.faults[i].command);
  if (summary.faults.size() > kMostFaults)
    say("... and more faults: see the table `faults`\n");
}

void print_comparisons(const campaign::Summary& summary,
                       const std::vector<campaign::Comparison>& comparisons, std::size_t most) {
  if (comparisons.empty())
    return;
  std::vector<campaign::Comparison> surest = comparisons;
  std::ranges::stable_sort(surest, {},
                           [](const campaign::Comparison& c) { return std::pair(c.holm, c.p); });
  std::vector<std::vector<std::string>> rows{{"measure", "cell", "less cell", "difference",
                                              summary.paired ? "pairs" : "replicates", "p",
                                              "p (Holm)"}};
  for (std::size_t i = 0; i < std::min(surest.size(), most); ++i) {
    const auto& c = surest[i];
    rows.push_back({summary.measures[c.measure].name, std::to_string(c.cell),
                    std::to_string(c.than),
                    estimate_text({c.n, c.value, c.interval}, summary.measures[c.measure].kind),
                    summary.paired ? std::to_string(c.n) : fmt::format("{} and {}", c.n, c.n_than),
                    fmt::format("{:.2g}", c.p), fmt::format("{:.2g}", c.holm)});
  }
  say("\ncells against each other, {}, the surest first\n",
      summary.paired ? "replicate by replicate" : "of other seeds");
  print_table(rows);
  if (surest.size() > most)
    say("... and {}\n", counted(surest.size() - most, "more comparison"));
}

void print_effects(const campaign::Summary& summary, const std::vector<campaign::Effect>& effects,
                   const std::vector<campaign::Interaction>& interactions) {
  if (effects.empty())
    return;
  std::vector<std::vector<std::string>> rows{{"measure", "factor", "part", "means"}};
  for (const auto& effect : effects) {
    std::string means;
    for (const auto& level : effect.levels)
      means += fmt::format("{}{}: {:.4g}", means.empty() ? "" : ", ", level.name, level.mean);
    rows.push_back({summary.measures[effect.measure].name, summary.factors[effect.factor],
                    fmt::format("{:.0f} %", 100 * effect.part), means});
  }
  for (const auto& both : interactions)
    rows.push_back({summary.measures[both.measure].name,
                    fmt::format("{} x {}", summary.factors[both.one], summary.factors[both.other]),
                    fmt::format("{:.0f} %", 100 * both.part), ""});
  say("\nwhich factor goes with the variance between cells, and the mean of each of its levels\n");
  print_table(rows);
}

}  // namespace eyrie::app
