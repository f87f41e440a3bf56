// SPDX-License-Identifier: MIT
#include "faults/ground.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <array>
#include <optional>

#include "command.hpp"
#include "commands.hpp"
#include "disk/temporary.hpp"
#include "faults/allocation.hpp"
#include "record/run_file.hpp"
#include "support/instead.hpp"

namespace eyrie::test {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kPart = ".eyrie-part-";

void redirect(const std::string& file, int to) {
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  ::dup2(opened, to);
  ::close(opened);
}

/// The parts of a tree below a path, with relative names.
Tree below(const Tree& tree, const std::string& path) {
  Tree part;
  for (const auto& [name, text] : tree)
    if (name == path || name.starts_with(path + "/"))
      part[name.substr(path.size())] = text;
  return part;
}

Tree without(const Tree& tree, const std::function<bool(const std::string&)>& drop) {
  Tree kept;
  for (const auto& item : tree)
    if (!drop(item.first))
      kept.insert(item);
  return kept;
}

bool is_below(const std::string& name, const std::string& path) {
  return name == path || name == path + "/" || name.starts_with(path + "/");
}

/// A made folder that lacks files beside the run file, or is one that was ended early.
std::string no_whole_run(const Tree& made, const Tree& wanted, const fs::path& where, bool early) {
  if (!made.contains("/run.eyrie"))
    return "has no run.eyrie";
  for (const auto& [name, text] : made) {
    if (!wanted.contains(name))
      return "has " + name;
    if (!early && wanted.at(name) != text)
      return name + " has other bytes";
  }
  if (!early)
    return "";
  const Ended again =
      Child(where.parent_path(), [&] { return app::replay({.run = where.string()}); }).wait();
  return again.ran.code == 0 ? "" : "does not replay: " + again.ran.err + again.ran.out;
}

std::string wrong_words(const Ran& ran) {
  for (const char* foreign : {"std::", "terminate", "json.", "basic_string", "filesystem error",
                              "what()", "bad_alloc", "vector", "Assertion"})
    if (ran.err.find(foreign) != std::string::npos)
      return fmt::format("says {}: {}", foreign, ran.err);
  if (ran.code != 0 && ran.code > 0 && ran.code < 128 && ran.err.empty())
    return "says nothing";
  return "";
}

/// Thousands of files are synced here; that is of use on a real disk only.
[[maybe_unused]] const bool in_memory =
    ::access("/dev/shm", W_OK) == 0 && ::setenv("TMPDIR", "/dev/shm", 0) == 0;

/// A background job begins with these ignored, which the program would keep.
[[maybe_unused]] const bool heard = [] {
  for (const int asked : {SIGINT, SIGTERM, SIGHUP})
    ::signal(asked, SIG_DFL);
  return true;
}();

}  // namespace

std::string Fault::text() const {
  return fmt::format("call {} error {} signal {}, allocation {} signal {}, room {}, file size {}",
                     files.at, files.error, files.signal, allocation, signal, files.room,
                     file_size);
}

