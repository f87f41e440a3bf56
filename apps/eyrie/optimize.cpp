// SPDX-License-Identifier: MIT
/// \file  optimize: which values of a campaign's factors are best, and how sure that is.
#include <chrono>

#include "campaign/search.hpp"
#include "campaign/summary.hpp"
#include "campaign/whole_scenario.hpp"
#include "campaigns.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "core/text.hpp"
#include "disk/output.hpp"
#include "record/json_text.hpp"
#include "say.hpp"
#include "scenario/plugin_file.hpp"

namespace eyrie::app {
namespace {

using namespace campaign;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr const char* kLog = "candidates.csv";
constexpr const char* kWinner = "winner.yaml";

/// The log in a folder; "" if there is none yet.
std::string read_log(const std::string& path) {
  disk::FileRead read = disk::read_file(path, std::size_t{1} << 30);
  if (!read.missing && !read.problem.empty())
    refuse("{}: {}", path, read.problem);
  return std::move(read.bytes);
}

void write_file(const std::string& path, std::string_view text) {
  disk::OutputFile file(path, true);
  file.sink().write(text);
  file.commit();
}

void print_generation(const Search& search, const Generation& g, double seconds) {
  const auto& score = g.scores[g.best];
  const std::string best = score ? fmt::format("{} {:.4g} with {}", search.measure, *score,
                                               cell_text(search.spec, g.cells[g.best]))
                                 : fmt::format("no candidate has {}", search.measure);
  say("generation {:>3} of {}: {}; step {:.3f}, {} s\n", g.number + 1, search.generations, best,
      g.sigma, static_cast<int>(seconds + 0.5));
}

Json values_json(const Search& search, const Cell& cell) {
  Json json;
  for (std::size_t f = 0; f < cell.values.size(); ++f)
    json[search.spec.factors[f].name] = cell.values[f];
  return json;
}

void tell_generation(const Search& search, const Generation& g) {
  const auto& score = g.scores[g.best];
  const Json json{{"generation", g.number + 1},
                  {"of", search.generations},
                  {"score", score ? number_or_null(*score) : Json()},
                  {"values", values_json(search, g.cells[g.best])},
                  {"step", g.sigma}};
  say("{}\n", Composed{record::json_text(json)});
}

/// Of the ends of a search; the proof by measure.
Json end_json(const Search& search, const std::string& folder, const std::optional<Winner>& found,
              const std::optional<std::vector<Evidence>>& evidence) {
  Json json{{"search", search.spec.name},
            {"ended", evidence ? "complete" : "interrupted"},
            {"folder", folder}};
  if (!evidence)
    return json;
  json["values"] = values_json(search, found->cell);
  json["set"] = sets_of(search.spec, found->cell);
  if (found->generation)
    json.update({{"of_generation", *found->generation + 1}, {"middle_refused", found->refusal}});
  json["seeds"] = search.proof;
  for (const Evidence& e : *evidence) {
    const auto& d = e.difference;
    json["proof"][e.measure.name] = {
        {"before", estimate_json(e.before)},
        {"after", estimate_json(e.after)},
        {"difference", d ? estimate_json({d->n, d->value, d->interval}) : Json()},
        {"p", d ? Json(d->p) : Json()}};
  }
  return json;
}

/// A row per measure.
std::string evidence_text(const Search& search, const std::vector<Evidence>& all) {
  std::string text = fmt::format("{:<14} {:>26} {:>26} {:>30} {:>8} {:>8}\n",
                                 counted(search.proof, "seed") + " each", "before", "after",
                                 "difference", "pairs", "p");
  for (const Evidence& e : all) {
    const auto& d = e.difference;
    const auto shown = [&](const Estimate& of) {
      return estimate_text(of, e.measure.kind) +
             (of.value && of.n != search.proof ? fmt::format(" of {}", of.n) : "");
    };
    const std::string difference = !d ? "-"
                                   : d->interval
                                       ? fmt::format("{:+.4g} ({:+.4g} to {:+.4g})", d->value,
                                                     d->interval->low, d->interval->high)
                                       : fmt::format("{:+.4g} (no bounds)", d->value);
    text += fmt::format("{:<14} {:>26} {:>26} {:>30} {:>8} {:>8}\n", e.measure.name,
                        shown(e.before), shown(e.after), difference, d ? d->n : 0,
                        d ? fmt::format("{:.2g}", d->p) : "-");
  }
  return text;
}

}  // namespace

int optimize(const FlightsOptions& options) {
  const auto search = parse_search(read_text(options.file), options.file);
  Spec probe = probe_of(*search);
  const CampaignSource source(probe, options.plugins, options.includes);
  const std::string folder = options.out.empty()
                                 ? fmt::format("searches/{}", file_name_from(search->spec.name))
                                 : options.out;
  const std::string log_path = fmt::format("{}/{}", folder, kLog);
  const std::string origin = fmt::format("eyrie optimize; what it is flown with has the hash {}",
                                         hash_text(source.hash()));
  const disk::Handle lock = disk::work_folder(
      folder, "search", [](const std::string& name) { return name == kLog; }, options.resume);
  SearchLog log(*search, origin, read_log(log_path), log_path);

  std::uint64_t faults = 0;
  std::string first_fault;
  listen_for_interrupts();
  const auto begun = Clock::now();
  SearchRun run{.workers = options.workers ? options.workers : cores(),
                .given_up = interrupted,
                .tell =
                    [&](const Generation& generation, const SearchLog& now) {
                      write_file(log_path, now.text());
                      if (options.json)
                        return tell_generation(*search, generation);
                      print_generation(*search, generation,
                                       std::chrono::duration<double>(Clock::now() - begun).count());
                    },
                .fault =
                    [&](const std::string& what, const std::string& command) {
                      if (faults++ == 0)
                        first_fault = fmt::format("{}; it is shown by\n  {}", what, command);
                    }};
  const auto tell_faults = [&] {
    if (faults)
      complain("eyrie: {} ended with a fault, which counts for nothing, the first with {}\n",
               counted(faults, "flight"), lines(first_fault));
  };
  std::optional<Winner> found;
  try {
    found = campaign::optimize(*search, source.load(), log, run);
  } catch (const ConfigError& error) {
    if (!faults)
      throw;
    tell_faults();
    complain("{}\n", lines(error.what()));
    return 1;
  }
  const auto evidence = found ? prove(*search, found->cell, source.load(), run) : std::nullopt;
  tell_faults();
  const int code = faults ? 1 : 0;
  if (!evidence) {
    if (options.json)
      say("{}\n", Composed{record::json_text(end_json(*search, folder, found, evidence))});
    else
      say("interrupted; eyrie optimize {} --out {} --resume goes on\n",
          scenario::shell_word(options.file), scenario::shell_word(folder));
    return code;
  }
  const std::string table = evidence_text(*search, *evidence);
  std::string head = fmt::format("# The scenario of the search '{}' with {}.\n", search->spec.name,
                                 cell_text(search->spec, found->cell));
  for (std::size_t begin = 0, end; begin < table.size(); begin = end + 1) {
    end = table.find('\n', begin);
    head += fmt::format("# {}\n", table.substr(begin, end - begin));
  }
  const std::vector<std::string> sets = sets_of(search->spec, found->cell);
  const std::string winner = fmt::format("{}/{}", folder, kWinner);
  const WholeScenario whole = whole_scenario(source.scenario(), sets, source.files());
  const std::string command = fmt::format("eyrie fly {}{}", scenario::shell_word(winner),
                                          allowances(winner, whole.folders));
  write_file(winner, printable_lines(head + "# " + command + "\n") + whole.text);
  if (options.json) {
    say("{}\n", Composed{record::json_text(end_json(*search, folder, found, evidence))});
    return code;
  }
  if (found->generation)
    say("\nthe scenario refuses the middle of the last generation; the best candidate of "
        "generation {} takes its place:\n{}\n",
        *found->generation + 1, lines(found->refusal));
  say("\n{}\n{}\n", cell_text(search->spec, found->cell), lines(table));
  for (const std::string& set : sets)
    say("--set {} ", scenario::shell_word(set));
  say("\nas a scenario of its own: {}\n", command);
  return code;
}

}  // namespace eyrie::app
