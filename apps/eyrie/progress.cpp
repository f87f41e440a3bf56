// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <unistd.h>

#include <cstdio>

#include "record/story.hpp"
#include "say.hpp"

namespace eyrie::app {

Progress::Progress(std::string_view what, std::uint64_t total)
    : what_(what), total_(total), shown_(::isatty(STDERR_FILENO)) {}

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
  complain("{}{} [{:<{}}] {} of {}, {:.1f}/s", Composed{"\r"}, what_, bar, kWide, done, total_,
           rate);
  if (done)
    complain(", {} left", record::clock_text(static_cast<double>(total_ - done) / rate));
  complain("{}{}{}", more.empty() ? "" : "; ", more, Composed{"\033[K"});
  std::fflush(stderr);
}

}  // namespace eyrie::app
