// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a page carries, unpacked.
#include <gtest/gtest.h>
#include <zlib.h>

#include "core/bytes.hpp"
#include "core/text.hpp"

namespace eyrie::test {

/// The bytes behind base64 of a zlib stream.
inline std::string unpacked(const std::string& base64) {
  const std::string packed = from_base64(base64).value_or("");
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
