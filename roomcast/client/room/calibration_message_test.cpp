// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room/calibration_message.h"

#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

SensorCalibration some_calibration() {
  SensorCalibration calibration;
  calibration.depth = {512, 424, 364.6, 364.7, 256.0, 206.7, 0.087, -0.26, 0.1, -0.0002, 0.0001};
  calibration.color = {1920,  1080,   1065.9, 1066.4, 958.5,  545.5,
                       0.018, -0.033, -0.001, 0.0001, -0.0001};
  calibration.color_from_depth = world_from_optical_looking_at({-0.05, 0.1, 0.2}, {1, 0, 3});
  return calibration;
}

TEST(CalibrationMessage, decoding_reverses_encoding) {
  const auto calibration = some_calibration();
  const auto read = calibration_from_message(message_from_calibration(calibration));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->depth, calibration.depth);
  EXPECT_EQ(read->color, calibration.color);
  EXPECT_FALSE(read->color_is_registered);
  EXPECT_TRUE(
      read->color_from_depth.rotation.isApprox(calibration.color_from_depth.rotation, 1e-12));
  EXPECT_TRUE(read->color_from_depth.translation_m.isApprox(
      calibration.color_from_depth.translation_m, 1e-12));
}

TEST(CalibrationMessage, numbers_that_are_no_camera_are_refused) {
  auto message = message_from_calibration(some_calibration());
  message.mutable_depth()->set_fx(-1);
  EXPECT_FALSE(calibration_from_message(message).ok());
  message = message_from_calibration(some_calibration());
  message.mutable_color_from_depth()->RemoveLast();
  EXPECT_FALSE(calibration_from_message(message).ok());
}

}  // namespace
}  // namespace roomcast::client
