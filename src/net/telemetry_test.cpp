// SPDX-License-Identifier: MIT
#include "net/telemetry_host.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

namespace eyrie::net {
namespace {

/// Check values of the catalogue of parametrised CRC algorithms (reveng.sourceforge.io).
TEST(Crc, HasThePublishedCheckValues) {
  EXPECT_EQ(crc64_we("123456789"), 0x62EC59E3F1A4F00A);
  EXPECT_EQ(crc32("123456789"), 0xCBF43926u);
  EXPECT_EQ(crc64_we(""), 0u);
}

TEST(Password, IsHashedAsUtf16) {
  using namespace std::literals;
  EXPECT_EQ(password_hash(""), "0");
  EXPECT_EQ(password_hash("ab"), password_hash("ab"));
  EXPECT_TRUE(is_hash_of(password_hash("geheim"), "geheim"));
  EXPECT_FALSE(is_hash_of(password_hash("geheim"), "Geheim"));
  EXPECT_FALSE(is_hash_of("0", "geheim"));
  EXPECT_FALSE(is_hash_of("", "geheim"));
  EXPECT_TRUE(is_hash_of("0", ""));
  EXPECT_TRUE(is_hash_of("1234", "")) << "a client with a password that nobody asked for";
  // a, é, the euro sign, and one of two units
  const std::string bytes = "a\0\xE9\0\xAC\x20\x3D\xD8\x80\xDE"s;
  char hex[17];
  std::snprintf(hex, sizeof hex, "%llx", static_cast<unsigned long long>(crc64_we(bytes)));
  EXPECT_EQ(password_hash("aé€🚀"), hex);
  std::snprintf(hex, sizeof hex, "%x", crc32(bytes));
  EXPECT_TRUE(is_hash_of(hex, "aé€🚀"));
}

TEST(Greeting, IsWhatTacviewExpects) {
  using namespace std::literals;
  EXPECT_EQ(host_greeting("Eyrie"), "XtraLib.Stream.0\nTacview.RealTimeTelemetry.0\nEyrie\n\0"sv);
  const auto client = client_greeting("XtraLib.Stream.0\nTacview.RealTimeTelemetry.0\nMe\n6a1f");
  ASSERT_TRUE(client);
  EXPECT_EQ(client->name, "Me");
  EXPECT_EQ(client->hash, "6a1f");
  EXPECT_TRUE(client_greeting("XtraLib.Stream.0\nTacview.RealTimeTelemetry.0\n\n0\n"));
  for (const char* bad :
       {"", "GET / HTTP/1.1\r\n", "XtraLib.Stream.1\nTacview.RealTimeTelemetry.0\nMe\n0",
        "XtraLib.Stream.0\nTacview.RealTimeTelemetry.1\nMe\n0",
        "XtraLib.Stream.0\nTacview.RealTimeTelemetry.0\nMe",
        "XtraLib.Stream.0\nTacview.RealTimeTelemetry.0\nMe\n0\n0\n"})
    EXPECT_FALSE(client_greeting(bad)) << bad;
}

RC_GTEST_PROP(Greeting, IsReadWhateverComes, (const std::string& text)) {
  const std::string begun = "XtraLib.Stream.0\nTacview.RealTimeTelemetry.0\n" + text;
  if (const auto client = client_greeting(begun))
    RC_ASSERT(client->name.find('\n') == std::string::npos);
  static_cast<void>(client_greeting(text));
  RC_ASSERT(is_hash_of(password_hash(text), text));
}

}  // namespace
}  // namespace eyrie::net
