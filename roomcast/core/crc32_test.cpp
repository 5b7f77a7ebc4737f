// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/crc32.h"

#include <string_view>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(Crc32, gives_the_check_value_of_the_catalogue) {
  constexpr std::string_view text = "123456789";
  const auto bytes = std::as_bytes(std::span(text));
  EXPECT_EQ(crc32(bytes), 0xCBF43926u);
  EXPECT_EQ(crc32(bytes.subspan(4), crc32(bytes.first(4))), 0xCBF43926u);
}

}  // namespace
}  // namespace roomcast
