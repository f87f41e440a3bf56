// SPDX-License-Identifier: MIT
/// \file  What does a judgement do? Flies missions with every value of data/ that is marked
/// [judgement] at 0.8 or 1.2 of what it is, all at the same time, in the combinations of a balanced
/// design, and prints one table: each run tells of every value. What is flown is kept in a file, so
/// that the next start goes on from there. usage: sensitivity HOME KEPT SEEDS SCENARIO...
#include <atomic>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <numeric>
#include <set>
#include <sstream>
#include <thread>

#include "debrief/health.hpp"
#include "design.hpp"
#include "judgement.hpp"

namespace {
using namespace eyrie;
using namespace eyrie::sensitivity;

/// Calls `work` with 0 .. count - 1, on all cores; throws what one of them throws.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr thrown;
  std::mutex mutex;
  std::vector<std::thread> workers;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    workers.emplace_back([&] {
      try {
        for (std::size_t k; (k = next++) < count;)
          work(k);
      } catch (...) {
        const std::lock_guard lock(mutex);
        thrown = std::current_exception();
        next = count;
      }
    });
  for (std::thread& worker : workers)
    worker.join();
  if (thrown)
    std::rethrow_exception(thrown);
}

using Scores = std::vector<double>;

/// Red losses less blue ones, and both together: what is the same on both sides shows there.
constexpr const char* kOutcomes[] = {"red - blue losses", "red + blue losses"};
constexpr std::size_t kCount = std::size(kOutcomes);
void fly(const std::shared_ptr<const scenario::Scenario>& scenario, std::uint64_t seed,
         double* outcomes) {
  const debrief::Health health = debrief::measure(scenario, seed);
  const auto blue = static_cast<double>(health.lost[0]), red = static_cast<double>(health.lost[1]);
  outcomes[0] = red - blue;
  outcomes[1] = red + blue;
}

/// "-0.12 ± 0.20": a mean with its 95 % interval (Student's t); bold if 0 is outside.
std::string mean_of(const Scores& of, bool is_effect) {
  const double n = static_cast<double>(of.size());
  const double mean = std::accumulate(of.begin(), of.end(), 0.0) / n;
  double squares = 0;
  for (const double x : of)
    squares += (x - mean) * (x - mean);
  // t of n - 1 degrees of freedom, to 2 % from n = 10
  const double half = (1.96 + 2.4 / (n - 1)) * std::sqrt(squares / n / (n - 1));
  return fmt::format("{0}{1:+.2f} ± {2:.2f}{0}", is_effect && std::fabs(mean) > half ? "**" : "",
                     mean, half);
}

/// What was flown, by a key: a line of a file each, whole if it ends in a full stop.
class Kept {
 public:
  explicit Kept(const std::string& file) {
    std::ifstream was(file);
    for (std::string line; std::getline(was, line);) {
      const std::size_t tab = line.find('\t');
      if (tab == std::string::npos || !line.ends_with('.'))
        continue;
      std::istringstream words(line.substr(tab + 1));
      Scores& scores = lines_[line.substr(0, tab)];
      scores.clear();
      for (double x; words >> x;)
        scores.push_back(x);
    }
    file_.open(file, std::ios::app);
    file_ << '\n';
  }
  /// Null if it was not flown yet.
  const Scores* find(const std::string& key) {
    const std::lock_guard lock(mutex_);
    const auto there = lines_.find(key);
    return there == lines_.end() ? nullptr : &there->second;
  }
  void keep(const std::string& key, const Scores& scores) {
    const std::lock_guard lock(mutex_);
    lines_[key] = scores;
    file_ << key << '\t';
    for (const double x : scores)
      file_ << x << ' ';
    file_ << '.' << std::endl;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, Scores> lines_;
  std::ofstream file_;
};

/// One mission: the values that it reads, and what each of them does.
class Study {
 public:
  Study(std::string home, std::string file, std::size_t seeds, Kept& kept,
        const std::vector<Judgement>& all)
      : home_(std::move(home)),
        file_(std::move(file)),
        seeds_(seeds),
        kept_(kept),
        base_(kCount * seeds) {
    const auto scenario = scenario::load({file_, {}}, scenario::Source::disk(home_));
    on_all_cores(seeds, [&](std::size_t k) { ::fly(scenario, k + 1, &base_[kCount * k]); });
    for (const bool costly : {true, false})  // launch zones are flown anew for a changed missile
      for (const Judgement& j : all)
        if (scenario->files.contains(j.file) && is_costly(j) == costly)
          values_.push_back(&j);
    std::string id;  // what was kept belongs to these runs
    for (const double score : base_)
      id += fmt::format("{} ", score);
    for (const Judgement* j : values_)
      id += j->name + j->now;
    id_ = fmt::format("{} {:x}", file_, std::hash<std::string>{}(id));
  }

