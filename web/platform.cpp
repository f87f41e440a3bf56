// SPDX-License-Identifier: MIT
/// \file  What a page has not: threads and plug-ins.
#include "core/assert.hpp"
#include "core/executor.hpp"
#include "scenario/end_guard.hpp"
#include "scenario/plugins.hpp"

namespace eyrie {

struct Executor::Pool {};
Executor::Executor(unsigned workers) {
  EYRIE_THROW_UNLESS(workers == 1, "a page has one thread");
}
Executor::~Executor() = default;
unsigned Executor::workers() const {
  return 1;
}
void Executor::run(const Job&) const {}

namespace scenario {

std::vector<std::string> Plugins::load(const std::string&, Source&, const PluginPermission*) {
  return {"a page cannot open plug-ins"};
}

EndGuard::EndGuard(int, LastWords) {}
EndGuard::~EndGuard() = default;
std::string plugin_at(const void*) {
  return {};
}

}  // namespace scenario
}  // namespace eyrie
