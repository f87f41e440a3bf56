// SPDX-License-Identifier: MIT
/// \file  Draws docs/models/plots/ and writes docs/models/README.md; every claim is checked again.
/// usage: evidence HOME [--check]     --check: nothing is written, what is there must be the same
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include "evidence.hpp"

namespace {
using namespace eyrie::evidence;

/// What has something to show. A new one is a line here.
constexpr Evidence (*kTopics[])(const std::string& home) = {of_air_and_laws, of_flight, of_missiles,
                                                            of_sensors};

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// "Suite.Name" of every test below src/ and tests/.
std::set<std::string> tests_in(const std::string& home) {
  const std::regex begins(R"((?:TEST|TEST_F|TEST_P|RC_GTEST_PROP)\(\s*(\w+),\s*(\w+))");
  std::set<std::string> tests;
  for (const char* folder : {"/src", "/tests"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(home + folder))
      if (entry.path().string().ends_with("_test.cpp")) {
        const std::string text = text_of(entry.path());
        for (std::sregex_iterator i(text.begin(), text.end(), begins), end; i != end; ++i)
          tests.insert((*i)[1].str() + "." + (*i)[2].str());
      }
  return tests;
}

/// Why a row does not stand, or "".
std::string mistake(const Row& row, const std::set<std::string>& tests,
                    const std::set<std::string>& plots) {
  if (!tests.contains(row.test))
    return fmt::format("there is no test {}", row.test);
  if (!row.plot.empty() && !plots.contains(row.plot))
    return fmt::format("there is no plot {}", row.plot);
  const double off = row.published != 0 ? row.here / row.published - 1 : 0;
  if (row.tolerance == 0 && row.why.empty())
    return "it is not checked and does not say why";
  if (row.tolerance > 0 && !(std::fabs(off) <= row.tolerance))
    return fmt::format("{:.4g} is {:+.1f} % off the published {:.4g}, more than {:.3g} %", row.here,
                       100 * off, row.published, 100 * row.tolerance);
  return "";
}

constexpr const char* kHead = R"(# What is claimed of the models

One row for each claim that somebody else can check: what the model gives, what is published, how far they are apart, which
test holds it. `./eyrie evidence` writes this page and the plots from the models and the data as they are, and fails where a figure
is off by more than 10 % (the air: 0.02 %, the OLS-27 from ahead: 20 %) or a test is gone; `./eyrie evidence --check` writes nothing and fails where this page or a
plot is not what it would write. What is in parentheses is told and not checked, for the reason below the table. A row
without figures is a law: its test holds it. "Not seen" is a source that is cited from general knowledge and was not opened.

A new row or plot: `apps/evidence/`, a function that gives them and a line in `kTopics`.

| model | claim | here | published | deviation | source | test | plot |
| --- | --- | ---: | ---: | ---: | --- | --- | --- |
)";

std::string page(const Evidence& all) {
  std::string out = kHead, notes;
  std::map<std::string, int> numbers;
  for (const Row& r : all.rows) {
    std::string figures = " | | ";
    if (r.published != 0) {
      const int tenths = static_cast<int>(std::lround(1000 * (r.here / r.published - 1)));
      const std::string off = tenths ? fmt::format("{:+.1f} %", 0.1 * tenths) : "0.0 %";
      figures = fmt::format("{:.4g} | {:.4g} | {}", r.here, r.published,
                            r.tolerance > 0 ? off : "(" + off + ")");
    }
    if (!r.why.empty() && !numbers.contains(r.why)) {
      const int n = static_cast<int>(numbers.size()) + 1;
      numbers[r.why] = n;
      notes += fmt::format("{}. {}\n", n, r.why);
    }
    out += fmt::format("| [{}]({}) | {}{} | {} | {} | `{}` | {} |\n", r.model, r.page, r.claim,
                       r.why.empty() ? "" : fmt::format(" ({})", numbers[r.why]), figures, r.source,
                       r.test, r.plot.empty() ? "" : fmt::format("[plot](plots/{}.svg)", r.plot));
  }
  out += "\nNot checked, because:\n\n" + notes + "\n## Plots\n";
  for (const Plot& plot : all.plots)
    out += fmt::format("\n![{}](plots/{}.svg)\n", plot.title, plot.file);
  return out;
}

/// Writes the files, or says which are not like that; how many mistakes there are.
int put(const std::string& folder, const std::map<std::string, std::string>& files, bool check) {
  int mistakes = 0;
  std::filesystem::create_directories(folder + "/plots");
  for (const auto& [name, text] : files) {
    const std::string path = folder + "/" + name;
    if (text_of(path) == text)
      continue;
    if (check) {
      fmt::print(stderr, "docs/models/{}: not what ./eyrie evidence writes\n", name);
      ++mistakes;
    } else {
      std::ofstream(path, std::ios::binary) << text;
    }
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder + "/plots"))
    if (!files.contains("plots/" + entry.path().filename().string())) {
      fmt::print(stderr, "docs/models/plots/{}: nobody draws it\n",
                 entry.path().filename().string());
      ++mistakes;
    }
  return mistakes;
}

}  // namespace

int main(int argc, char** argv) {
  const bool check = argc == 3 && std::string(argv[2]) == "--check";
  if (argc < 2 || (argc > 2 && !check)) {
    fmt::print(stderr, "usage: ./eyrie evidence [--check]\n");
    return 2;
  }
  try {
    const std::string home = argv[1];
    Evidence all;
    for (const auto topic : kTopics) {
      Evidence some = topic(home);
      all.rows.insert(all.rows.end(), some.rows.begin(), some.rows.end());
      all.plots.insert(all.plots.end(), some.plots.begin(), some.plots.end());
    }
    std::map<std::string, std::string> files{{"README.md", page(all)}};
    std::set<std::string> plots;
    for (const Plot& plot : all.plots) {
      files["plots/" + plot.file + ".svg"] = svg(plot);
      plots.insert(plot.file);
    }
    int mistakes = put(home + "/docs/models", files, check);
    const std::set<std::string> tests = tests_in(home);
    for (const Row& row : all.rows)
      if (const std::string what = mistake(row, tests, plots); !what.empty()) {
        fmt::print(stderr, "{}: {}: {}\n", row.model, row.claim, what);
        ++mistakes;
      }
    fmt::print("{} claims, {} plots, {} mistakes\n", all.rows.size(), all.plots.size(), mistakes);
    return mistakes > 0 ? 1 : 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 2;
  }
}
