// SPDX-License-Identifier: MIT
#pragma once
#include <cstdio>
#include <cstdlib>
#include <source_location>
#include <string>

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

/// The same of two texts, which are shown.
inline void demand_same(const std::string& read, const std::string& wanted,
                        const std::source_location& where = std::source_location::current()) {
  if (read != wanted)
    std::fprintf(stderr, "read:   '%s'\nwanted: '%s'\n", read.c_str(), wanted.c_str());
  demand(read == wanted, where);
}

}  // namespace eyrie::fuzz