  void fly() {
    const auto costly = static_cast<std::size_t>(
        std::count_if(values_.begin(), values_.end(), [](auto* j) { return is_costly(*j); }));
    const Design design(costly, values_.size() - costly);
    const std::size_t in_plot = design.rows_in_plot();
    rows_.resize(design.plots() * in_plot);
    std::atomic<std::size_t> done = 0;
    const auto fly_row = [&](std::size_t r) {
      Row& row = rows_[r];
      for (std::size_t i = 0; i < values_.size(); ++i)
        row.signs.push_back(design.sign(r / in_plot, r % in_plot, i));
      const std::string key = fmt::format("{} {}", id_, r);
      if (const Scores* scores = kept_.find(key)) {
        row.scores = *scores;
      } else {
        const auto scenario = loaded(row);
        row.scores.resize(base_.size());
        for (std::size_t k = 0; k < seeds_; ++k)
          ::fly(scenario, k + 1, &row.scores[kCount * k]);
        kept_.keep(key, row.scores);
      }
      fmt::print(stderr, "\r{}: {} of {} rows ", file_, ++done, rows_.size());
    };
    on_all_cores(design.plots(), [&](std::size_t plot) {
      for (std::size_t i = 0; i < in_plot; ++i)
        fly_row(plot * in_plot + i);
    });
    fmt::print(stderr, "\n");
  }

  [[nodiscard]] std::string as_it_is(std::size_t outcome) const {
    Scores by_seed(seeds_);
    for (std::size_t k = 0; k < seeds_; ++k)
      by_seed[k] = base_[kCount * k + outcome];
    return mean_of(by_seed, false);
  }
  [[nodiscard]] std::size_t runs() const { return rows_.size() * seeds_; }
  /// From 0.8 to 1.2; "" of what the mission does not read.
  [[nodiscard]] std::string effect(const Judgement& j, std::size_t outcome) const {
    const auto place = std::find(values_.begin(), values_.end(), &j);
    if (place == values_.end())
      return "";
    Scores by_seed(seeds_);
    for (const Row& row : rows_)
      for (std::size_t k = 0; k < seeds_; ++k)
        by_seed[k] += 2 * row.signs[static_cast<std::size_t>(place - values_.begin())] *
                      row.scores[kCount * k + outcome] / static_cast<double>(rows_.size());
    const Scores* refused = kept_.find(refused_key(j));
    return mean_of(by_seed, true) + (refused == nullptr     ? ""
                                     : refused->front() > 0 ? " (to 1)"
                                                            : " (from 1)");
  }

 private:
  struct Row {
    std::vector<int> signs{};  ///< of the values
    Scores scores{};
  };
  [[nodiscard]] std::string refused_key(const Judgement& j) const {
    return id_ + " refused " + j.name;
  }

  static bool is_costly(const Judgement& j) {
    return j.file.find("/missiles/") != std::string::npos;
  }

  /// With the values of a row; one that would leave its range stays as it is.
  std::shared_ptr<const scenario::Scenario> loaded(const Row& row) {
    std::vector<int> signs = row.signs;
    for (;;) {
      auto source = scenario::Source::disk(home_);
      std::map<std::string, std::string> texts;
      for (std::size_t i = values_.size(); i-- > 0;) {  // of a file the later places first
        const Judgement& j = *values_[i];
        std::string& text = texts.try_emplace(j.file, j.text).first->second;
        if (signs[i] != 0)
          text.replace(j.begin, j.end - j.begin, scaled(j.now, signs[i] > 0 ? 1.2 : 0.8));
      }
      for (const auto& [name, text] : texts)
        source.add(name, text);
      try {
        return scenario::load({file_, {}}, std::move(source));
      } catch (const ConfigError& e) {
        bool found = false;
        for (const Diagnostic& wrong : e.diagnostics().sorted())
          for (std::size_t i = 0; i < values_.size(); ++i)
            if (signs[i] != 0 && values_[i]->line == wrong.where.line &&
                values_[i]->file == wrong.where.file.text()) {
              found = true;
              kept_.keep(refused_key(*values_[i]), {static_cast<double>(signs[i])});
              signs[i] = 0;
            }
        if (!found)
          throw;
      }
    }
  }

  std::string home_, file_, id_;
  std::size_t seeds_;
  Kept& kept_;
  Scores base_;
  std::vector<const Judgement*> values_;
  std::vector<Row> rows_;
};

}  // namespace

int main(int argc, char** argv) {
  const std::size_t seeds = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 0;
  if (argc < 5 || seeds < 2) {
    fmt::print(stderr, "usage: sensitivity HOME KEPT SEEDS SCENARIO...   (2 seeds at least)\n");
    return 2;
  }
  try {
    const std::string home = argv[1];
    const std::vector<Judgement> all = judgements(home);
    fmt::print(stderr, "{} judgements\n", all.size());
    Kept kept(argv[2]);
    std::deque<Study> studies;
    std::string head = "| from 0.8 to 1.2 of |", line = "| --- |",
                now = "| none: the mission as it is |";
    std::string runs = "Runs: ";
    for (int i = 4; i < argc; ++i) {
      Study& study = studies.emplace_back(home, argv[i], seeds, kept, all);
      study.fly();
      for (std::size_t o = 0; o < kCount; ++o) {
        head +=
            fmt::format(" {}: {} |", std::filesystem::path(argv[i]).stem().string(), kOutcomes[o]);
        line += " ---: |";
        now += fmt::format(" {} |", study.as_it_is(o));
      }
      runs += fmt::format("{}{} of {}", i > 4 ? ", " : "", study.runs(), argv[i]);
    }
    fmt::print("{}\n\n{} now |\n{} ---: |\n{} |", runs, head, line, now);
    for (const Judgement& j : all) {
      fmt::print("\n| {} |", j.name);
      for (const Study& study : studies)
        for (std::size_t o = 0; o < kCount; ++o)
          fmt::print(" {} |", study.effect(j, o));
      fmt::print(" {} |", j.now);
    }
    fmt::print("\n");
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 2;
  }
}
