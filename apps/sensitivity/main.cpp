// SPDX-License-Identifier: MIT
/// \file  What does a judgement do? Flies missions with every value of data/ that is marked
/// [judgement] at 0.8 or 1.2 of what it is, all at the same time, in the combinations of a balanced
/// design, and prints one table: each run tells of every value. What is flown is kept in a file, so
/// that the next start goes on from there. usage: sensitivity HOME KEPT SEEDS SCENARIO...
/// SCENARIO: FILE[,PATH=VALUE]..., and behind a + only the values that no mission before it reads.
#include <atomic>
#include <deque>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "campaign/in_order.hpp"
#include "debrief/health.hpp"
#include "design.hpp"
#include "judgement.hpp"
#include "model/weapon/kept_zones.hpp"

namespace {
using namespace eyrie;
using namespace eyrie::sensitivity;

/// Calls `work` with 0 .. count - 1, on all cores; throws what one of them throws.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work) {
  campaign::in_order<bool>(
      count, std::max(1u, std::thread::hardware_concurrency()),
      [&](std::uint64_t k) {
        work(k);
        return true;
      },
      [](std::uint64_t, bool more) { return more; });
}

using Scores = std::vector<double>;

/// Red losses less blue ones, and both together: what is the same on both sides shows there.
constexpr const char* kOutcomes[] = {"red - blue losses", "red + blue losses"};
constexpr std::size_t kCount = std::size(kOutcomes);
/// Seeds of a mission with few values, which has few rows, for each of one with all of them.
constexpr std::size_t kMoreSeeds = 4;
void fly(const std::shared_ptr<const scenario::Scenario>& scenario, std::uint64_t seed,
         double* outcomes) {
  const debrief::Health health = debrief::measure(scenario, seed);
  const auto blue = static_cast<double>(health.lost[0]), red = static_cast<double>(health.lost[1]);
  outcomes[0] = red - blue;
  outcomes[1] = red + blue;
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

/// What an argument asks for.
struct Mission {
  explicit Mission(std::string argument) : only_new(argument.starts_with('+')) {
    std::istringstream words(argument.substr(only_new ? 1 : 0));
    std::getline(words, request.file, ',');
    name = std::filesystem::path(request.file).stem().string();
    for (std::string set; std::getline(words, set, ',');
         name += ", " + set.substr(set.find('=') + 1))
      request.sets.push_back(set);
  }
  bool only_new;
  std::string name;
  scenario::LoadRequest request;
};

/// One mission: the values that it reads, and what each of them does.
class Study {
 public:
  /// Takes what it studies out of `left` where that is all that it looks at.
  Study(std::string home, Mission mission, std::size_t seeds, Kept& kept,
        const std::vector<Judgement>& all, std::set<const Judgement*>& left)
      : home_(std::move(home)),
        mission_(std::move(mission)),
        seeds_(mission_.only_new ? kMoreSeeds * seeds : seeds),
        kept_(kept),
        base_(kCount * seeds_) {
    const auto scenario = scenario::load(mission_.request, scenario::Source::disk(home_));
    on_all_cores(seeds_, [&](std::size_t k) { ::fly(scenario, k + 1, &base_[kCount * k]); });
    for (const bool costly : {true, false})  // launch zones are flown anew for a changed missile
      for (const Judgement& j : all)
        if (scenario->files.contains(j.file) && is_costly(j) == costly &&
            (!mission_.only_new || left.contains(&j)))
          values_.push_back(&j);
    for (const Judgement* j : values_)
      left.erase(j);
    std::string id;  // what was kept belongs to these runs
    for (const double score : base_)
      id += fmt::format("{} ", score);
    for (const Judgement* j : values_)
      id += j->name + j->now;
    id_ = fmt::format("{} {:x}", mission_.name, std::hash<std::string>{}(id));
  }

  void fly() {
    const auto costly = static_cast<std::size_t>(
        std::ranges::count_if(values_, [](auto* j) { return is_costly(*j); }));
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
      fmt::print(stderr, "\r{}: {} of {} rows ", mission_.name, ++done, rows_.size());
    };
    on_all_cores(design.plots(), [&](std::size_t plot) {
      for (std::size_t i = 0; i < in_plot; ++i)
        fly_row(plot * in_plot + i);
    });
    fmt::print(stderr, "\n");
  }

  /// Of all runs.
  [[nodiscard]] double mean(std::size_t outcome) const {
    double sum = 0;
    for (const Row& row : rows_)
      for (std::size_t k = 0; k < seeds_; ++k)
        sum += row.scores[kCount * k + outcome];
    return sum / static_cast<double>(runs());
  }
  /// Half the 95 % interval of an effect. The design gives those of all values the same variance:
  /// their scatter over the seeds is taken together.
  [[nodiscard]] double half(std::size_t outcome) const {
    double squares = 0;
    const auto n = static_cast<double>(seeds_);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const Scores by_seed = effects(i, outcome);
      const double mean = std::accumulate(by_seed.begin(), by_seed.end(), 0.0) / n;
      for (const double x : by_seed)
        squares += (x - mean) * (x - mean);
    }
    const double freedom = static_cast<double>(values_.size()) * (n - 1);
    return (1.96 + 2.4 / freedom) * std::sqrt(squares / freedom / n);  // Student's t, to 2 % from 9
  }
  [[nodiscard]] std::size_t runs() const { return rows_.size() * seeds_; }
  [[nodiscard]] const Mission& mission() const { return mission_; }
  [[nodiscard]] bool reads(const Judgement& j) const {
    return std::ranges::find(values_, &j) != values_.end();
  }
  [[nodiscard]] double mean_effect(const Judgement& j, std::size_t outcome) const {
    const Scores by_seed = effects(
        static_cast<std::size_t>(std::ranges::find(values_, &j) - values_.begin()), outcome);
    return std::accumulate(by_seed.begin(), by_seed.end(), 0.0) / static_cast<double>(seeds_);
  }
  /// "-0.12", from 0.8 to 1.2; bold if 0 is outside of its interval, "" of what is not studied.
  [[nodiscard]] std::string effect(const Judgement& j, std::size_t outcome) const {
    if (!reads(j))
      return "";
    const double mean = mean_effect(j, outcome);
    const Scores* refused = kept_.find(refused_key(j));
    return fmt::format("{0}{1:+.2f}{0}{2}", std::fabs(mean) > half(outcome) ? "**" : "", mean,
                       refused == nullptr     ? ""
                       : refused->front() > 0 ? " (to 1)"
                                              : " (from 1)");
  }

 private:
  struct Row {
    std::vector<int> signs{};  ///< of the values
    Scores scores{};
  };
  /// From 0.8 to 1.2 of a value, by seed.
  [[nodiscard]] Scores effects(std::size_t value, std::size_t outcome) const {
    Scores by_seed(seeds_);
    for (const Row& row : rows_)
      for (std::size_t k = 0; k < seeds_; ++k)
        by_seed[k] += 2 * row.signs[value] * row.scores[kCount * k + outcome] /
                      static_cast<double>(rows_.size());
    return by_seed;
  }
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
        return scenario::load(mission_.request, std::move(source));
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

  std::string home_;
  Mission mission_;
  std::string id_;
  std::size_t seeds_;
  Kept& kept_;
  Scores base_;
  std::vector<const Judgement*> values_;
  std::vector<Row> rows_;
};

