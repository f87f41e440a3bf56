// SPDX-License-Identifier: MIT
#pragma once
/// \file  What every part of the extension module needs: scenarios and runs as
/// Python holds them, tables on their way to NumPy, work without the GIL that
/// Ctrl-C ends.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <chrono>
#include <functional>

#include "core/text.hpp"
#include "debrief/recorded.hpp"
#include "record/event_table.hpp"
#include "scenario/plugin.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::python {
namespace nb = nanobind;

/// eyrie._core.Scenario: shared by any number of worlds and threads.
struct Scenario {
  std::shared_ptr<const scenario::Scenario> loaded;
};

/// eyrie._core.Recorded. Never changes, so any number of threads may look at it.
using debrief::Recorded;

class BehaviorType;

/// eyrie._core.Behavior: what a scenario may name. Trees hold it as long as
/// they live.
struct Behavior {
  std::shared_ptr<const BehaviorType> type;
};

/// Adds them to what the trees of a scenario are made of; nothing for none.
[[nodiscard]] scenario::AddNodes adds(const std::vector<Behavior>& behaviors);

/// A text of a file, which may be any bytes.
[[nodiscard]] inline nb::object text(std::string_view bytes) {
  return nb::cast(printable(bytes));
}

/// What this build calls itself in recordings.
[[nodiscard]] std::string version_text();

/// The player of that name. Throws ValueError with the nearest name.
[[nodiscard]] PlayerId player_named(const scenario::Roster& roster, const std::string& name);

/// Throws eyrie.RunError or another exception of eyrie._errors with these
/// words.
[[noreturn]] void raise(const char* type, const std::string& words);
/// Throws ValueError.
template <class... T>
[[noreturn]] void refuse(fmt::format_string<T...> words, T&&... values) {
  throw nb::value_error(fmt::format(words, std::forward<T>(values)...).c_str());
}

// --- Leaving Python and coming back, also to an interpreter that is at its end. Before 3.14 Python
// then ends a daemon thread inside of C++, which aborts the process; here it waits for the end of
// the process instead.

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

/// Calls `use(stop)` without the GIL and gives what it gives. `stop`, which is
/// to be asked in every step, tells now and then whether a signal handler wants
/// the work to end, as Ctrl-C does; then what the handler raised is thrown at
/// the end, also instead of what `use` throws then.
template <class Use>
auto without_gil(Use use) {
  bool signaled = false;
  // at the end also what a behavior of Python has passed on
  const auto wants_end = [&] { return signaled || PyErr_CheckSignals() != 0; };
  try {
    auto result = [&] {
      const GilReleased released;
      using Clock = std::chrono::steady_clock;
      constexpr std::chrono::milliseconds kPatience{50};
      Clock::time_point next = Clock::now() + kPatience;
      return use([&] {
        if (!signaled && Clock::now() >= next) {
          const GilHeld held;
          signaled = PyErr_CheckSignals() != 0;
          next = Clock::now() + kPatience;
        }
        return signaled;
      });
    }();
    if (!wants_end())
      return result;
  } catch (...) {
    if (!wants_end())
      throw;
  }
  throw nb::python_error();
}

/// While it lives nobody else may use a thing; it begins and ends with the GIL. Throws eyrie.Error
/// with these words if somebody does.
class InUse {
 public:
  InUse(bool& in_use, const char* words) : in_use_(in_use) {
    if (in_use)
      raise("Error", words);
    in_use = true;
  }
  ~InUse() { in_use_ = false; }
  InUse(const InUse&) = delete;
  InUse& operator=(const InUse&) = delete;

 private:
  bool& in_use_;
};

// --- Tables

/// What a column holds: float64 (NaN: nothing), int64 (0: nothing), or words.
enum class ColumnKind { number, integer, words };

/// (name, unit, help, kind, values or codes, words) of each column.
using Columns = std::vector<std::tuple<std::string, std::string, std::string, std::string,
                                       nb::object, std::vector<std::string>>>;

/// A table that grows row by row, column by column in memory.
class TableBuilder {
 public:
  void column(std::string_view name, std::string_view unit, std::string_view help, ColumnKind kind);
  /// A cell for each column.
  void row(std::span<const record::Cell> cells);

  /// Hands over the memory.
  [[nodiscard]] Columns take();

 private:
  struct Column {
    std::string name, unit, help;
    ColumnKind kind;
    std::vector<double> numbers{};
    std::vector<std::int64_t> integers{};
    std::vector<std::int32_t> codes{};  ///< into words
    std::vector<std::string> words{};
    std::map<std::string, std::int32_t, std::less<>> code_of{};
  };
  std::vector<Column> columns_;
};

/// The columns of events: docs/events.md.
void add_event_columns(TableBuilder& table);

// --- The parts of the module

void add_behavior(nb::module_& m);
void add_scenario(nb::module_& m);
void add_world(nb::module_& m);
void add_run(nb::module_& m);
void add_env(nb::module_& m);

}  // namespace eyrie::python
