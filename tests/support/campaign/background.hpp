// SPDX-License-Identifier: MIT
#pragma once
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/program.hpp"

namespace eyrie::test {

/// The program in the background.
class Background {
 public:
  Background(const TempFolder& folder, std::vector<std::string> words) {
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
    if (::chdir(folder.path().c_str()) == 0)
      ::execv(arguments[0], arguments.data());
    ::_exit(99);
  }
  /// Its exit code, below 0 for the signal that killed it.
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
