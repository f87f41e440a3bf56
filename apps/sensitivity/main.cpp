// SPDX-License-Identifier: MIT
/// \file  What does a judgement do? Flies missions with each value of data/ that is marked
/// [judgement] at 0.8 and 1.2 of what it is, with the same seeds on all cores, and prints one
/// table. What is flown is kept in a file, so that the next start goes on from there. usage:
/// sensitivity HOME KEPT SEEDS SCENARIO...
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <regex>
#include <sstream>
#include <thread>

#include "debrief/health.hpp"

namespace {
using namespace eyrie;

/// A line of a file of data/ with a number that nobody has published.
struct Judgement {
  std::string file;                ///< data/guns/m61.yaml
  std::string name;                ///< m61: aim_error
  std::string now;                 ///< 2 mrad
  std::string text;                ///< of the whole file
  std::size_t begin = 0, end = 0;  ///< of the value in it
};

constexpr double kFactors[] = {0.8, 1.2};
/// A number; not the 2 of m/s2.
const std::regex kNumber(R"((^|[^\w.])([-+]?\d+\.?\d*(?:[eE][-+]?\d+)?))");

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Judgement> judgements(const std::string& home) {
  std::vector<Judgement> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(home + "/data")) {
    if (entry.path().extension() != ".yaml")
      continue;
    const std::string text = text_of(entry.path());
    std::vector<std::pair<std::size_t, std::string>> above;  // indentation, key
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t stop = std::min(text.find('\n', at), text.size());
      const std::string line = text.substr(at, stop - at);
      const std::size_t indent = line.find_first_not_of(' '), colon = line.find(": ");
      const std::size_t hash = line.find(" #");
      if (indent != std::string::npos && line[indent] != '#' && line.find(':') < hash) {
        while (!above.empty() && above.back().first >= indent)
          above.pop_back();
        above.emplace_back(indent, line.substr(indent, line.find(':') - indent));
        if (colon < hash && hash != std::string::npos &&
            line.find("[judgement]", hash) != std::string::npos &&
            std::regex_search(line.substr(colon, hash - colon), kNumber)) {
          std::string name = entry.path().stem().string() + ":";
          for (const auto& [_, key] : above)
            name += (name.back() == ':' ? " " : ".") + key;
          std::size_t last = line.find_last_not_of(' ', hash) + 1;
          all.push_back({std::filesystem::relative(entry.path(), home).string(), name,
                         line.substr(colon + 2, last - colon - 2), text, at + colon + 2,
                         at + last});
        }
      }
      at = stop + 1;
    }
  }
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return a.file + a.name < b.file + b.name; });
  return all;
}

/// Every number of it times a factor. Whole numbers without a unit stay whole and change by one at
/// least; rates become such that fit the step (50 Hz).
std::string scaled(const std::string& value, double factor) {
  const bool rate = value.ends_with(" Hz");
  const bool counts = value.find_first_not_of("0123456789") == std::string::npos;
  const auto rounded = [&](double number) {  // away from what it is
    const double whole = std::round(number * factor);
    return whole != number ? whole : number + (factor < 1 ? -1 : 1);
  };
  std::string result;
  auto from = value.begin();
  for (std::sregex_iterator i(value.begin(), value.end(), kNumber), end; i != end; ++i) {
    result.append(from, value.begin() + i->position(2));
    const double number = std::stod((*i)[2].str());
    double wanted = number * factor;
    if (counts)
      wanted = rounded(number);
    else if (rate)
      wanted = std::round(50 / wanted) != std::round(50 / number)
                   ? 50 / std::round(50 / wanted)
                   : 50 / (std::round(50 / number) + (factor < 1 ? 1 : -1));
    result += fmt::format("{:.10g}", wanted);
    from = value.begin() + i->position(2) + i->length(2);
  }
  return result.append(from, value.end());
}

/// How a run ends, in what is compared: enemies lost for own losses, and shots.
struct Score {
  double exchange = 0, shots = 0;
  bool operator==(const Score&) const = default;
};

Score flown(const std::shared_ptr<const scenario::Scenario>& scenario, std::uint64_t seed) {
  const debrief::Health health = debrief::measure(scenario, seed);
  return {static_cast<double>(health.lost[1]) - static_cast<double>(health.lost[0]),
          static_cast<double>(health.missiles)};
}

/// "-0.12 ± 0.20": the mean of the differences with its 95 % interval; "=" if there is none.
std::string difference(const std::vector<Score>& before, const std::vector<Score>& after) {
  double sum = 0, squares = 0;
  const double n = static_cast<double>(after.size());
  bool same = true;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double d = after[i].exchange - before[i].exchange;
    same &= after[i] == before[i];
    sum += d;
    squares += d * d;
  }
  if (same)
    return "=";
  const double mean = sum / n;
  const double spread = std::sqrt(std::max(squares / n - mean * mean, 0.0) / std::max(n - 1, 1.0));
  const bool beyond = std::fabs(mean) > 1.96 * spread;
  return fmt::format("{0}{1:+.2f} ± {2:.2f}{0}", beyond ? "**" : "", mean, 1.96 * spread);
}

