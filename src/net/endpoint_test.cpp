// SPDX-License-Identifier: MIT
#include "net/endpoint.hpp"

#include <gtest/gtest.h>

namespace eyrie::net {
namespace {

std::string read(std::string_view text) {
  const auto found = endpoint_of(text, {.address = "127.0.0.1", .port = 42674});
  return found ? found->text() : "";
}

TEST(Endpoint, IsAPortAnAddressOrBoth) {
  EXPECT_EQ(read("1234"), "127.0.0.1:1234");
  EXPECT_EQ(read("0"), "127.0.0.1:0");
  EXPECT_EQ(read("0.0.0.0"), "0.0.0.0:42674");
  EXPECT_EQ(read("192.168.1.5:99"), "192.168.1.5:99");
  EXPECT_EQ(read("localhost"), "127.0.0.1:42674");
  EXPECT_EQ(read("localhost:99"), "127.0.0.1:99");
  EXPECT_EQ(read("::1"), "[::1]:42674");
  EXPECT_EQ(read("[::1]:99"), "[::1]:99");
  EXPECT_EQ(read("[::]"), "[::]:42674");
}

TEST(Endpoint, IsNothingElse) {
  for (const char* bad : {"", "65536", "-1", "1.2.3", "1.2.3.4:", "1.2.3.4:x", "1.2.3.4:65536",
                          ":99", "example.org", "[::1]:", "[::1", "1.2.3.4 ", "99x"})
    EXPECT_EQ(read(bad), "") << bad;
}

TEST(Endpoint, KnowsWhatNobodyElseReaches) {
  for (const char* own : {"127.0.0.1", "127.1.2.3", "::1"})
    EXPECT_TRUE(Endpoint{.address = own}.loopback()) << own;
  for (const char* open : {"0.0.0.0", "::", "192.168.1.5", "no address"})
    EXPECT_FALSE(Endpoint{.address = open}.loopback()) << open;
}

}  // namespace
}  // namespace eyrie::net
