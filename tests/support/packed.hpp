// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a page carries, unpacked.
#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

namespace eyrie::test {

/// The bytes behind base64 of a zlib stream.
inline std::string unpacked(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string packed;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : base64) {
    if (c == '=')
      break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    if ((count += 6) >= 8)
      packed.push_back(static_cast<char>(bits >> (count -= 8) & 255));
  }
  std::string out(64 << 20, '\0');
  uLongf size = out.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(out.data()), &size,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
            Z_OK);
  out.resize(size);
  return out;
}

}  // namespace eyrie::test
