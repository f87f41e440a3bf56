// SPDX-License-Identifier: MIT
/// \file  debrief: a recorded run as a page that explains every decision.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "commands.hpp"
#include "interrupt.hpp"
#include "locate.hpp"
#include "output.hpp"
#include "page/page.hpp"
#include "page/page_data.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

/// Says on a terminal how far it is.
class Counter {
 public:
  explicit Counter(double end) : end_(end), shown_(::isatty(STDERR_FILENO)) {}
  ~Counter() {
    if (shown_ && percent_ >= 0)
      complain("{}", Composed{"\r\033[K"});
  }
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  void at(double time) {
    const int percent = static_cast<int>(100 * time / end_);
    if (!shown_ || percent == percent_)
      return;
    percent_ = percent;
    complain("{}debrief page: {} %", Composed{"\r"}, percent);
    std::fflush(stderr);
  }

 private:
  double end_;
  bool shown_;
  int percent_ = -1;
};

std::optional<std::string> viewer() {
  const std::string file = viewer_file();
  std::ifstream in(file, std::ios::binary);
  if (file.empty() || !in)
    return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

std::string data_of(const debrief::Recorded& recorded) {
  Counter counter(static_cast<double>(recorded.last_step()) * recorded.scenario->simulation->dt());
  return page::page_data(recorded, [&](double time) {
    counter.at(time);
    return !interrupted();
  });
}

/// False after saying why.
bool write_page(const std::string& file, const std::string& text) {
  if (text.empty()) {
    complain("eyrie: {} is no debrief page of this version; build it again\n", viewer_file());
    return false;
  }
  OutputFile out(file);
  out.sink().write(text);
  return out.commit();
}

constexpr const char* kNoViewer =
    "the debrief page is not built: it needs npm and its packages; './eyrie fly' builds it when it "
    "can";

}  // namespace

PageWritten write_page(const debrief::Recorded& recorded, const std::string& file) {
  const auto shell = viewer();
  if (!shell)
    return {.problem = kNoViewer};
  const std::string data = data_of(recorded);
  if (data.empty())
    return {.problem = "the debrief page was interrupted; 'eyrie debrief' makes it"};
  if (!write_page(file, page::page_with(*shell, {&data, 1})))
    return {.failed = true};
  return {.written = true};
}

int debrief_page(const DebriefOptions& options) {
  const auto shell = viewer();
  if (!shell) {
    complain("eyrie: {}\n", kNoViewer);
    return 1;
  }
  std::vector<debrief::Recorded> runs;
  for (const std::string& run : options.runs) {
    auto opened = open_or_complain(run, options.plugins);
    if (!opened)
      return 2;
    runs.push_back(std::move(*opened));
  }
  const fs::path folder = fs::path(runs.front().file).parent_path();
  const auto file = free_or_complain(
      options.out, folder / (runs.size() > 1 ? "debrief-two.html" : "debrief.html"), options.force);
  if (!file)
    return 2;
  listen_for_interrupts();
  std::vector<std::string> data;
  for (const debrief::Recorded& run : runs) {
    data.push_back(data_of(run));
    if (data.back().empty()) {
      complain("eyrie: interrupted, nothing was written\n");
      return 130;
    }
  }
  if (!write_page(*file, page::page_with(*shell, data)))
    return 1;
  say("written to {}, {:.1f} MB\n", *file, static_cast<double>(fs::file_size(*file)) / 1e6);
  return 0;
}

}  // namespace eyrie::app
