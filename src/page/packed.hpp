// SPDX-License-Identifier: MIT
#pragma once
/// \file  Bytes made small and put into text.
#include <string>
#include <string_view>

namespace eyrie::page {

/// zlib (RFC 1950), as the browser's DecompressionStream('deflate') reads it.
[[nodiscard]] std::string deflated(std::string_view bytes);
/// RFC 4648, with padding and without line ends.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace eyrie::page
