// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/tls/fingerprint.h"

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

constexpr std::string_view kHex =
    "00ff10a0000000000000000000000000000000000000000000000000000000fe";

TEST(Fingerprint, is_written_and_read_as_hexadecimal_digits) {
  const auto fingerprint = parse_fingerprint(kHex);
  ASSERT_TRUE(fingerprint);
  EXPECT_EQ((*fingerprint)[1], 0xFF);
  EXPECT_EQ((*fingerprint)[3], 0xA0);
  EXPECT_EQ((*fingerprint)[31], 0xFE);
  EXPECT_EQ(to_string(*fingerprint), kHex);
}

TEST(Fingerprint, is_read_as_openssl_writes_it) {
  std::string colons;
  for (std::size_t i = 0; i < kHex.size(); i += 2) {
    if (i > 0) colons += ':';
    for (const char c : kHex.substr(i, 2)) colons += static_cast<char>(std::toupper(c));
  }
  EXPECT_EQ(parse_fingerprint(colons), parse_fingerprint(kHex));
  colons[2] = '0';
  EXPECT_FALSE(parse_fingerprint(colons));
}

TEST(Fingerprint, of_another_length_or_alphabet_is_none) {
  EXPECT_FALSE(parse_fingerprint(""));
  EXPECT_FALSE(parse_fingerprint(kHex.substr(1)));
  EXPECT_FALSE(parse_fingerprint(std::string(64, 'g')));
  EXPECT_FALSE(parse_fingerprint(std::string(95, 'a')));
}

}  // namespace
}  // namespace roomcast::net
