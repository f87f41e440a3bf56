// SPDX-License-Identifier: MIT
#include "say.hpp"

#include <cstdio>

namespace eyrie::app::detail {

void print_out(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}
void print_error(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace eyrie::app::detail
