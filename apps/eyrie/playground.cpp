// SPDX-License-Identifier: MIT
/// \file  playground: a folder of files in which a browser edits, flies and debriefs scenarios.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "commands.hpp"
#include "core/diagnostics.hpp"
#include "core/text.hpp"
#include "disk/file_system.hpp"
#include "disk/output.hpp"
#include "disk/sink.hpp"
#include "locate.hpp"
#include "page/page.hpp"
#include "pilot/policy/policy_file.hpp"
#include "record/json_schema.hpp"
#include "record/json_text.hpp"
#include "say.hpp"
#include "scenario/catalog.hpp"
#include "scenario/plugins.hpp"

namespace eyrie::app {
namespace {
namespace fs = std::filesystem;

constexpr const char* kNoPlayground =
    "the playground is not built: it needs the engine of the page and npm with its packages; "
    "'./eyrie playground' builds them when it can";
constexpr const char* kPage = "index.html";
constexpr const char* kSign = "eyrie-playground.txt";
constexpr std::array kNames{kPage, kSign};
constexpr std::string_view kAbout =
    "A playground of Eyrie, written by 'eyrie playground': open index.html in a browser, or put\n"
    "this folder on any web server. It needs nothing else, and asks nobody for anything.\n";

/// Every text below a folder of the installation. Throws disk::Failed.
void add_texts(const fs::path& home, const char* folder, nlohmann::ordered_json& texts) {
  constexpr std::size_t kLargest = std::size_t{1} << 20;
  constexpr auto kNetwork =
      pilot::PolicyFile::kEnding;  // no text: in base64, as scenario::Source has it
  std::vector<fs::path> files;
  std::error_code failed;
  for (const auto& entry : fs::recursive_directory_iterator(home / folder, failed))
    if (const fs::path kind = entry.path().extension();
        entry.is_regular_file() && (kind == ".yaml" || kind == kNetwork))
      files.push_back(entry.path());
  if (failed)
    throw disk::Failed("cannot read {}: {}", quote_path((home / folder).string()),
                       failed.message());
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    disk::FileRead read = disk::read_file(file, kLargest);
    if (!read.problem.empty())
      throw disk::Failed("{} {}", file.string(), read.problem);
    texts[file.lexically_relative(home).generic_string()] =
        file.extension() == kNetwork ? base64(read.bytes) : std::move(read.bytes);
  }
}

page::Part texts_of(const std::string& home) {
  nlohmann::ordered_json texts;
  for (const char* folder : {"scenarios", "data"})
    add_texts(home, folder, texts["files"]);
  const scenario::Plugins none;
  texts["schema"] = nlohmann::ordered_json::parse(
      record::catalog_json_schema(scenario::make_catalog(scenario::Source::disk(home), none)));
  return page::part_of("texts", record::json_text(texts));
}

}  // namespace

int playground(const PlaygroundOptions& options) {
  const std::string there = home();
  listen_for_interrupts();
  disk::OutputFolder folder({.path = options.out,
                             .names = kNames,
                             .sign = kSign,
                             .kind = "a playground",
                             .replace = options.force});
  const disk::FileRead shell = read_page(playground_file(), kNoPlayground);
  if (!shell.problem.empty())
    throw disk::Failed(shell.problem);
  const std::array parts{texts_of(there), page::part_of("zones", launch_zones())};
  const std::string page = page::page_with(shell.bytes, parts);
  if (page.empty())
    throw disk::Failed("{} is no playground of this version; build it again", playground_file());
  finish(folder, {{kPage, page}, {kSign, std::string(kAbout)}});
  say("written to {}: open {}/{} in a browser, {}\n", folder.path(), folder.path(), kPage,
      size_text(page.size()));
  return 0;
}

}  // namespace eyrie::app
