// SPDX-License-Identifier: MIT
/// \file  Plug-ins that end the program, or try to, while they are being opened.
#include <cstdlib>
#include <stdexcept>

#include "scenario/plugin.hpp"

namespace {
int in_static() {
  if (IN_STATIC == 1)
    throw std::runtime_error("no licence found");
  if (IN_STATIC == 2)
    std::exit(0);
  return 0;
}
const int kMade = in_static();
}  // namespace

EYRIE_PLUGIN([](eyrie::scenario::Registrar&) {
  if (kMade == 0 && IN_STATIC == 0)
    std::exit(0);
})
