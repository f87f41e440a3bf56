// SPDX-License-Identifier: MIT
#include "say.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include "record/story.hpp"

namespace eyrie::app {
namespace {
int lost = 0;  // errno of the first failure

/// `failed`, or the stream says so: errno is that of the call just made, which was cleared before.
void note(bool failed) {
  if ((failed || std::ferror(stdout)) && !lost)
    lost = errno ? errno : EIO;
}

/// Whether a stream goes to a terminal that obeys escape sequences.
bool obeyed(int stream) {
  const char* terminal = std::getenv("TERM");
  return ::isatty(stream) && !(terminal && std::string_view(terminal) == "dumb");
}

/// Columns of the terminal on standard error.
std::size_t width() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col ? size.ws_col : 80;
}
}  // namespace

bool colors() {
  const char* none = std::getenv("NO_COLOR");
  return obeyed(STDOUT_FILENO) && !(none && *none);
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

Progress::Progress(std::string_view what, std::uint64_t total)
    : what_(what), total_(total), shown_(obeyed(STDERR_FILENO)) {}

Progress::~Progress() {
  if (drawn_)
    complain("{}", Composed{"\r\033[K"});
}

bool Progress::due() const {
  return shown_ && Clock::now() - last_ >= std::chrono::milliseconds(100);
}

void Progress::at(std::uint64_t done, std::string_view more) {
  if (!due())
    return;
  last_ = Clock::now();
  drawn_ = true;
  const double rate =
      static_cast<double>(done) / std::chrono::duration<double>(last_ - begun_).count();
  constexpr std::size_t kWide = 20;
  const std::string bar(total_ ? kWide * done / total_ : 0, '#');
  std::string line =
      fmt::format("{} [{:<{}}] {} of {}, {:.1f}/s", what_, bar, kWide, done, total_, rate);
  if (done)
    line += fmt::format(", {} left", record::clock_text(static_cast<double>(total_ - done) / rate));
  line += fmt::format("{}{}", more.empty() ? "" : "; ", more);
  // a line that is wrapped is not drawn over: the last column stays free, "..." ends what is cut
  line = printable(line, std::max<std::size_t>(width(), 5) - 4);
  complain("{}", Composed{fmt::format("\r{}\033[K", line)});
  std::fflush(stderr);
}

}  // namespace eyrie::app
