// SPDX-License-Identifier: MIT
#include "line.hpp"

#include <filesystem>
#include <map>

#include "arguments.hpp"
#include "commands.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "locate.hpp"
#include "model/events.hpp"
#include "record/run_file.hpp"
#include "say.hpp"
#include "scenario/catalog.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

using Names = std::vector<std::string>;
constexpr std::size_t kWidth = 100;
const std::vector<std::string_view> kShells{"bash", "zsh", "fish", "man"};

/// Each can be typed as it stands: a test does, behind `eyrie fly merge`.
const std::map<std::string_view, Names>& examples() {
  static const std::map<std::string_view, Names> all{
      {"fly", {"eyrie fly sweep --seed 7", "eyrie fly merge --seeds 1..20"}},
      {"campaign",
       {"eyrie campaign tactics.yaml", "eyrie campaign tactics.yaml --resume --workers 2"}},
      {"report",
       {"eyrie report campaigns/tactics",
        "eyrie report campaigns/tactics --of losses --force "
        "--out losses.html"}},
      {"query",
       {"eyrie query campaigns/tactics 'SELECT count(*) FROM replicates'",
        "eyrie query campaigns/tactics 'SELECT winner, count(*) FROM decisions GROUP BY 1' "
        "--decisions '10 s'"}},
      {"optimize", {"eyrie optimize search.yaml", "eyrie optimize search.yaml --resume"}},
      {"explain",
       {"eyrie explain runs/latest", "eyrie explain runs/latest --player viper1 --at 0:40"}},
      {"whatif",
       {"eyrie whatif runs/latest --player viper1 --set root/wvr=fusion",
        "eyrie whatif runs/latest --player viper1 --set root/wvr=fusion --seeds 20"}},
      {"debrief", {"eyrie debrief runs/latest", "eyrie debrief runs/merge-4 runs/latest"}},
      {"serve", {"eyrie serve merge --rate 4", "eyrie serve runs/merge-4 runs/latest"}},
      {"playground", {"eyrie playground", "eyrie playground --out site"}},
      {"export",
       {"eyrie export runs/latest --to sqlite",
        "eyrie export runs/latest --to decisions --every '1 s'",
        "eyrie export runs/latest --to pcap"}},
      {"diff",
       {"eyrie diff runs/merge-4 runs/latest", "eyrie diff runs/merge-4 runs/latest --json"}},
      {"validate", {"eyrie validate mine.yaml", "eyrie validate sweep merge"}},
      {"zones", {"eyrie zones --check", "eyrie zones aim9 --draw"}},
      {"catalog", {"eyrie catalog pursue", "eyrie catalog --json-schema"}},
      {"replay", {"eyrie replay runs/latest", "eyrie replay runs/latest --workers 4"}},
      {"trust", {"eyrie trust build/libgreet.so", "eyrie trust --list"}},
      {"new", {"eyrie new behavior greet", "eyrie new behavior break_away"}},
      {"completion", {"eyrie completion bash", "eyrie completion man"}}};
  return all;
}

/// What stands behind an option: "N"; "" for a flag.
std::string value_of(const CLI::App& app, const CLI::Option& option) {
  static const std::map<std::string_view, std::string_view> kNames{{"set", "PATH=VALUE"},
                                                                   {"seeds", "FIRST..LAST"},
                                                                   {"plugin", "FILE"},
                                                                   {"out", "PATH"},
                                                                   {"until", "TIME"},
                                                                   {"at", "TIME"},
                                                                   {"from", "TIME"},
                                                                   {"player", "NAME"},
                                                                   {"event", "WORD"},
                                                                   {"part", "K/N"},
                                                                   {"of", "MEASURE"},
                                                                   {"to", "TIME"},
                                                                   {"every", "TIME"},
                                                                   {"decisions", "TIME"},
                                                                   {"remove", "FILE"},
                                                                   {"real-time", "RATE"},
                                                                   {"tacview", "PORT"},
                                                                   {"address", "ADDRESS"},
                                                                   {"tacview-password", "FILE"},
                                                                   {"dis", "ADDRESS"},
                                                                   {"dis-station", "NUMBERS"},
                                                                   {"dis-interface", "ADDRESS"},
                                                                   {"dis-threshold", "LIMITS"},
                                                                   {"ours", "NAMES"},
                                                                   {"altitude", "HEIGHT"},
                                                                   {"speed", "SPEED"},
                                                                   {"units", "UNITS"},
                                                                   {"allow-include", "FOLDER"}};
  if (option.get_items_expected_max() == 0)
    return "";
  const auto found = kNames.find(option.get_lnames().front());
  const bool number = found == kNames.end() || option.get_type_name() == "UINT";
  const std::string name(number                                               ? "N"
                         : found->first == "to" && app.get_name() == "export" ? "FORMAT"
                                                                              : found->second);
  return option.get_items_expected_min() == 0 ? "[=" + name + "]" : " " + name;
}

std::string capitals(std::string text) {
  for (char& c : text)
    c = to_capital(c);
  return text;
}

