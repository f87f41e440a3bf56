// SPDX-License-Identifier: MIT
/// \file  A shared library that was linked with nothing that it needs.
namespace eyrie::pilot {
double nowhere(double x);
}
extern "C" __attribute__((visibility("default"))) double eyrie_plugin() {
  return eyrie::pilot::nowhere(42);
}
