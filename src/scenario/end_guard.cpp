// SPDX-License-Identifier: MIT
#include "scenario/end_guard.hpp"

#include <dlfcn.h>
#include <execinfo.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "scenario/plugin_file.hpp"
#include "team/moment.hpp"

namespace eyrie::scenario {
namespace {

std::atomic<EndGuard*> youngest = nullptr;
/// The thread that says the last words.
std::atomic<std::thread::id> speaker;
/// As many threads may end the program at once. Each takes one handler off the list of exit().
constexpr int kThreads = 256;

/// Never destroyed: it is asked when everything else is.
std::vector<std::string>& known_plugins() {
  static auto* known = new std::vector<std::string>;
  return *known;
}

/// The plug-in in whose code the program stands, as it is shown; "a plug-in" if it cannot be seen.
std::string plugin_on_the_stack() {
  std::array<void*, 256> calls;
  const int depth = ::backtrace(calls.data(), static_cast<int>(calls.size()));
  for (int i = 0; i < depth; ++i)
    if (const std::string path = plugin_at(calls[static_cast<std::size_t>(i)]); !path.empty())
      return shell_word(std::filesystem::path(path).filename().string());
  return "somebody";
}

}  // namespace

EndGuard::EndGuard(int code, LastWords last_words)
    : code_(code),
      last_words_(std::move(last_words)),
      before_(youngest.exchange(this)),
      terminate_before_(std::set_terminate(on_terminate)) {
  // the last that is registered is the first that is called; one that finds no guard does nothing
  static const bool many = [] {
    for (int i = 1; i < kThreads; ++i)
      enlist();
    return true;
  }();
  static_cast<void>(many);
  enlist();
}

void EndGuard::enlist() {
  static_cast<void>(std::atexit(on_exit));
  static_cast<void>(std::at_quick_exit(on_quick_exit));
}

EndGuard::~EndGuard() {
  youngest = before_;
  std::set_terminate(terminate_before_);
}

void EndGuard::ended(const std::string& done) {
  EndGuard* guard = youngest;
  if (!guard)
    return;
  std::thread::id first;
  if (!speaker.compare_exchange_strong(first, std::this_thread::get_id())) {
    // whose last words end the program again does not wait for himself
    while (first != std::this_thread::get_id())
      ::pause();
    return;
  }
  guard->last_words_(plugin_on_the_stack() + " " + done);
  std::fflush(nullptr);
  ::_exit(guard->code_);
}

void EndGuard::on_exit() {
  ended("called exit()");
}
void EndGuard::on_quick_exit() {
  ended("called quick_exit()");
}
void EndGuard::on_terminate() {
  ended(std::current_exception() ? team::exception_text() + ", which nobody could catch"
                                 : "called std::terminate()");
  std::abort();
}

void note_plugin(const std::string& path) {
  known_plugins().push_back(path);
}

std::string plugin_at(const void* address) {
  Dl_info info{};
  if (!address || ::dladdr(address, &info) == 0 || !info.dli_fname)
    return {};
  const auto& known = known_plugins();
  const auto found = std::ranges::find(known, info.dli_fname);
  return found == known.end() ? std::string() : *found;
}

}  // namespace eyrie::scenario