/// A line of help: "--seed N" or "SCENARIO", and what it is.
struct Line {
  std::string name, text;
};
std::vector<Line> lines_of(const CLI::App& app, bool positional) {
  std::vector<Line> lines;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional() != positional)
      continue;
    const std::string standard = option->get_default_str();
    const std::string text =
        option->get_description() + (standard.empty() || option->get_items_expected_min() == 0
                                         ? ""
                                         : fmt::format(" (default: {})", standard));
    if (positional)
      lines.push_back({capitals(option->get_name()), text});
    else if (option->get_lnames().front() != "help")
      lines.push_back({"--" + option->get_lnames().front() + value_of(app, *option), text});
  }
  return lines;
}

/// The words of a text, no line of it wider than kWidth; all but the first are indented.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::string out;
  std::size_t column = indent;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (column > indent && column + 1 + end - begin > kWidth) {
      out += "\n" + std::string(indent, ' ');
      column = indent;
    }
    out += column > indent ? " " : "";
    column += (column > indent) + end - begin;
    out.append(text, begin, end - begin);
    begin = end + 1;
  }
  return out;
}

std::string table(const std::vector<Line>& lines) {
  constexpr std::size_t kIndent = 24;
  std::string text = lines.empty() ? "" : "\n";
  for (const auto& [name, what] : lines)
    text += fmt::format("  {:<{}}{}{}\n", name, kIndent - 2,
                        name.size() + 3 > kIndent ? "\n" + std::string(kIndent, ' ') : "",
                        wrapped(what, kIndent));
  return text;
}

class Words final : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const override {
    std::string text = app->get_description() + "\n\n";
    if (!app->get_parent()) {
      std::vector<Line> commands;
      for (const CLI::App* command : commands_of(*app))
        commands.push_back({command->get_name(), command->get_description()});
      return text + "  eyrie COMMAND [options]\n" + table(commands) +
             "\neyrie help COMMAND has the options and examples of each; eyrie --version\n";
    }
    const CLI::App* command = app;
    while (command->get_parent()->get_parent())
      command = command->get_parent();
    text += fmt::format("  eyrie {} {}\n", command->get_name(), usage_of(*command));
    const CLI::App& last = commands_of(*app).empty() ? *app : *commands_of(*app).front();
    text += table(lines_of(last, true)) + table(lines_of(last, false)) + "\nExamples\n";
    for (const std::string& example : examples().at(command->get_name()))
      text += "  " + example + "\n";
    return text;
  }
};

/// A text for troff: no line of it is a request, no hyphen is broken.
std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text)
    out += c == '-' ? "\\-" : c == '\\' ? "\\e" : c == '\'' ? "\\(aq" : std::string(1, c);
  return out;
}

/// What an argument may be, by its name; none: nobody knows.
Names values_of(const std::string& name, std::span<char*> words) {
  const auto texts = [](const auto& all) { return Names(all.begin(), all.end()); };
  if (name == "--to")
    return texts(enum_names<ExportFormat>());
  if (name == "--units")
    return texts(enum_names<UnitSystem>());
  if (name == "shell")
    return texts(kShells);
  if (name == "--event")
    return listed(model::event_infos(), &model::EventInfo::name);
  if (name == "--player")
    return listed(open_run(words.size() > 1 ? words[1] : "", {}).scenario->roster.players,
                  &scenario::Roster::Player::name);
  if (name == "scenario" || name == "files")
    return names_in("scenarios");
  if (name == "missiles")
    return names_in("data/missiles");
  if (name == "node") {
    const scenario::Catalog all = scenario::make_catalog(scenario::Source::disk(home()));
    return texts(scenario::node_names(all));
  }
  if (name == "run" || name == "runs" || name == "left" || name == "right")
    return runs_in("runs");
  return {};
}

std::string manual(const CLI::App& app) {
  const auto list = [](const std::vector<Line>& lines) {
    std::string text;
    for (const auto& [name, what] : lines)
      text += fmt::format(".TP\n.B {}\n{}\n", roff(name), roff(what));
    return text;
  };
  std::string text = fmt::format(
      ".TH EYRIE 1\n.SH NAME\neyrie \\- simulate autonomous agents and explain what they do\n"
      ".SH SYNOPSIS\n.B eyrie\nCOMMAND [options]\n.SH DESCRIPTION\n{}\n.SH COMMANDS\n",
      roff(app.get_description()));
  for (const CLI::App* command : commands_of(app)) {
    const auto below = commands_of(*command);
    const CLI::App& last = below.empty() ? *command : *below.front();
    text += fmt::format(".SS eyrie {} {}\n{}\n{}{}.PP\nExamples:\n.nf\n", command->get_name(),
                        roff(usage_of(*command)), roff(command->get_description()),
                        list(lines_of(last, true)), list(lines_of(last, false)));
    for (const std::string& example : examples().at(command->get_name()))
      text += roff(example) + "\n";
    text += ".fi\n";
  }
  return text +
         ".SH ENVIRONMENT\n.TP\n.B EYRIE_HOME\nthe folder with data/ and scenarios/\n.TP\n"
         ".B EYRIE_VIEWER\nthe debrief page that runs are put into\n.TP\n.B NO_COLOR\n"
         "no colors on a terminal\n.SH EXIT STATUS\n0: done; 1: failed, or two runs differ; 2: a "
         "mistake in what was typed or in a file\n";
}

