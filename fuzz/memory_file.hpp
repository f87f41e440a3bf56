// SPDX-License-Identifier: MIT
#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <string>

#include "disk/sink.hpp"
#include "fuzz/named_flight.hpp"

namespace eyrie::fuzz {

/// What `write(sink)` writes, without a disk.
template <class Write>
[[nodiscard]] std::string written_by(Write write) {
  static const int file = ::memfd_create("fuzzed", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  disk::Sink sink(path);
  write(sink);
  const auto size = static_cast<std::size_t>(sink.size());
  demand(sink.close());
  std::string text(size, '\0');
  demand(::pread(file, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()));
  return text;
}

/// What a writer makes of the flight.
template <class Writer>
[[nodiscard]] std::string written() {
  return written_by([](disk::Sink& sink) {
    Writer writer(flight().scenario(), sink);
    flight().show(writer);
  });
}

}  // namespace eyrie::fuzz
