// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace eyrie::scenario {

/// SHA-256 (FIPS 180-4) of some bytes as 64 small hexadecimal digits: for what an adversary may
/// have made. Everything else is hashed by core/hash.hpp, which is faster.
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace eyrie::scenario
