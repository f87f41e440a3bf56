// SPDX-License-Identifier: MIT
/// \file  A shared library that knows nothing of Eyrie.
extern "C" __attribute__((visibility("default"))) int answer() {
  return 42;
}
