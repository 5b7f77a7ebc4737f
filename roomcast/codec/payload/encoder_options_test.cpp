// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/payload/encoder_options.h"

#include <limits>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

FrameEncoderOptions kinect_v2() {
  FrameEncoderOptions options;
  options.width = 512;
  options.height = 424;
  return options;
}

TEST(FrameEncoderOptions, take_a_kinect) {
  EXPECT_TRUE(kinect_v2().check());
}

TEST(FrameEncoderOptions, name_the_field_that_is_out_of_range) {
  const auto message = [](auto change) {
    FrameEncoderOptions options = kinect_v2();
    change(options);
    return options.check().ok() ? std::string() : options.check().error().message;
  };
  const auto names = [&](const char* field, auto change) {
    return message(change).find(field) != std::string::npos;
  };
  EXPECT_TRUE(names("width", [](auto& o) { o.width = 15; }));
  EXPECT_TRUE(names("height", [](auto& o) { o.height = 4097; }));
  EXPECT_TRUE(names("fps", [](auto& o) { o.fps = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_TRUE(names("color_kbit_per_s", [](auto& o) { o.color_kbit_per_s = kMinKbit - 1; }));
  EXPECT_TRUE(names("color_scale", [](auto& o) { o.color_scale = 3; }));
  EXPECT_TRUE(names("temporal_layers", [](auto& o) { o.temporal_layers = 0; }));
  EXPECT_TRUE(names("key_interval_s", [](auto& o) { o.key_interval_s = 0; }));
  EXPECT_TRUE(names("depth_bound_mm", [](auto& o) { o.depth_bound_mm = 64; }));
}

TEST(FrameEncoderOptions, refuse_fine_colour_of_a_grid_too_large_for_it) {
  FrameEncoderOptions options = kinect_v2();
  options.width = 4096;
  options.color_scale = 2;
  EXPECT_FALSE(options.check());
}

}  // namespace
}  // namespace roomcast::codec
