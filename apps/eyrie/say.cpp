// SPDX-License-Identifier: MIT
#include "say.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

namespace eyrie::app {
namespace {
int lost = 0;  // errno of the first failure

/// `failed`, or the stream says so: errno is that of the call just made, which was cleared before.
void note(bool failed) {
  if ((failed || std::ferror(stdout)) && !lost)
    lost = errno ? errno : EIO;
}
}  // namespace

bool colors() {
  const char* none = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return ::isatty(STDOUT_FILENO) && !(none && *none) &&
         !(terminal && std::string_view(terminal) == "dumb");
}

int lost_output() {
  errno = 0;
  note(std::fflush(stdout) != 0);
  return lost;
}

namespace detail {

void print_out(std::string_view text) {
  errno = 0;  // a line may be taken whole although the reader of those before it has gone
  note(std::fwrite(text.data(), 1, text.size(), stdout) != text.size());
}
void print_error(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace detail
}  // namespace eyrie::app
