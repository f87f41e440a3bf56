// SPDX-License-Identifier: MIT
#include "say.hpp"

#include <cerrno>
#include <cstdio>

namespace eyrie::app {
namespace {
int lost = 0;  // errno of the first failure
}

int lost_output() {
  errno = 0;
  if ((std::fflush(stdout) != 0 || std::ferror(stdout)) && !lost)
    lost = errno ? errno : EIO;
  return lost;
}

}  // namespace eyrie::app

namespace eyrie::app::detail {

void print_out(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() && !lost)
    lost = errno;
}
void print_error(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace eyrie::app::detail