std::string completion_script(std::string_view shell) {
  if (shell == "bash")
    return R"sh(_eyrie() {
  local one
  COMPREPLY=()
  while IFS= read -r one; do
    COMPREPLY+=("$(printf %q "$one")")
  done < <("$1" completion --for "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}
complete -o default -F _eyrie eyrie ./eyrie
)sh";
  if (shell == "zsh")
    return R"sh(#compdef eyrie
_eyrie() {
  local -a found
  found=(${(f)"$($words[1] completion --for "${(@)words[2,CURRENT]}" 2>/dev/null)"})
  (( $#found )) && compadd -a found || _files
}
compdef _eyrie eyrie
)sh";
  return R"sh(complete -c eyrie -a '(set -l words (commandline -opc); $words[1] completion --for $words[2..] (commandline -ct) 2>/dev/null)'
)sh";
}

}  // namespace

std::vector<std::string> command_names(const CLI::App& app) {
  return listed(commands_of(app), [](const CLI::App* command) { return command->get_name(); });
}

const CLI::App* command_named(const CLI::App& app, std::string_view name) {
  for (const CLI::App* command : commands_of(app))
    if (command->get_name() == name)
      return command;
  return nullptr;
}

std::string usage_of(const CLI::App& app) {
  std::string usage;
  for (const CLI::App* below : commands_of(app))
    return below->get_name() + " " + usage_of(*below);
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional()) {
      const std::string name =
          capitals(option->get_name()) + (option->get_items_expected_max() > 1 ? " ..." : "");
      usage += option->get_required() ? name + " " : "[" + name + "] ";
    }
  return usage + "[options]";
}

void set_help(CLI::App& app) {
  app.formatter(std::make_shared<Words>());
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    set_help(*command);
}

void add_completion(CLI::App& app, std::function<int()>& chosen) {
  CLI::App* completion = app.add_subcommand(
      "completion", "What a shell needs to complete commands, options, scenarios and runs");
  const auto shell = std::make_shared<std::string>();
  completion
      ->add_option("shell", *shell,
                   "bash, zsh or fish: source what is printed, as in source <(eyrie completion "
                   "bash); man: the manual page")
      ->required()
      ->check(one_of(kShells));
  completion->callback([&, shell] {
    chosen = [&, shell] {
      say("{}", Composed{*shell == "man" ? manual(app) : completion_script(*shell)});
      return 0;
    };
  });
}

std::string completions(const CLI::App& app, std::span<char*> words) {
  std::string begun = words.empty() ? "" : words.back(), before, kept;
  if (words.size() > 1)
    before = words[words.size() - 2];
  // --units=m; bash, which breaks words there, has three
  bool joined = true;
  if (const auto sign = begun.find('='); begun.starts_with("--") && sign != begun.npos) {
    before = begun.substr(0, sign);
    kept = begun.substr(0, sign + 1);
    begun.erase(0, sign + 1);
  } else if (words.size() > 2 && begun == "=") {
    begun.clear();
  } else if (words.size() > 3 && before == "=") {
    before = words[words.size() - 3];
  } else {
    joined = false;
  }
  const CLI::App* command = words.size() > 1 ? command_named(app, words[0]) : nullptr;
  Names names = command_names(app);
  const bool help = words.size() == 2 && std::string_view(words[0]) == "help";
  if (words.size() < 2)
    names.emplace_back("help");
  if (command) {
    names = command_names(*command);
    const CLI::Option* option =
        before.starts_with("--") ? command->get_option_no_throw(before) : nullptr;
    const bool takes = option && (joined ? option->get_items_expected_max() > 0
                                         : option->get_items_expected_min() > 0);
    if (joined && !takes)
      return "";
    std::string asked = takes ? before : "";
    if (asked.empty() && begun.starts_with('-')) {
      for (const CLI::Option* one : command->get_options())
        if (!one->get_positional())
          names.push_back("--" + one->get_lnames().front());
    } else {
      for (const CLI::Option* one : command->get_options())
        if (asked.empty() && one->get_positional())
          asked = one->get_name();
      try {
        for (std::string& value : values_of(asked, words))
          names.push_back(std::move(value));
      } catch (const std::exception&) {  // a run that cannot be opened tells no names
      }
    }
  } else if (words.size() > 1 && !help) {
    return "";
  }
  std::ranges::sort(names);
  std::string text;
  for (const std::string& name : names)
    if (name.starts_with(begun))
      text += kept + printable(name) + "\n";
  return text;
}

}  // namespace eyrie::app
