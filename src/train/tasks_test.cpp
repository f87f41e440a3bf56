// SPDX-License-Identifier: MIT
/// \file  docs/train.md has the tables of the tasks.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "train/task.hpp"

namespace eyrie::train {
namespace {

/// "| a | b |" of each line: its first word, and the rest.
std::string rows(std::string_view lines) {
  std::string text;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string_view line = lines.substr(0, end);
    const std::size_t word = std::min(line.find(' '), line.size());
    text += fmt::format("| `{}` | {} |\n", line.substr(0, word),
                        word == line.size() ? "" : line.substr(word + 1));
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return text;
}

std::string range_of(const Reward& r) {
  return r.high > r.low ? fmt::format("{:g} to {:g} m", r.low, r.high) : "";
}

std::string tasks_markdown() {
  std::string text;
  for (const TaskSpec& task : tasks()) {
    text += fmt::format("### {}\n\n{}. `{}`", task.name, task.help, task.scenario);
    for (const std::string& set : task.sets)
      text += fmt::format(", `{}`", set);
    text += fmt::format("; learners {}.\n\n", fmt::join(task.learners, ", "));
    text += "| observed | as |\n| --- | --- |\n" + rows(task.observation) + '\n';
    if (task.votes)
      text += fmt::format("Actions are the votes, 0 to {:g}, of the children of `{}`.\n\n",
                          task.votes->most, task.votes->arbiter);
    else
      text += "| action | range |\n| --- | --- |\n" + rows(task.controls) + '\n';
    text += "| reward | weight | range |\n| --- | ---: | --- |\n";
    for (const Reward& r : task.rewards)
      text += fmt::format("| `{}` | {:g} | {} |\n", enum_name(r.term), r.weight, range_of(r));
    if (&task != &tasks().back())
      text += '\n';
  }
  return text;
}

TEST(Tasks, AreWhatThePageSays) {
  std::ifstream file("docs/train.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  EXPECT_NE(page.find(tasks_markdown()), std::string::npos)
      << "the tables at the end of docs/train.md are others:\n"
      << tasks_markdown();
}

}  // namespace
}  // namespace eyrie::train