/// Calls `work` with 0 .. count - 1, on all cores.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::thread> workers;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    workers.emplace_back([&] {
      for (std::size_t k; (k = next++) < count;)
        work(k);
    });
  for (std::thread& worker : workers)
    worker.join();
}

constexpr std::size_t kFirst = 4;  // seeds: who changes nothing in them changes nothing

struct Study {
  std::string home;
  std::vector<std::string> scenarios;
  std::size_t seeds;
  std::vector<std::vector<Score>> base{};  ///< by scenario, by seed

  void fly_base() {
    for (const std::string& file : scenarios) {
      const auto scenario = scenario::load({file, {}}, scenario::Source::disk(home));
      std::vector<Score>& scores = base.emplace_back(seeds);
      on_all_cores(seeds, [&](std::size_t k) { scores[k] = flown(scenario, k + 1); });
    }
  }

  /// A cell for each scenario.
  [[nodiscard]] std::vector<std::string> cells(const Judgement& j, double factor) const {
    std::vector<std::string> result;
    std::string text = j.text;
    text.replace(j.begin, j.end - j.begin, scaled(j.now, factor));
    for (std::size_t s = 0; s < scenarios.size(); ++s)
      try {
        auto source = scenario::Source::disk(home);
        source.add(j.file, text);
        const auto scenario = scenario::load({scenarios[s], {}}, std::move(source));
        std::vector<Score> after;
        for (std::size_t k = 0; k < seeds; ++k) {
          if (k == kFirst && std::equal(after.begin(), after.end(), base[s].begin()))
            break;
          after.push_back(flown(scenario, k + 1));
        }
        result.push_back(difference(base[s], after));
      } catch (const std::exception&) {
        result.emplace_back("refused");  // out of its range
      }
    return result;
  }
};

}  // namespace

int main(int argc, char** argv) {
  const std::size_t seeds = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 0;
  if (argc < 5 || seeds == 0) {
    fmt::print(stderr, "usage: sensitivity HOME KEPT SEEDS SCENARIO...\n");
    return 2;
  }
  Study study{.home = argv[1], .scenarios = {argv + 4, argv + argc}, .seeds = seeds};
  try {
    const std::vector<Judgement> all = judgements(study.home);
    fmt::print(stderr, "{} judgements; {} seeds as they are\n", all.size(), seeds);
    study.fly_base();
    std::string sums;  // what was kept belongs to these runs
    for (const auto& scores : study.base)
      for (const Score& score : scores)
        sums += fmt::format("{},{};", score.exchange, score.shots);
    const std::string id = fmt::format("{:x}", std::hash<std::string>{}(sums));

    std::map<std::string, std::vector<std::string>> kept;  // key -> cells
    std::ifstream was(argv[2]);
    for (std::string line; std::getline(was, line);) {
      std::vector<std::string> parts;
      std::istringstream words(line);
      for (std::string part; std::getline(words, part, '\t');)
        parts.push_back(part);
      if (parts.size() == study.scenarios.size() + 1)
        kept[parts[0]] = {parts.begin() + 1, parts.end()};
    }
    std::ofstream keep(argv[2], std::ios::app);
    const auto key = [&](const Judgement& j, double factor) {
      return fmt::format("{} {} {} {}", id, j.name, j.now, factor);
    };
    std::mutex mutex;
    std::size_t done = 0;
    on_all_cores(2 * all.size(), [&](std::size_t k) {
      const Judgement& j = all[k / 2];
      const double factor = kFactors[k % 2];
      const std::string name = key(j, factor);
      {
        const std::lock_guard lock(mutex);
        ++done;
        if (kept.contains(name))
          return;
      }
      const auto cells = study.cells(j, factor);
      const std::lock_guard lock(mutex);
      kept[name] = cells;
      keep << name;
      for (const std::string& cell : cells)
        keep << '\t' << cell;
      keep << std::endl;
      fmt::print(stderr, "\r{} of {} ", done, 2 * all.size());
    });

    fmt::print("| {} seeds each | now |", seeds);
    for (const std::string& file : study.scenarios)
      for (const double factor : kFactors)
        fmt::print(" {} x {} |", std::filesystem::path(file).stem().string(), factor);
    fmt::print("\n| --- | ---: |");
    for (std::size_t i = 0; i < 2 * study.scenarios.size(); ++i)
      fmt::print(" ---: |");
    for (const Judgement& j : all) {
      fmt::print("\n| {} | {} |", j.name, j.now);
      for (std::size_t s = 0; s < study.scenarios.size(); ++s)
        for (const double factor : kFactors)
          fmt::print(" {} |", kept[key(j, factor)][s]);
    }
    fmt::print("\n");
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 2;
  }
}
