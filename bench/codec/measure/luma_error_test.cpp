// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/measure/luma_error.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

const MaskImage kSeen(2, 1, 255);

TEST(LumaError, equal_pictures_have_no_psnr) {
  LumaError error;
  error.add(ColorImage(2, 1, {9, 8, 7}), ColorImage(2, 1, {9, 8, 7}), kSeen);
  EXPECT_FALSE(error.psnr_db().has_value());
}

TEST(LumaError, one_grey_level_is_48_db) {
  LumaError error;
  error.add(ColorImage(2, 1, {9, 9, 9}), ColorImage(2, 1, {10, 10, 10}), kSeen);
  EXPECT_NEAR(error.psnr_db().value(), 20 * std::log10(255.0), 1e-9);
}

TEST(LumaError, leaves_out_unseen_pixels) {
  ColorImage decoded(2, 1, {9, 9, 9});
  decoded.at(1, 0) = {200, 200, 200};
  MaskImage seen = kSeen;
  seen.at(1, 0) = 0;
  LumaError error;
  error.add(decoded, ColorImage(2, 1, {9, 9, 9}), seen);
  EXPECT_FALSE(error.psnr_db().has_value());
}

TEST(LumaError, frames_add_up) {
  LumaError none, one;
  none.add(ColorImage(2, 1), ColorImage(2, 1), kSeen);
  one.add(ColorImage(2, 1, {2, 2, 2}), ColorImage(2, 1), kSeen);
  one.add(none);
  EXPECT_NEAR(one.psnr_db().value(), 10 * std::log10(255.0 * 255.0 / 2), 1e-9);
}

}  // namespace
}  // namespace roomcast::bench
