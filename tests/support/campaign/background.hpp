// SPDX-License-Identifier: MIT
#pragma once
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

#include "support/program.hpp"

namespace eyrie::test {

/// What all processes that have ended used of the processors, whatever else these had to do.
[[nodiscard]] inline std::chrono::microseconds used_by_processes() {
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  return std::chrono::seconds(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         std::chrono::microseconds(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

/// The program in the background.
class Background {
 public:
  /// SIGPROF kills it when it has used `limit` of the processors; at 0 it has none.
  Background(const TempFolder& folder, std::vector<std::string> words,
             std::chrono::microseconds limit = {}) {
    words.insert(words.begin(), program_path());
    std::vector<char*> arguments;
    for (std::string& word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::setenv("EYRIE_HOME", source_root().c_str(), 1);
    child_ = ::fork();
    if (child_ != 0)
      return;
    const int nowhere = ::open("/dev/null", O_RDWR);
    const int errors = ::open((folder / "err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int said = ::open((folder / "said").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(nowhere, STDIN_FILENO);
    ::dup2(said, STDOUT_FILENO);
    ::dup2(errors, STDERR_FILENO);
    ::signal(SIGINT, SIG_DFL);
    const itimerval timer{{}, {limit.count() / 1'000'000, limit.count() % 1'000'000}};
    ::setitimer(ITIMER_PROF, &timer, nullptr);  // goes on through exec
    if (::chdir(folder.path().c_str()) == 0)
      ::execv(arguments[0], arguments.data());
    ::_exit(99);
  }
  /// Its exit code, below 0 for the signal that killed it; signal 0 waits for its own end.
  int end(int signal) const {
    ::kill(child_, signal);
    int status = 0;
    ::waitpid(child_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  pid_t child_;
};

}  // namespace eyrie::test