Child::Child(const fs::path& folder, const std::function<int()>& command, Fault fault)
    : shared_(static_cast<Ended*>(::mmap(nullptr, sizeof(Ended), PROT_READ | PROT_WRITE,
                                         MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {
  std::fflush(nullptr);
  process_ = ::fork();
  if (process_ != 0)
    return;
  redirect(streams_ / "out", STDOUT_FILENO);
  redirect(streams_ / "err", STDERR_FILENO);
  ::setenv("EYRIE_VIEWER", (source_root() + "/tests/support/viewer.html").c_str(), 0);
  ::setenv("EYRIE_HOME", source_root().c_str(), 1);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  const rlimit size{fault.file_size, fault.file_size};
  if (::chdir(folder.c_str()) != 0 || (fault.file_size && ::setrlimit(RLIMIT_FSIZE, &size) != 0))
    ::_exit(99);
  const std::int64_t room = fault.files.room;
  const disk::Instead instead(fault.files);
  at_allocation(fault.allocation, fault.signal);
  const std::uint64_t before = allocations();
  const int code = app::run_command(command);
  shared_->allocations = allocations() - before;
  shared_->calls = fault.files.calls;
  shared_->written = static_cast<std::uint64_t>(room - fault.files.room);
  std::fflush(nullptr);
  ::_exit(code);
}

Ended Child::wait() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  Ended ended;
  ended.calls = shared_->calls;
  ended.allocations = shared_->allocations;
  ended.written = shared_->written;
  ::munmap(shared_, sizeof(Ended));
  ended.ran = {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
               read_text(streams_ / "out"), read_text(streams_ / "err")};
  return ended;
}

std::vector<Try> every_try() {
  const auto fly = [](std::string out, bool force) {
    return
        [=] { return app::fly({.scenario = "truck.yaml", .seed = 2, .out = out, .force = force}); };
  };
  const auto exported = [](app::ExportFormat format, std::string out, bool force) {
    return [=] {
      return app::export_run({.run = "run", .format = format, .out = out, .force = force});
    };
  };
  const auto debrief = [](std::string out, bool force) {
    return [=] { return app::debrief_page({.runs = {"run"}, .out = out, .force = force}); };
  };
  using enum app::ExportFormat;
  return {{"fly", fly("deep/made", false), "deep/made"},
          {"fly to the next number", fly("", false), "runs/truck-2.2"},
          {"fly into an empty folder", fly("empty", false), "empty"},
          {"fly over a run", fly("run", true), "run"},
          {"export", exported(decisions, "", false), "run/decisions.csv.gz"},
          {"export of a database", exported(sqlite, "", false), "run/run.sqlite"},
          {"export over an export", exported(czml, "other.czml", true), "other.czml"},
          {"debrief", debrief("new.html", false), "new.html"},
          {"debrief over a page", debrief("", false), "run/debrief.html"},
          {"trust",
           [] {
             ::setenv("XDG_CONFIG_HOME", fs::current_path().c_str(), 1);
             return app::trust({.remove = {"/opt/pilots.so"}});
           },
           "eyrie/trusted-plugins"},
          {"replay", [] { return app::replay({.run = "run"}); }, ""}};
}

Ground::Ground() {
  // the first one is flown, the others are copies of it
  static const TempFolder first;
  static const bool flown = [] {
    first.write("truck.yaml", kTruck);
    const auto fly = [](std::uint64_t seed, std::string out) {
      return Child(first.path(),
                   [=] { return app::fly({.scenario = "truck.yaml", .seed = seed, .out = out}); })
          .wait();
    };
    const bool good = fly(1, "run").ran.code == 0 && fly(2, "").ran.code == 0;
    // another page and another export than those that are made later
    first.write("run/debrief.html", "an old page");
    first.write("other.czml", "an old export");
    first.write("important", "kept");
    first.write("eyrie/trusted-plugins", std::string(64, 'a') + "  /opt/drivers.so\n" +
                                             std::string(64, 'b') + "  /opt/pilots.so\n");
    first.write("other/thesis.tex", "kept");
    first.write(".eyrie-part-of-mine", "kept");
    fs::create_directory(first / "empty");
    fs::create_symlink("important", first / "link");
    return good;
  }();
  if (!flown)
    throw std::runtime_error("the first flight failed");
  fs::copy(first.path(), folder_.path(),
           fs::copy_options::recursive | fs::copy_options::copy_symlinks);
}

Tree Ground::tree() const {
  Tree tree;
  for (const auto& entry : fs::recursive_directory_iterator(path())) {
    const std::string name =
        fs::relative(entry.path().parent_path(), path()) == "."
            ? entry.path().filename().string()
            : (fs::relative(entry.path().parent_path(), path()) / entry.path().filename())
                  .generic_string();
    if (entry.is_symlink())
      tree[name] = "-> " + fs::read_symlink(entry.path()).string();
    else if (entry.is_directory())
      tree[name + "/"] = "";
    else
      tree[name] = entry.is_regular_file() ? read_text(entry.path()) : "no file";
  }
  return tree;
}

const Done& done(const Try& t) {
  static std::map<std::string, Done> all;
  if (const auto known = all.find(t.name); known != all.end())
    return known->second;
  const Ground ground;
  Done& d = all[t.name];
  d.before = ground.tree();
  d.ended = Child(ground.path(), t.command).wait();
  d.after = ground.tree();
  return d;
}

std::string broken(const Try& t, const Fault& fault) {
  const Done& d = done(t);
  const Ground ground;
  const Ended ended = Child(ground.path(), t.command, fault).wait();
  const Ran& ran = ended.ran;
  const auto say = [&](const std::string& what) {
    return fmt::format("{}, {}: {} (exit {}, '{}')", t.name, fault.text(), what, ran.code, ran.err);
  };
  const int signal = fault.signal ? fault.signal : fault.files.signal;
  const bool killed = ran.code < 0;
  if (killed && ran.code != -signal)
    return say("has crashed");
  if (!killed && signal && ran.code != 128 + signal && ran.code != 0)
    return say("has another exit code");
  if (!killed && !signal && !fault.file_size && ran.code > 2)
    return say("has another exit code");
  if (const std::string words = wrong_words(ran); !words.empty())
    return say(words);

  // what a killed process left is beside the target or in it, and nowhere else
  const std::string beside = fs::path(t.target).parent_path().string();
  const auto left = [&](const std::string& name) {
    const fs::path path = name.ends_with('/') ? fs::path(name).parent_path() : fs::path(name);
    for (fs::path at = path; !at.empty(); at = at.parent_path())
      if (disk::is_temporary(at.filename().string()))
        return at.parent_path() == beside || at.parent_path() == t.target;
    return false;
  };
  const Tree after = ran.code == -SIGKILL ? without(ground.tree(), left) : ground.tree();
  for (const auto& [name, text] : after)
    if (name.find(kPart) != name.npos && name.find("of-mine") == name.npos)
      return say("has left " + name);
  if (after == d.after)
    return "";
  if (after == d.before)
    return ran.code == 0 ? say("has done nothing and says that it has") : "";
  if (ran.code == -SIGKILL && fs::path(t.target).has_parent_path() &&
      without(after, [&](const std::string& name) { return is_below(name, beside); }) ==
          without(d.before, [&](const std::string& name) { return is_below(name, beside); }) &&
      below(after, t.target).empty() && below(d.before, t.target).empty())
    return "";  // a folder for it has been made
  if (const auto link = after.find(beside + "/latest");
      link != after.end() && !link->second.starts_with("-> truck-2"))
    return say("has spoilt the link");
  // the rest is a run: whole, without what could not be written beside it, or ended early
  if (ran.code == 0)
    return say("is another one without a word");
  for (int i = 1; i < 5; ++i) {
    const std::string place = i == 1 ? t.target : fmt::format("{}.{}", t.target, i);
    const auto ours = [&](const std::string& name) {
      return is_below(name, place) || (!beside.empty() && name == beside + "/") ||
             name == beside + "/latest";
    };
    if (below(after, place) == below(d.before, place) ||
        without(after, ours) != without(d.before, ours))
      continue;
    const bool early = signal != 0 || fault.file_size != 0 || fault.files.room != INT64_MAX;
    const std::string wrong =
        no_whole_run(below(after, place), below(d.after, t.target), ground.path() / place, early);
    return wrong.empty() ? "" : say(wrong);
  }
  return say("has touched something else");
}

bool try_all() {
  const char* const wanted = std::getenv("EYRIE_FAULTS");
  return wanted && std::string_view(wanted) == "all";
}

std::uint64_t drawn(std::uint64_t index, std::uint64_t n) {
  static const std::uint64_t seed = [] {
    const char* const wanted = std::getenv("EYRIE_FAULTS_SEED");
    return wanted ? std::strtoull(wanted, nullptr, 10) : 1;
  }();
  // SplitMix64
  std::uint64_t x = (seed << 32) + (index + 1) * 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return (x ^ (x >> 31)) % n;
}

}  // namespace eyrie::test
