// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a page carries, unpacked.
#include <gtest/gtest.h>
#include <zlib.h>

#include "core/bytes.hpp"

namespace eyrie::test {

/// The bytes that page::packed() was given.
inline std::string unpacked(const std::string& text) {
  std::string packed;
  for (std::size_t at = 0; at < text.size(); at += 5) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < 5; ++k) {
      const char digit = at + k < text.size() ? text[at + k] : 'u';
      word = word * 85 + static_cast<std::uint64_t>((digit == 'v' ? '<' : digit) - '!');
    }
    for (std::size_t k = 0; k < 4 && at + k + 1 < text.size(); ++k)
      packed.push_back(static_cast<char>(word >> (24 - 8 * k) & 255));
  }
  std::string out(64 << 20, '\0');
  uLongf size = out.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(out.data()), &size,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
            Z_OK);
  out.resize(size);
  return out;
}

/// The quanta of a column at the start of bytes, after the words of decode.ts.
inline std::vector<std::int64_t> read_column(std::string_view bytes, std::size_t count, int order) {
  std::vector<std::int64_t> out;
  ByteReader reader(bytes);
  std::int64_t last = 0, slope = 0;
  while (out.size() < count) {
    const std::uint64_t bits = reader.varint();
    const auto value = static_cast<std::int64_t>(bits >> 1) ^ -static_cast<std::int64_t>(bits & 1);
    slope = order == 2 ? slope + value : value;
    last = order == 0 ? value : last + slope;
    out.push_back(last);
  }
  EXPECT_TRUE(reader.ok());
  return out;
}

}  // namespace eyrie::test
