// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "core/diagnostics.hpp"
#include "disk/failure.hpp"
#include "disk/file_system.hpp"
#include "disk/temporary.hpp"
#include "interrupt.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {

/// Where no exception may pass, as in the destructors of a library: nothing half written is left,
/// and a lack of memory is said as everywhere else.
[[noreturn]] void last_words() {
  disk::remove_temporaries_now();
  try {
    if (const std::exception_ptr error = std::current_exception())
      std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    constexpr std::string_view kWords = "eyrie: there is not enough memory\n";
    static_cast<void>(!::write(STDERR_FILENO, kWords.data(), kWords.size()));
    ::_exit(1);
  } catch (...) {
  }
  std::abort();
}

}  // namespace

std::string words_for(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error))
    return "there is not enough memory";
  if (const auto* system = dynamic_cast<const std::system_error*>(&error))
    return disk::words_of(system->code().value());
  if (dynamic_cast<const std::runtime_error*>(&error))
    return error.what();
  return "something failed that this program does not know; please report it";
}

void open_standard_streams() {
  // what is written to a closed one fails as it did
  for (;;) {
    const int file = ::open("/dev/null", O_RDONLY);
    if (file > STDERR_FILENO || file < 0) {
      ::close(file);
      return;
    }
  }
}

int run_command(const std::function<int()>& command) {
  std::set_terminate(last_words);
  int code = 1;
  std::string words;
  try {
    code = command();
  } catch (const std::exception& error) {
    words = words_for(error);
    const auto* system = dynamic_cast<const std::system_error*>(&error);
    const bool mistake = dynamic_cast<const disk::Refused*>(&error) != nullptr ||
                         dynamic_cast<const ConfigError*>(&error) != nullptr ||
                         (system && system->code() == std::errc::filename_too_long);
    code = mistake ? 2 : 1;
  }
  if (!words.empty())
    complain("eyrie: {}\n", lines(words));
  if (const int lost = lost_output(); lost == EPIPE) {
    code = code ? code : 128 + SIGPIPE;
  } else if (lost) {
    complain("eyrie: cannot write to standard output: {}\n", disk::words_of(lost));
    code = code ? code : 1;
  }
  return interrupted() ? 128 + interruption() : code;
}

}  // namespace eyrie::app
