// SPDX-License-Identifier: MIT

#include <fmt/ranges.h>

#include <map>
#include <sstream>

#include "arguments.hpp"
#include "core/diagnostics.hpp"
#include "core/text.hpp"
#include "line.hpp"
#include "say.hpp"
#include "scenario/plugin_file.hpp"

namespace eyrie::app {
namespace {

using Names = std::vector<std::string>;

const CLI::App* command_of(const CLI::App& app, std::span<char*> words) {
  return words.size() > 1 ? command_named(app, words[1]) : nullptr;
}

Names options_of(const CLI::App& command) {
  Names names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  return names;
}

/// "new behavior"
std::string name_of(const CLI::App& command) {
  const CLI::App* above = command.get_parent();
  return above && above->get_parent() ? name_of(*above) + " " + command.get_name()
                                      : command.get_name();
}

/// The option that may be meant: a near one, one that begins as it does, what needs no option, or
/// that of another command.
std::string option_hint(const CLI::App& app, const CLI::App& command, const std::string& wrong) {
  const Names names = options_of(command);
  if (std::ranges::find(names, wrong) != names.end())  // behind one '-'
    return fmt::format("; did you mean '{}'?", wrong);
  if (std::string hint = did_you_mean(wrong, names); !hint.empty())
    return hint;
  Names longer;
  for (const std::string& name : names)
    if (name.starts_with(wrong) || (wrong.size() > 3 && wrong.starts_with(name)))
      longer.push_back("'" + name + "'");
  if (!longer.empty())
    return fmt::format("; did you mean {}?", fmt::join(longer, " or "));
  Names arguments;
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional())
      arguments.push_back(option->get_name());
  if (!did_you_mean(wrong.substr(2), arguments).empty())
    return fmt::format("; that needs none: eyrie {} {}", name_of(command), usage_of(command));
  std::map<std::string, Names> others;
  Names all;
  for (const CLI::App* one : commands_of(app))
    for (const std::string& name : options_of(*one)) {
      others[name].push_back("'" + one->get_name() + "'");
      all.push_back(name);
    }
  const std::string hint = did_you_mean(wrong, all);
  for (const auto& [name, commands] : others)
    if (!hint.empty() && did_you_mean(wrong, Names{name}) == hint)
      return fmt::format("; {} is an option of {}", name == wrong ? "it" : "'" + name + "'",
                         fmt::join(commands, ", "));
  return "";
}

/// An option that a command has not, or "".
std::string unknown_option(const CLI::App& app, const CLI::App& command, std::span<char*> words) {
  const Names names = options_of(command);
  for (const std::string_view word : words) {
    if (word == "--")
      break;
    std::string name(word.substr(0, word.find('=')));
    const bool number = word.size() > 1 && (std::isdigit(word[1]) || word[1] == '.');
    if (!word.starts_with('-') || number || name.size() < 2 || name == "-h")
      continue;
    if (std::ranges::find(names, name) == names.end())
      return fmt::format("{} has no option {}{}", name_of(command), quote(name),
                         option_hint(app, command, (name[1] == '-' ? "" : "-") + name));
  }
  return "";
}

/// A required argument that was not given, or "".
std::string missing_argument(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (option->get_required() && option->count() == 0)
      return fmt::format("{} needs {}: {}", name_of(command), option->get_name(),
                         option->get_description());
  return "";
}

/// A word too many: an option without its dashes, or the rest of a value with a blank in it.
std::string word_too_many(const CLI::App& command, const std::string& extra,
                          std::span<char*> words) {
  std::string hint;
  const std::size_t equals = extra.find('=');
  if (equals != std::string::npos && command.get_option_no_throw("--" + extra.substr(0, equals)))
    hint = fmt::format("; did you mean '--{}'?", extra);
  for (std::size_t i = 2; i < words.size(); ++i)
    if (words[i] == extra && std::string_view(words[i - 2]).starts_with("--") &&
        words[i - 1][0] != '-')
      hint = fmt::format("; did you mean {} '{}{}{}'?", words[i - 2], words[i - 1],
                         words[i - 2] == std::string_view("--set") ? '=' : ' ', extra);
  return fmt::format("{} has no use for {}{}", name_of(command), quote(extra), hint);
}

/// A flag that was given a value, or "".
std::string flag_with_value(const CLI::App& command, std::span<char*> words) {
  for (const std::string_view word : words) {
    const std::string name(word.substr(0, word.find('=')));
    const CLI::Option* option = name == word ? nullptr : command.get_option_no_throw(name);
    if (option && option->get_expected_max() == 0)
      return name;
    if (word == "--")
      break;
  }
  return "";
}

/// What to say if a wrong value is what the command is about, behind an option that needs none;
/// or "".
std::string taken_as_value(const CLI::App& command, std::span<char*> words, std::string_view said) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const CLI::Option* option = command.get_option_no_throw(words[i]);
    if (option && option->get_items_expected_min() == 0 && option->get_expected_max() > 0 &&
        !is_digit(words[i + 1][0]) &&
        said.starts_with(fmt::format("{}: {}", words[i], quote(words[i + 1]))))
      return fmt::format("; did you mean eyrie {} {} {}?", name_of(command),
                         scenario::shell_word(words[i + 1]), words[i]);
  }
  return "";
}

