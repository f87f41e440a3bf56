// SPDX-License-Identifier: MIT
#pragma once
/// \file  Leaving Python and coming back, also to an interpreter that is at its end. Before 3.14
/// Python then ends a daemon thread inside of C++, which aborts the process; here it waits for the
/// end of the process instead.
#include <nanobind/nanobind.h>

namespace eyrie::python {

/// Without the GIL while it lives.
class GilReleased {
 public:
  GilReleased() : state_(PyEval_SaveThread()) {}
  ~GilReleased();
  GilReleased(const GilReleased&) = delete;
  GilReleased& operator=(const GilReleased&) = delete;

 private:
  PyThreadState* state_;
};

/// With the GIL while it lives, in any thread.
class GilHeld {
 public:
  GilHeld();
  ~GilHeld() { PyGILState_Release(state_); }
  GilHeld(const GilHeld&) = delete;
  GilHeld& operator=(const GilHeld&) = delete;

 private:
  PyGILState_STATE state_{};
};

/// From now on nobody comes back but the thread that calls this, with the GIL, when the interpreter
/// is about to end.
void close_the_way_back();

}  // namespace eyrie::python