/// "[1.45, ..., 0.40]" of a long list.
std::string brief(const std::string& now) {
  const std::size_t first = now.find(", "), last = now.rfind(", ");
  return first == last ? now : now.substr(0, first) + ", ..." + now.substr(last);
}

/// A table of what every mission that is studied whole says of each value, and one of the rest.
void print(const std::deque<Study>& studies, const std::vector<Judgement>& all) {
  std::string runs = "Runs:", head, line, now, rest;
  for (const Study& study : studies) {
    const std::string& name = study.mission().name;
    runs += fmt::format(" {} of {},", study.runs(), name);
    if (study.mission().only_new)
      for (const Judgement& j : all)
        rest += study.reads(j) ? fmt::format("\n| {} | {} | {} | {} ± {:.2f} | {} ± {:.2f} |",
                                             j.name, brief(j.now), name, study.effect(j, 0),
                                             study.half(0), study.effect(j, 1), study.half(1))
                               : "";
    else
      for (std::size_t o = 0; o < kCount; ++o) {
        head += fmt::format(" {}: {}, ± {:.2f} |", name, kOutcomes[o], study.half(o));
        line += " ---: |";
        now += fmt::format(" {:+.2f} |", study.mean(o));
      }
  }
  runs.back() = '.';
  fmt::print("{}\n\n", runs);
  fmt::print("| from 0.8 to 1.2 of | now |{}\n| --- | ---: |{}\n| mean of all runs | |{}\n", head,
             line, now);
  std::string unread;
  std::multimap<double, std::string> lines;  // the largest effect first, in intervals
  for (const Judgement& j : all) {
    std::string cells;
    double largest = -1;
    for (const Study& study : studies)
      for (std::size_t o = 0; o < kCount && !study.mission().only_new; ++o) {
        cells += fmt::format(" {} |", study.effect(j, o));
        if (study.reads(j))
          largest = std::max(largest, std::fabs(study.mean_effect(j, o)) / study.half(o));
      }
    if (largest >= 0)
      lines.emplace(-largest, fmt::format("| {} | {} |{}\n", j.name, brief(j.now), cells));
    else if (std::ranges::none_of(studies, [&](auto& s) { return s.reads(j); }))
      unread += fmt::format("{} {}", unread.empty() ? "" : ",", j.name);
  }
  for (const auto& [_, row] : lines)
    fmt::print("{}", row);
  if (!rest.empty())
    fmt::print(
        "\n| from 0.8 to 1.2 of | now | mission | {} | {} |\n| --- | ---: | --- | ---: | ---: "
        "|{}\n",
        kOutcomes[0], kOutcomes[1], rest);
  if (!unread.empty())
    fmt::print("\nNo mission here reads{}.\n", unread);
}

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
    const std::filesystem::path zones = argv[2] + std::string(".zones");
    std::filesystem::create_directories(zones);
    const auto file = [zones](std::uint64_t key) { return zones / fmt::format("{:016x}", key); };
    model::weapon::kept_zones().use(
        {.load = [file](std::uint64_t key) { return text_of(file(key)); },
         .save =
             [file](std::uint64_t key, std::string_view zone) {
               std::ofstream(file(key), std::ios::binary) << zone;
             }});
    std::set<const Judgement*> left;  // nobody has studied them yet
    for (const Judgement& j : all)
      left.insert(&j);
    std::deque<Study> studies;
    for (int i = 4; i < argc; ++i)
      studies.emplace_back(home, Mission(argv[i]), seeds, kept, all, left).fly();
    print(studies, all);
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 2;
  }
}