/// The first that is one more than an argument takes, or "".
std::string argument_too_many(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (const auto most = static_cast<std::size_t>(option->get_expected_max());
        option->get_positional() && option->results().size() > most)
      return option->results()[most];
  return "";
}

/// What is wrong with the words of a command.
std::string problem_in(const CLI::App& app, const CLI::App& command, const CLI::ParseError& e,
                       std::span<char*> words) {
  const std::string wrong = words.empty() ? "" : words[0];
  if (const CLI::App* one = command_named(command, wrong))
    return problem_in(app, *one, e, words.subspan(1));
  const bool required = dynamic_cast<const CLI::RequiredError*>(&e);
  const Names below = command_names(command);
  const std::string usage = fmt::format("eyrie {} {}", name_of(command), usage_of(command));
  if (!below.empty() && required && !wrong.empty() && wrong[0] != '-') {
    const std::string hint = did_you_mean(wrong, below);
    return fmt::format("{} begins no {}{}", name_of(command), quote(wrong),
                       hint.empty() ? "; say " + usage : hint);
  }
  if (std::string unknown = unknown_option(app, command, words); !unknown.empty())
    return unknown;
  if (!below.empty() && required)
    return "say what: " + usage;
  if (required) {
    if (std::string missing = missing_argument(command); !missing.empty())
      return missing;
    Names any;  // as require_option(1) wants
    for (const CLI::Option* option : command.get_options())
      if (option->get_name() != "--help")
        any.push_back(option->get_name());
    return fmt::format("{} needs one of {}", name_of(command), fmt::join(any, ", "));
  }
  const std::string said = e.what();
  if (const std::string flag = flag_with_value(command, words); !flag.empty())
    return flag + " takes no value";
  if (const std::string extra = argument_too_many(command); !extra.empty())
    return word_too_many(command, extra, words);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&e) && said.starts_with("--"))
    return fmt::format("{} {}", said.substr(0, said.find(':')),
                       said.find("At Most") == said.npos ? "needs a value" : "is given twice");
  if (dynamic_cast<const CLI::ExtrasError*>(&e)) {
    const Names extra = command.remaining();
    return word_too_many(command, extra.empty() ? said : extra.front(), words);
  }
  return said + taken_as_value(command, words, said);
}

/// A command that there is not, with the nearest one.
std::string unknown_command(const CLI::App& app, std::string_view word) {
  Names names = command_names(app);
  names.push_back("help");
  const char* script = std::getenv("EYRIE_SCRIPT");  // ./eyrie has more commands
  std::istringstream more(script ? script : "");
  for (std::string name; more >> name;)
    names.push_back(name);
  std::string hint = did_you_mean(word, names);
  if (hint.empty())
    hint = did_you_mean("--" + std::string(word), options_of(app));
  return fmt::format("there is no command {}{}", quote(word),
                     hint.empty() ? nearest_or_all(word, names) : hint);
}

}  // namespace

void refuse_flag_values(CLI::App& app) {
  for (CLI::Option* option : app.get_options())
    if (option->get_expected_max() == 0)
      option->disable_flag_override();
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    refuse_flag_values(*command);
}

std::string word_behind_help(const CLI::App& app, std::span<char*> words) {
  const CLI::App* command = command_of(app, words);
  if (words.size() <= 3 || !command)
    return empty_text(words);
  const CLI::App* below = command_named(*command, words[3]);
  const std::size_t extra = below ? 4 : 3;
  return words.size() > extra ? "help has no use for " + quote(words[extra]) : "";
}

int say_wrong(const CLI::App& app, std::span<char*> words, std::string_view problem) {
  constexpr std::size_t kLongest = 300;
  complain("eyrie: {}\n{} --help says more\n",
           printable(problem.substr(0, problem.find('\n')), kLongest),
           command_of(app, words) ? fmt::format("eyrie {}", words[1]) : "eyrie");
  return 2;
}

int say_mistake(const CLI::App& app, const CLI::ParseError& e, std::span<char*> words) {
  const std::string_view first = words.size() > 1 ? words[1] : "";
  const CLI::App* command = command_named(app, first);
  if (!first.empty() && !command && !first.starts_with('-'))
    return say_wrong(app, words, unknown_command(app, first));
  std::ostringstream out, err;
  if (app.exit(e, out, err) == 0) {
    say("{}", Composed{out.str()});
    return 0;
  }
  if (command)
    return say_wrong(app, words, problem_in(app, *command, e, words.subspan(2)));
  const std::string option =
      unknown_option(app, app, words.subspan(std::min<std::size_t>(1, words.size())));
  return say_wrong(app, words, option.empty() ? "say what to do, such as eyrie fly sweep" : option);
}

}  // namespace eyrie::app
