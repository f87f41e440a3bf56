// SPDX-License-Identifier: MIT
#pragma once
#include <cstdio>
#include <cstdlib>
#include <source_location>

namespace eyrie::fuzz {

/// What must hold for every input; a fuzzer finds it otherwise.
inline void demand(bool condition,
                   const std::source_location& where = std::source_location::current()) {
  if (condition)
    return;
  std::fprintf(stderr, "ERROR: %s:%u: what is demanded there does not hold\n", where.file_name(),
               static_cast<unsigned>(where.line()));
  std::abort();
}

}  // namespace eyrie::fuzz
