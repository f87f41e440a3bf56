// SPDX-License-Identifier: MIT
#include "typed.hpp"

#include <sstream>

#include "core/diagnostics.hpp"
#include "core/text.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}
/// The subcommand that was meant, or null.
const CLI::App* command_of(const CLI::App& app, std::span<char*> words) {
  for (const CLI::App* command : commands_of(app))
    if (words.size() > 1 && command->get_name() == words[1])
      return command;
  return nullptr;
}

/// A command or an option that there is not, with the nearest one; "" if that is not what is wrong.
std::string unknown_text(const CLI::App& app, std::span<char*> words) {
  std::vector<std::string> names;
  if (const CLI::App* command = command_of(app, words)) {
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames())
        names.push_back("--" + name);
    for (const std::string_view word : words.subspan(2)) {
      const std::string_view name = word.substr(0, word.find('='));
      if (word == "--")
        break;
      if (word.starts_with("--") && std::find(names.begin(), names.end(), name) == names.end())
        return fmt::format("{} has no option {}{}", command->get_name(), quote(name),
                           did_you_mean(name, names));
    }
    return "";
  }
  for (const CLI::App* command : commands_of(app))
    names.push_back(command->get_name());
  return words.size() > 1 && words[1][0] != '-'
             ? fmt::format("there is no command {}{}", quote(words[1]),
                           did_you_mean(words[1], names))
             : "";
}

}  // namespace

int say_wrong(const CLI::App& app, std::span<char*> words, std::string_view problem) {
  constexpr std::size_t kLongest = 300;
  complain("eyrie: {}\n{} --help says more\n",
           printable(problem.substr(0, problem.find('\n')), kLongest),
           command_of(app, words) ? fmt::format("eyrie {}", words[1]) : "eyrie");
  return 2;
}

int say_mistake(const CLI::App& app, const CLI::ParseError& e, std::span<char*> words) {
  std::ostringstream out, err;
  if (app.exit(e, out, err) == 0) {
    say("{}", Composed{out.str()});
    return 0;
  }
  const std::string unknown = unknown_text(app, words);
  return say_wrong(app, words, unknown.empty() ? e.what() : unknown);
}

}  // namespace eyrie::app
