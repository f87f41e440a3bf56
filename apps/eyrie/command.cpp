// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <fcntl.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <system_error>

#include "core/diagnostics.hpp"
#include "core/text.hpp"
#include "disk/file_system.hpp"
#include "disk/temporary.hpp"
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

constexpr const char* kUnknown =
    "something failed that this program does not know; please report it";

std::atomic<int> noted = 0;
std::atomic<std::int64_t> noted_at = 0;  // ns, of a clock that nobody sets

/// ns. Signals within it are one wish: timeout(1) tells first the program, then its whole group.
constexpr std::int64_t kOneWish = 250'000'000;

extern "C" void on_interrupt(int signal) {
  const int error = errno;
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  const std::int64_t now = time.tv_sec * std::int64_t{1'000'000'000} + time.tv_nsec;
  std::int64_t first = 0;
  if (noted_at.compare_exchange_strong(first, now)) {
    noted = signal;
  } else if (signal != SIGXFSZ &&  // each output may reach its limit, one after the other
             now - first > kOneWish && disk::remove_temporaries_now()) {
    ::signal(signal, SIG_DFL);
    ::raise(signal);
  }
  errno = error;
}

extern "C" void on_gone_reader(int) {}

void handle(int signal, void (*handler)(int)) {
  struct sigaction before {
  }, after{};
  ::sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN)
    return;
  after.sa_handler = handler;
  after.sa_flags = SA_RESTART;
  ::sigaction(signal, &after, nullptr);
}

}  // namespace

std::string words_for(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error))
    return "there is not enough memory";
  if (const auto* system = dynamic_cast<const std::system_error*>(&error))
    return disk::words_of(system->code().value());
  if (dynamic_cast<const std::runtime_error*>(&error))
    return error.what();
  return kUnknown;
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

int attempt(const std::function<int()>& command) {
  std::string words;
  bool mistake = false;
  try {
    return command();
  } catch (const Mistake& error) {
    complain("{}\n", Composed{error.what()});
    return 2;
  } catch (const ConfigError& error) {
    complain("{}\n", lines(error.diagnostics().text()));
    return 2;
  } catch (const std::exception& error) {
    words = words_for(error);
    const auto* system = dynamic_cast<const std::system_error*>(&error);
    mistake = dynamic_cast<const disk::Refused*>(&error) != nullptr ||
              (system && system->code() == std::errc::filename_too_long);
  } catch (...) {  // a plug-in may throw whatever it likes
    words = kUnknown;
  }
  complain("eyrie: {}\n", lines(words));
  return mistake ? 2 : 1;
}

int run_command(const std::function<int()>& command) {
  std::set_terminate(last_words);
  int code = attempt(command);
  if (const int lost = lost_output(); lost == EPIPE) {
    code = code ? code : 128 + SIGPIPE;
  } else if (lost) {
    complain("eyrie: cannot write to standard output: {}\n", disk::words_of(lost));
    code = code ? code : 1;
  }
  return interrupted() ? 128 + interruption() : code;
}

void listen_for_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXFSZ})
    handle(signal, on_interrupt);
  handle(SIGPIPE, on_gone_reader);
}
int interruption() {
  return noted;
}

void finish(disk::OutputFile& out) {
  if (interruption() == SIGXFSZ)
    throw disk::Failed("cannot write {}: {}; nothing was written", quote_path(out.sink().path()),
                       disk::words_of(EFBIG));
  if (interrupted())
    throw disk::Failed("interrupted, nothing was written");
  out.commit();
  say("written to {}, {}\n", out.sink().path(), size_text(out.sink().size()));
}

void finish(disk::OutputFolder& folder, const std::map<std::string, std::string>& files) {
  for (const auto& [name, text] : files) {
    disk::Sink sink = folder.file(name.c_str());
    sink.write(text);
    if (!sink.close())
      throw disk::Failed(sink.error());
  }
  if (const std::string words = folder.commit(); !words.empty())
    throw disk::Failed(words);
}

}  // namespace eyrie::app
