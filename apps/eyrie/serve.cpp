// SPDX-License-Identifier: MIT
/// \file  serve: the debrief page of a recorded run for browsers, also those of other machines.
#include <unistd.h>

#include <chrono>
#include <optional>
#include <random>
#include <system_error>
#include <thread>

#include "command.hpp"
#include "commands.hpp"
#include "disk/file_system.hpp"
#include "locate.hpp"
#include "net/web_host.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {

/// 128 bits that nobody guesses.
std::string new_token() {
  std::random_device draw;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", draw(), draw(), draw(), draw());
}

/// By which others reach this machine.
std::string name_of_this_machine() {
  char name[256] = "";
  ::gethostname(name, sizeof name - 1);
  return name;
}

}  // namespace

int serve(const ServeOptions& options) {
  const auto runs = open_runs(options.runs, options.plugins);
  listen_for_interrupts();
  net::WebOptions web{.at = {.address = options.address, .port = options.port}};
  if (!web.at.loopback())
    web.token = new_token();
  web.pages["/"] = {"text/html; charset=utf-8", debrief_text(runs, false)};
  const net::Endpoint at = web.at;
  const std::string token = web.token;
  std::optional<net::WebHost> host;
  try {
    host.emplace(std::move(web));
  } catch (const std::system_error& error) {
    refuse("cannot listen at {}: {}", at.text(), disk::words_of(error.code().value()));
  }
  net::Endpoint shown = host->at();
  if (shown.address == "0.0.0.0" || shown.address == "::")
    shown.address = name_of_this_machine();
  complain("eyrie: http://{}/{}{} shows it until ^C\n", shown.text(),
           token.empty() ? "" : "?token=", token);
  while (!interrupted())
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const net::WebHost::Counts counts = host->counts();
  complain("eyrie: {} {} sent, {} refused\n", counts.pages, counts.pages == 1 ? "page" : "pages",
           counts.refused);
  return 0;
}

}  // namespace eyrie::app
