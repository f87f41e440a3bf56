// SPDX-License-Identifier: MIT
#include "common.hpp"
#include "core/version.hpp"

namespace eyrie::python {

std::string version_text() {
  return fmt::format("eyrie {} for Python ({}, {})", kVersion, EYRIE_COMPILER, EYRIE_BUILD_TYPE);
}

PlayerId player_named(const scenario::Roster& roster, const std::string& name) {
  if (const auto who = roster.find(name))
    return *who;
  throw nb::value_error(roster.unknown(name).c_str());
}

}  // namespace eyrie::python

NB_MODULE(_core, m) {
  m.doc() = "The engine of Eyrie; use it through the package eyrie.";
  m.attr("version") = eyrie::kVersion;
  m.def("version_text", &eyrie::python::version_text,
        "What this build calls itself in recordings.");
  // a behavior and the module that it is written in hold each other
  nanobind::set_leak_warnings(false);
  nanobind::module_::import_("atexit").attr("register")(
      nanobind::cpp_function(&eyrie::python::close_the_way_back));
  eyrie::python::add_errors(m);
  eyrie::python::add_behavior(m);
  eyrie::python::add_scenario(m);
  eyrie::python::add_world(m);
  eyrie::python::add_run(m);
  eyrie::python::add_env(m);
}
