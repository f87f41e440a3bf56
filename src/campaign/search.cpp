// SPDX-License-Identifier: MIT
#include "campaign/search.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "campaign/store.hpp"
#include "core/bind.hpp"
#include "core/math.hpp"
#include "core/text.hpp"
#include "core/yaml.hpp"

namespace eyrie::campaign {
namespace {

/// x on [0, 1], reflected at both ends.
double reflected(double x) {
  const double turn = std::abs(x - 2 * std::floor(x / 2));
  return std::clamp(turn <= 1 ? turn : 2 - turn, 1e-9, 1 - 1e-9);
}

std::string line_of(std::uint64_t generation, std::size_t candidate, const Cell& cell,
                    std::string_view score) {
  std::string line = fmt::format("{},{},{}", generation, candidate, score);
  for (const std::string& value : cell.values)
    line += "," + sql_name(value);  // as CSV has it, too
  return line;
}

/// Every cell with the same seeds. False if it was given up.
bool fly_all(const Spec& spec, std::span<const Cell> cells, const Load& load, const SearchRun& run,
             const std::function<void(const Result&)>& take) {
  std::map<std::vector<std::string>, std::shared_ptr<const scenario::Scenario>> loaded;
  std::vector<Batch> batches;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto [known, is_new] = loaded.try_emplace(sets_of(spec, cells[c]));
    try {
      if (is_new)
        known->second = load(known->first);
    } catch (const ConfigError&) {  // it is not flown
    }
    if (known->second)
      batches.push_back({c, 0, spec.replicates});
  }
  const auto find = [&](const std::vector<std::string>& sets) { return loaded.at(sets); };
  bool whole = true;
  Threads(spec, cells, find, run.workers, run.given_up).fly(batches, [&](Result&& result) {
    whole = result.flown.outcome != scenario::Outcome::stopped;
    if (!result.flown.fault.empty() && run.fault)
      run.fault(result.flown.fault, command_of(spec, cells[result.cell], result.flown.seed));
    if (whole && !result.values.empty())
      take(result);
    return whole;
  });
  return whole;
}

/// What a candidate is judged by.
struct Score {
  double sum = 0, per = 0;
  std::uint64_t n = 0;

  void add(const Measure& measure, std::span<const double> values) {
    if (std::isnan(values[measure.column]))
      return;
    sum += values[measure.column];
    per += measure.kind == Measure::ratio ? values[measure.per] : 1;
    ++n;
  }
  [[nodiscard]] std::optional<double> value(const Measure& measure) const {
    if (n == 0)
      return std::nullopt;
    return measure.kind == Measure::ratio ? (sum + 1) / (per + 1) : sum / per;
  }
};

}  // namespace

std::unique_ptr<const Search> parse_search(std::string text, const std::string& file) {
  auto search = std::make_unique<Search>();
  Diagnostics diagnostics;
  const Value document = parse_yaml(text, file, diagnostics);
  diagnostics.throw_if_any();
  static constexpr std::array<std::string_view, 1> kAlso{"optimize"};
  search->spec = bind_spec(document, file, kAlso, diagnostics);
  search->spec.text = std::move(text);
  const Value* const how = document.find("optimize");
  if (!how) {
    diagnostics.error(document.where, "a search needs 'optimize'");
  } else if (bind(*search, *how, diagnostics)) {
    search->best = find_measure(search->spec.measures, *how, "optimize", diagnostics);
  }
  if (const Value* budget = document.find("budget"))
    diagnostics.error(budget->where, "budget: of a search 'generations' says how long it takes");
  if (!search->spec.seeds.paired)
    diagnostics.error(document.where_of("seeds"), "seeds: those of a search are always paired");
  if (search->spec.factors.empty() && diagnostics.ok())
    diagnostics.error(document.where, "a search needs 'factors'");
  diagnostics.throw_if_any();
  return search;
}

Spec probe_of(const Search& search) {
  Spec spec = search.spec;
  spec.design = {.kind = DesignKind::latin_hypercube, .cells = 100};
  return spec;
}

Cell cell_at(const Search& search, std::span<const double> point) {
  Cell cell;
  for (std::size_t i = 0; i < point.size(); ++i)
    cell.values.push_back(search.spec.factors[i].value_at(reflected(point[i])));
  return cell;
}

SearchLog::SearchLog(const Search& search, std::string_view origin, const std::string& text,
                     const std::string& file)
    : share_(search.best->kind == Measure::share), file_(file) {
  text_ = fmt::format("# {}\ngeneration,candidate,{},{}\n", origin, search.measure,
                      fmt::join(listed(search.spec.factors, &Factor::name), ","));
  if (text.empty())
    return;
  if (!text.starts_with(text_))
    throw ConfigError({file, 1, 1},
                      "is of another search: its file, the scenario or the program has changed");
  std::istringstream lines(text.substr(text_.size()));
  for (std::string line; std::getline(lines, line);)
    earlier_.push_back(line);
}

