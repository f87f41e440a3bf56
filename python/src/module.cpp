// SPDX-License-Identifier: MIT
/// \file  The module: how it is left, how exceptions of C++ become those of Python, and its parts.
#include <atomic>
#include <chrono>
#include <system_error>
#include <thread>

#include "common.hpp"
#include "core/version.hpp"
#include "disk/file_system.hpp"
#include "train/vector_env.hpp"

namespace eyrie::python {
namespace {

std::atomic<unsigned> coming_back{0};
std::atomic<bool> closed{false};
std::atomic<std::thread::id> last_thread;

template <class Take>
void come_back(Take take) {
  ++coming_back;
  if (closed && last_thread.load() != std::this_thread::get_id()) {
    --coming_back;
    for (;;)
      std::this_thread::sleep_for(std::chrono::hours(1));
  }
  take();
  --coming_back;
}

nb::object error_type(const char* name) {
  return nb::module_::import_("eyrie._errors").attr(name);
}

void set_error(const nb::object& type, const nb::object& value) {
  PyErr_SetObject(type.ptr(), value.ptr());
}

void translate(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const ConfigError& e) {
    nb::list problems;
    for (const Diagnostic& one : e.diagnostics().sorted())
      problems.append(nb::make_tuple(printable(one.where.file.text()), one.where.line,
                                     one.where.column, printable(one.message)));
    const nb::object type = error_type("ConfigError");
    set_error(type, type(printable_lines(e.diagnostics().text()), nb::tuple(problems)));
  } catch (const disk::Failed& e) {
    set_error(nb::borrow(PyExc_OSError), nb::str(printable(e.what()).c_str()));
  } catch (const disk::Refused& e) {
    const nb::str words(printable(e.what()).c_str());
    if (e.error == 0)
      set_error(nb::borrow(PyExc_FileExistsError), words);
    else  // OSError itself chooses PermissionError, FileNotFoundError ...
      set_error(nb::borrow(PyExc_OSError), nb::make_tuple(e.error, words));
  } catch (const nb::builtin_exception&) {  // nanobind's own
    throw;
  } catch (const std::system_error& e) {  // threads that cannot be started
    set_error(nb::borrow(PyExc_OSError), nb::make_tuple(e.code().value(), nb::str(e.what())));
  } catch (const std::runtime_error& e) {
    const nb::object type =
        error_type(dynamic_cast<const train::Faulted*>(&e) ? "FaultError" : "RunError");
    set_error(type, type(printable_lines(e.what())));
  }
}

}  // namespace

GilReleased::~GilReleased() {
  come_back([&] { PyEval_RestoreThread(state_); });
}

GilHeld::GilHeld() {
  if (PyGILState_Check())
    state_ = PyGILState_Ensure();
  else
    come_back([&] { state_ = PyGILState_Ensure(); });
}

void close_the_way_back() {
  last_thread = std::this_thread::get_id();
  closed = true;
  // those who were on their way get the GIL first; a forked process may count some that it does not
  // have
  const nanobind::gil_scoped_release released;
  for (int ms = 0; coming_back != 0 && ms < 1000; ++ms)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void raise(const char* type, const std::string& words) {
  const GilHeld held;
  const nb::object made = error_type(type);
  set_error(made, made(printable_lines(words)));
  throw nb::python_error();
}

std::string version_text() {
  return fmt::format("eyrie {} for Python ({}, {})", kVersion, EYRIE_COMPILER, EYRIE_BUILD_TYPE);
}

PlayerId player_named(const scenario::Roster& roster, const std::string& name) {
  if (const auto who = roster.find(name))
    return *who;
  refuse("{}", roster.unknown(name));
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
  nanobind::register_exception_translator(&eyrie::python::translate);
  eyrie::python::add_behavior(m);
  eyrie::python::add_scenario(m);
  eyrie::python::add_world(m);
  eyrie::python::add_run(m);
  eyrie::python::add_env(m);
}
