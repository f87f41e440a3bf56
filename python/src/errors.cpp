// SPDX-License-Identifier: MIT
/// \file  Exceptions of C++ as those of Python.
#include "common.hpp"
#include "disk/file_system.hpp"

namespace eyrie::python {
namespace {

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
  } catch (const std::runtime_error& e) {
    const nb::object type = error_type("RunError");
    set_error(type, type(printable_lines(e.what())));
  }
}

}  // namespace

void raise(const char* type, const std::string& words) {
  const GilHeld held;
  const nb::object made = error_type(type);
  set_error(made, made(printable_lines(words)));
  throw nb::python_error();
}

void add_errors(nb::module_&) {
  nb::register_exception_translator(translate);
}

}  // namespace eyrie::python
