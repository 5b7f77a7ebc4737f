// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/result.h"

#include <memory>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

Result<int> half(int n) {
  if (n % 2 != 0) return Error{ErrorCode::kInvalidArgument, "odd"};
  return n / 2;
}

TEST(Result, holds_a_value_or_an_error) {
  EXPECT_TRUE(half(4).ok());
  EXPECT_EQ(*half(4), 2);
  EXPECT_FALSE(half(3));
  EXPECT_EQ(half(3).error().message, "odd");
}

TEST(Result, moves_values_that_cannot_be_copied) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(7));
  std::unique_ptr<int> taken = std::move(result).value();
  EXPECT_EQ(*taken, 7);
}

TEST(Result, status_is_ok_unless_given_an_error) {
  EXPECT_TRUE(Status().ok());
  EXPECT_EQ(Status(Error{ErrorCode::kClosed, "bye"}).error().code, ErrorCode::kClosed);
}

TEST(ResultDeathTest, reading_the_wrong_side_is_a_broken_promise) {
  EXPECT_DEATH((void)*half(3), "internal error of roomcast");
}

}  // namespace
}  // namespace roomcast
