// SPDX-License-Identifier: MIT
#pragma once
/// \file  A folder with a run and things of other people, in which commands are tried in processes
/// of their own; and what must hold afterwards.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "faults/faulty.hpp"
#include "support/program.hpp"

namespace eyrie::test {

/// Path -> text of every file; folders end in '/'.
using Tree = std::map<std::string, std::string>;

/// What goes wrong in a child; nothing by default.
struct Fault {
  Faulty files{};
  std::uint64_t allocation = 0;  ///< the one that fails, or at which `signal` comes
  int signal = 0;
  std::uint64_t file_size = 0;  ///< the largest that a file may be; 0: any
  std::string text() const;
};

/// How a child ended, and how many chances for a fault it had.
struct Ended {
  Ran ran;
  std::uint64_t calls = 0, allocations = 0, written = 0;
};

/// A process that runs a command in a folder.
class Child {
 public:
  Child(const std::filesystem::path& folder, const std::function<int()>& command, Fault fault = {});
  [[nodiscard]] Ended wait();

 private:
  TempFolder streams_;
  Ended* shared_;
  int process_;
};

/// A command, and the file or folder that it makes; "" if none.
struct Try {
  std::string name;
  std::function<int()> command;
  std::string target;
};
[[nodiscard]] std::vector<Try> every_try();

/// What is there before a try: a scenario, a run with an export and two pages, and what is not
/// ours.
class Ground {
 public:
  Ground();
  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }
  [[nodiscard]] std::string operator/(std::string_view name) const { return folder_ / name; }
  [[nodiscard]] Tree tree() const;
  void write(std::string_view name, std::string_view text) const { folder_.write(name, text); }

 private:
  TempFolder folder_;
};

/// What a try leaves behind when nothing goes wrong.
struct Done {
  Tree before, after;
  Ended ended;
};
[[nodiscard]] const Done& done(const Try& t);

/// Makes the try with the fault; "" if what must hold holds afterwards, otherwise what does not:
/// the old or the new is there and whole, nothing else has changed, nothing temporary is left
/// unless the process was killed, the exit code and the words are ours.
[[nodiscard]] std::string broken(const Try& t, const Fault& fault);

/// Whether every fault is to be tried, not a drawn part of them; and draws.
[[nodiscard]] bool try_all();
/// A number below `n` that depends on the seed and `index` only.
[[nodiscard]] std::uint64_t drawn(std::uint64_t index, std::uint64_t n);

inline constexpr const char* kTruck = R"(eyrie: 1
name: truck
reference: {latitude: 33 deg, longitude: -68 deg}
until: 2 s
ends: time
trees:
  drive:
    winner_takes_all:
      - navigate: {vote: 10, speed: 40 km/h}
blue:
  home: {north: 0 nmi, east: -20 nmi}
  convoys:
    truck:
      vehicle: m939
      tree: drive
      players: [truck1]
      start: {north: 0 km, east: 0 km, heading: 45 deg, speed: 40 km/h}
      route:
        - {north: 20 km, east: 20 km, speed: 40 km/h}
)";

}  // namespace eyrie::test
