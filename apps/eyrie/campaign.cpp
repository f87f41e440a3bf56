// SPDX-License-Identifier: MIT
/// \file  campaign: many flights of one scenario, as a file says, into a folder of results.
#include <filesystem>

#include "campaign/ranks.hpp"
#include "campaigns.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "core/text.hpp"
#include "locate.hpp"
#include "record/json_text.hpp"
#include "say.hpp"
#include "scenario/end_guard.hpp"
#include "scenario/plugin_file.hpp"

namespace eyrie::app {
namespace {

using namespace campaign;
using Json = nlohmann::ordered_json;

Json json_of(const Spec& spec, const Result& r) {
  Json json{{"cell", r.cell}, {"replicate", r.replicate}}, values = Json::object();
  for (std::size_t i = 0; i < r.values.size(); ++i)
    values["values"][spec.measures.columns[i].name] = r.values[i];
  json.update(flown_json(r.flown, values));
  return json;
}

/// What the file says, or the part of it that is wanted.
Spec spec_for(const CampaignOptions& options) {
  Spec spec = read_spec(options.file);
  if (options.part.empty())
    return spec;
  const auto part = two_numbers(options.part, "/");
  if (!part || part->first == 0 || part->first > part->second || part->second > Part::kMost)
    refuse("--part: '{}' is no part such as 3/16", options.part);
  check_parts(spec);
  spec.part = {part->first - 1, part->second};
  return spec;
}

/// Of a campaign that is complete, the cells whose interval is wider than the rule asks: they have
/// the most replicates.
std::uint64_t wide_cells(const Stopping& stop, const std::string& folder) {
  const Summary summary = read_summary(folder, stop.confidence);
  return static_cast<std::uint64_t>(std::ranges::count_if(summary.cells, [&](const auto& cell) {
    const auto& interval = cell.estimates[stop.measure].interval;
    return !interval || interval->width() > stop.width;
  }));
}

/// Where the results go.
std::string folder_for(const CampaignOptions& options, const Spec& spec, const std::string& whole) {
  const std::uint64_t of = parts_in(whole);
  if (!options.part.empty() && of != 0 && of != spec.part.of)
    refuse("eyrie: {} holds parts of {}, not of {}", quote_path(whole), of, spec.part.of);
  if (!options.part.empty())
    return part_folder(whole, spec.part);
  if (of != 0 && !options.join && !std::filesystem::exists(whole + "/" + kStoreName))
    refuse("eyrie: {} holds parts of a campaign: --join puts them together", quote_path(whole));
  return whole;
}

/// A campaign that may be flown.
struct Ready {
  Spec spec;
  CampaignSource source;
  std::vector<Cell> cells = cells_of(spec);

  explicit Ready(const CampaignOptions& options)
      : spec(spec_for(options)), source(spec, options.plugins, options.includes) {
    check_cells(spec, cells, source.load());
  }
};

/// What a rank flies with, under mpirun.
struct Hands {
  Scenarios scenarios;
  Pool pool;

