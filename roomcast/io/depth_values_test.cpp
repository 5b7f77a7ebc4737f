// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/depth_values.h"

#include <gtest/gtest.h>

namespace roomcast::io {
namespace {

DepthImage row(std::initializer_list<std::uint16_t> values) {
  DepthImage depth(static_cast<int>(values.size()), 1);
  std::copy(values.begin(), values.end(), depth.data());
  return depth;
}

DepthImage in_mm(const RecordedCamera& camera, DepthImage depth) {
  DepthValues(camera).to_mm(depth);
  return depth;
}

TEST(DepthValues, millimetres_are_left_alone) {
  EXPECT_EQ(in_mm({}, row({0, 1, 1234, 65535})), row({0, 1, 1234, 65535}));
}

TEST(DepthValues, other_scales_become_millimetres) {
  RecordedCamera camera;
  camera.depth_scale_to_metre = 0.0002;
  EXPECT_EQ(in_mm(camera, row({0, 5, 5000})), row({0, 1, 1000}));
}

TEST(DepthValues, a_bias_is_added_to_readings_only) {
  RecordedCamera camera;
  camera.depth_bias_m = 0.012;
  EXPECT_EQ(in_mm(camera, row({0, 1000, 65530})), row({0, 1012, 0}));
  camera.depth_bias_m = -0.012;
  EXPECT_EQ(in_mm(camera, row({0, 12, 13, 1000})), row({0, 0, 1, 988}));
}

TEST(DepthValues, invalid_values_are_no_readings) {
  RecordedCamera camera;
  camera.invalid_depth = {0, 65535, 7};
  EXPECT_EQ(in_mm(camera, row({7, 8, 65535})), row({0, 8, 0}));
}

}  // namespace
}  // namespace roomcast::io