SearchLog::Seen SearchLog::next(std::uint64_t generation, std::size_t candidate, const Cell& cell) {
  if (at_ == earlier_.size())
    return {};
  const std::string& line = earlier_[at_++];
  const std::size_t begin = line.find(',', line.find(',') + 1) + 1;
  const std::size_t end = std::min(line.find(',', begin), line.size());
  const std::string_view text = std::string_view(line).substr(begin, end - begin);
  const auto score = number_from<double>(text);
  const bool possible =
      score ? std::isfinite(*score) && (!share_ || (*score >= 0 && *score <= 1)) : text == "none";
  if (line != line_of(generation, candidate, cell, text) || !possible)
    throw ConfigError({file_, static_cast<int>(at_) + 2, 1},
                      "is not what this search has drawn there: the file was changed");
  return {true, score};
}

void SearchLog::add(std::uint64_t generation, std::size_t candidate, const Cell& cell,
                    std::optional<double> score) {
  text_ += line_of(generation, candidate, cell, score ? fmt::format("{}", *score) : "none") + "\n";
}

std::optional<Winner> optimize(const Search& search, const Load& load, SearchLog& log,
                               const SearchRun& run) {
  std::optional<Winner> accepted;
  // from the middle of every factor, and at most about as wide as that
  CmaEs strategy(CmaEs::Point(search.spec.factors.size(), 0.5), 0.3, search.seed,
                 search.population.value_or(0), 0.3);
  while (strategy.generation() < search.generations) {
    Generation now{.number = strategy.generation(), .cells = {}, .scores = {}};
    std::size_t known = 0;
    for (const CmaEs::Point& point : strategy.points()) {
      now.cells.push_back(cell_at(search, point));
      const auto seen = log.next(now.number, now.cells.size() - 1, now.cells.back());
      known += seen.known;
      now.scores.push_back(seen.score);
    }
    if (known < now.cells.size()) {
      Spec spec = search.spec;
      spec.seeds = {.first = search.seed_of_generation(now.number), .paired = true};
      std::vector<Score> scores(now.cells.size());
      if (!fly_all(spec, now.cells, load, run,
                   [&](const Result& r) { scores[r.cell].add(*search.best, r.values); }))
        return std::nullopt;
      for (std::size_t c = 0; c < scores.size(); ++c)
        now.scores[c] = scores[c].value(*search.best);
    }
    std::vector<double> losses;
    for (std::size_t c = 0; c < now.cells.size(); ++c) {
      log.add(now.number, c, now.cells[c], now.scores[c]);
      const double sign = search.goal == Goal::maximize ? -1 : 1;
      losses.push_back(now.scores[c] ? sign * *now.scores[c] : math::kInfinity);
    }
    now.best = static_cast<std::size_t>(std::ranges::min_element(losses) - losses.begin());
    if (now.scores[now.best])
      accepted = Winner{now.cells[now.best], now.number};
    strategy.tell(losses);
    now.sigma = strategy.sigma();
    if (known < now.cells.size())
      run.tell(now, log);
  }
  Winner middle{cell_at(search, strategy.mean())};
  try {
    static_cast<void>(load(sets_of(search.spec, middle.cell)));
  } catch (const ConfigError& error) {
    if (!accepted)
      throw;
    accepted->refusal = error.what();
    return accepted;
  }
  if (!accepted) {
    const auto& measures = search.spec.measures;
    const auto which = static_cast<std::size_t>(search.best - measures.estimates.data());
    throw ConfigError(measures.specs[which].text.where,
                      "no flight of any candidate gives " + quote(search.measure) +
                          " a value: none is better than another");
  }
  return middle;
}

std::optional<std::vector<Evidence>> prove(const Search& search, const Cell& found,
                                           const Load& load, const SearchRun& run) {
  Spec spec = search.spec;
  spec.seeds = {.first = search.seed_of_generation(search.generations), .paired = true};
  spec.replicates = search.proof;
  spec.sets.clear();
  spec.factors = {{.name = "search",
                   .where = {},
                   .paths = {},
                   .levels = {{"before", search.spec.sets}, {"after", sets_of(search.spec, found)}},
                   .distribution = {}}};
  const std::vector<Cell> cells{{{"before"}}, {{"after"}}};
  std::array<std::vector<std::vector<double>>, 2> values;  // by cell and replicate
  for (auto& of_cell : values)
    of_cell.resize(spec.replicates);
  if (!fly_all(spec, cells, load, run,
               [&](const Result& r) { values[r.cell][r.replicate] = r.values; }))
    return std::nullopt;

  std::vector<Evidence> all;
  for (const Measure& measure : spec.measures.estimates) {
    Estimator before(measure), after(measure);
    for (std::size_t r = 0; r < spec.replicates; ++r) {
      before.add(values[0][r]);
      after.add(values[1][r]);
    }
    all.push_back({measure, before.estimate(), after.estimate()});
  }
  const auto each = [&](const TakePair& use) {
    for (std::size_t r = 0; r < spec.replicates; ++r)
      if (!values[0][r].empty() && !values[1][r].empty())
        use(values[1][r], values[0][r]);
  };
  for (const Comparison& c : compare_pairs(spec.measures.estimates, each))
    all[c.measure].difference = c;
  return all;
}

}  // namespace eyrie::campaign