  Hands(const Ready& ready, unsigned workers)
      : scenarios(ready.spec, ready.cells, ready.source.load(), workers + 1),
        pool(workers, [this, &ready](std::uint64_t cell, std::uint64_t replicate) {
          return fly_replicate(ready.spec, scenarios, cell, replicate, interrupted);
        }) {}
};

/// Under mpirun, another rank than the first. What goes wrong is said there.
void fly_for_rank_0(Link& link, const CampaignOptions& options, unsigned workers) {
  listen_for_interrupts();
  try {
    const Ready ready(options);
    Hands hands(ready, workers);
    serve(link, hands.pool, ready.source.hash());
  } catch (const std::exception& error) {
    fail(link, words_for(error));
  }
}

}  // namespace

int campaign(const CampaignOptions& options) {
  const std::unique_ptr<Link> link = open_mpi(mpi_library());
  const unsigned workers = options.workers ? options.workers : link ? 1 : cores();
  if (link && link->rank() != 0) {
    fly_for_rank_0(*link, options, workers);
    return 0;
  }
  const Ready ready(options);
  const auto& [spec, source, cells] = ready;
  const std::string whole =
      options.out.empty() ? fmt::format("campaigns/{}", file_name_from(spec.name)) : options.out;
  const std::string folder = folder_for(options, spec, whole);
  std::vector<std::string> parts;
  if (options.join)
    parts = whole_parts(whole, spec, cells.size(), source.origin());

  listen_for_interrupts();
  Store store(folder, spec, cells, source.origin(), options.resume || options.join);
  store.join(parts);
  const scenario::EndGuard guard(1, [&](const std::string& done) {
    if (const auto now = flying_now())
      complain(
          "eyrie: {} and ended the program; what was kept is there, and this flies it again:\n  "
          "{}\n",
          done, command_of(spec, cells[now->first], seed_of(spec, now->first, now->second)));
    else
      complain("eyrie: {} and ended the program\n", done);
  });
  std::optional<Hands> hands;
  std::unique_ptr<Crew> crew;
  if (link)
    crew = std::make_unique<Ranks>(*link, hands.emplace(ready, workers).pool, source.hash());
  else
    crew = std::make_unique<Threads>(spec, cells, source.load(), workers, interrupted);
  Ended ended = Ended::complete;
  if (options.json) {
    ended = run(spec, cells, store, *crew, [&](const Standing& standing) {
      say("{}\n", Composed{record::json_text(json_of(spec, *standing.last))});
    });
  } else {
    say("{}{}: {}, up to {} each, {}{}; results in {}\n", spec.name,
        options.part.empty() ? "" : ", part " + spec.part.text(), counted(cells.size(), "cell"),
        counted(spec.part.count(0, most_replicates(spec)), "replicate"),
        counted(link ? link->size() * workers : workers, "worker"), link ? " in all ranks" : "",
        folder);
    const Measure& measure = spec.measures.estimates[spec.stop ? spec.stop->measure : 0];
    std::optional<Progress> progress;
    ended = run(spec, cells, store, *crew, [&](const Standing& standing) {
      if (!progress)
        progress.emplace("replicates", standing.most - standing.done + standing.now);
      if (progress->due())
        progress->at(standing.now,
                     fmt::format("cell {}: {} {}", standing.cell, measure.name,
                                 estimate_text(standing.estimate->estimate(), measure.kind)));
    });
  }
  const std::string end(enum_name(ended));
  store.finish(options.part.empty() ? end : fmt::format("part {}, {}", options.part, end));
  const std::string log = fmt::format("{}/{}-wal", folder, kStoreName);
  if (std::error_code none; std::filesystem::exists(log, none))
    complain(
        "eyrie: {} belongs to {}: there was no room to put it in; --resume does, once there is\n",
        quote_path(log), kStoreName);
  const Summary summary = read_summary(folder);
  std::uint64_t faults = 0;
  for (const auto& cell : summary.cells)
    faults += cell.faults;
  const int code = faults ? 1 : 0;
  const std::uint64_t wide =
      spec.stop && ended == Ended::complete ? wide_cells(*spec.stop, folder) : 0;
  if (options.json) {
    Json json{{"campaign", spec.name}, {"ended", end}, {"hash", summary.hash}, {"folder", folder}};
    for (const auto& cell : summary.cells)
      json["replicates"].push_back(cell.replicates);
    json["faults"] = faults;
    if (spec.stop)
      json["wide"] = wide;
    say("{}\n", Composed{record::json_text(json)});
    return code;
  }
  print_cells(summary);
  say("\n{} after {}; campaign hash {}; results in {}/{} and {}\n", end,
      duration_text(store.seconds()), summary.hash, folder, kStoreName, kTableName);
  if (wide)
    say("{} is still wider than `stop` asks in {} of {} with its `most` replicates\n",
        summary.measures[spec.stop->measure].name, wide, counted(summary.cells.size(), "cell"));
  const std::string again =
      fmt::format("eyrie campaign {} --out {}", scenario::shell_word(options.file),
                  scenario::shell_word(whole));
  if (ended != Ended::complete)
    say("{}{}{} --resume goes on{}\n", again, options.part.empty() ? "" : " --part ", options.part,
        ended == Ended::stopped ? "" : " when its file has a larger budget");
  else if (!options.part.empty())
    say("{} --join puts all parts together\n", again);
  if (faults)
    complain("eyrie: {} ended with a fault, which counts for nothing\n",
             counted(faults, "replicate"));
  return code;
}

}  // namespace eyrie::app
