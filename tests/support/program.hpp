// SPDX-License-Identifier: MIT
#pragma once
/// \file  Runs the real program as its user does, in a folder of its own, and keeps what it said.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eyrie::test {

[[nodiscard]] inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A folder that is gone after the test.
class TempFolder {
 public:
  TempFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "eyrie-test-XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw std::runtime_error("cannot make a temporary folder");
    path_ = name;
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::string operator/(std::string_view name) const {
    return (path_ / name).string();
  }
  /// Writes a file and gives its path.
  std::string write(std::string_view name, std::string_view text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return *this / name;
  }
  /// Every file and folder below, relative and sorted.
  [[nodiscard]] std::vector<std::string> everything() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_))
      names.push_back(entry.path().lexically_relative(path_).generic_string());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::filesystem::path path_;
};

/// How the program ended and what it printed. A code below 0 is the signal that killed it.
struct Ran {
  int code = 0;
  std::string out, err;
};

/// The program: EYRIE_PROGRAM, or the one that was built beside this test.
[[nodiscard]] inline std::string program_path() {
  if (const char* set = std::getenv("EYRIE_PROGRAM"); set && *set)
    return set;
  const auto self = std::filesystem::read_symlink("/proc/self/exe");
  return (self.parent_path().parent_path() / "bin" / "eyrie").string();
}

/// The root of the source tree, where tests run.
[[nodiscard]] inline std::string source_root() {
  return std::filesystem::current_path().string();
}

struct RunOptions {
  std::string home = source_root();                                   ///< EYRIE_HOME
  std::string viewer = source_root() + "/tests/support/viewer.html";  ///< EYRIE_VIEWER
  std::string config = {};  ///< XDG_CONFIG_HOME; empty: there is none, and no HOME
  std::string cache = {};   ///< XDG_CACHE_HOME; empty: there is none
  /// Bytes after which a write to a file fails, as on a full disk; 0: none.
  std::size_t file_size_limit = 0;
};

/// The program while it runs in `folder`. Nothing of the surroundings reaches it; standard input is
/// empty, and no stream is a terminal. It is killed if nobody waits for it.
class Running {
 public:
  Running(const TempFolder& folder, const std::vector<std::string>& arguments,
          const RunOptions& options = {}) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    for (const auto& [file, name] : {std::pair{STDOUT_FILENO, "out"}, {STDERR_FILENO, "err"}})
      posix_spawn_file_actions_addopen(&actions, file, (streams_ / name).c_str(),
                                       O_WRONLY | O_CREAT, 0600);
    posix_spawn_file_actions_addchdir_np(&actions, folder.path().c_str());

    std::vector<std::string> words{program_path()};
    std::vector<std::string> settings{"EYRIE_HOME=" + options.home, "LC_ALL=C",
                                      "EYRIE_DUCKDB=./libduckdb.so",  // nobody else's
                                      "EYRIE_VIEWER=" + options.viewer};
    if (!options.config.empty())
      settings.push_back("XDG_CONFIG_HOME=" + options.config);
    if (!options.cache.empty())
      settings.push_back("XDG_CACHE_HOME=" + options.cache);
    if (options.file_size_limit)  // in units of 512 bytes; without the signal a write just fails
      words = {"/bin/sh", "-c", "trap '' XFSZ; ulimit -f $0; exec \"$@\"",
               std::to_string(options.file_size_limit / 512), words[0]};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const auto pointers = [](std::vector<std::string>& strings) {
      std::vector<char*> p;
      for (std::string& s : strings)
        p.push_back(s.data());
      p.push_back(nullptr);
      return p;
    };
    posix_spawnattr_t attributes;  // a shell has what it starts behind it ignore interrupts
    posix_spawnattr_init(&attributes);
    sigset_t heard;
    sigemptyset(&heard);
    sigaddset(&heard, SIGINT);
    posix_spawnattr_setsigdefault(&attributes, &heard);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    const int failed = ::posix_spawn(&child_, words[0].c_str(), &actions, &attributes,
                                     pointers(words).data(), pointers(settings).data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (failed)
      throw std::runtime_error("cannot run " + words[0]);
  }
  ~Running() {
    if (child_) {
      kill(SIGKILL);
      static_cast<void>(wait());
    }
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  [[nodiscard]] pid_t id() const { return child_; }
  /// What it has printed so far.
  [[nodiscard]] std::string err() const { return read_text(streams_ / "err"); }
  void kill(int signal) const { ::kill(child_, signal); }
  /// Until it ends.
  [[nodiscard]] Ran wait() {
    int status = 0;
    ::waitpid(std::exchange(child_, 0), &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
            read_text(streams_ / "out"), err()};
  }

 private:
  TempFolder streams_;
  pid_t child_ = 0;
};

[[nodiscard]] inline Ran run_program(const TempFolder& folder,
                                     const std::vector<std::string>& arguments,
                                     const RunOptions& options = {}) {
  return Running(folder, arguments, options).wait();
}

/// A line of a shell, in which `eyrie` is the program, and $EYRIE its path.
[[nodiscard]] inline Ran run_line(const TempFolder& folder, const std::string& line) {
  const TempFolder streams;
  const std::string all = "cd '" + folder.path().string() + "' && export EYRIE='" + program_path() +
                          "' EYRIE_HOME='" + source_root() + "' EYRIE_VIEWER='" + source_root() +
                          "/tests/support/viewer.html' XDG_CONFIG_HOME='" + (folder / "config") +
                          "' && eyrie() { \"$EYRIE\" \"$@\"; } && { " + line + "\n} >" +
                          (streams / "out") + " 2>" + (streams / "err");
  const int status = std::system(all.c_str());  // NOLINT: a shell is what is wanted
  return {WEXITSTATUS(status), read_text(streams / "out"), read_text(streams / "err")};
}

}  // namespace eyrie::test
