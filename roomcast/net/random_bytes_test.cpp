// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/random_bytes.h"

#include <array>

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

TEST(RandomBytes, two_fillings_differ) {
  std::array<std::uint8_t, 32> first{};
  std::array<std::uint8_t, 32> second{};
  fill_with_random_bytes(first);
  fill_with_random_bytes(second);
  EXPECT_NE(first, second);  // equal with probability 2^-256
}

TEST(RandomBytes, filling_nothing_is_fine) {
  fill_with_random_bytes({});
}

}  // namespace
}  // namespace roomcast::net
