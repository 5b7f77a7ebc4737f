// SPDX-License-Identifier: Apache-2.0
#include "roomcast/capi/sensor_options.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::capi {
namespace {

using namespace std::chrono_literals;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// All that a program passes to roomcast_publish(), valid.
struct GivenSensor {
  GivenSensor() {
    join.size = sizeof(join);
    join.hub = "ws://127.0.0.1:1";
    join.name = "left";
    depth = {sizeof(depth), 64, 48, 60, 61, 32, 24, 0.1, 0.2, 0.3, 0.01, 0.02};
    color = {sizeof(color), 128, 96, 120, 120, 64, 48, 0, 0, 0, 0, 0};
    sensor.size = sizeof(sensor);
    sensor.depth = &depth;
    sensor.color = &color;
    sensor.color_from_depth = pose.data();
    sensor.world_from_depth = pose.data();
  }
  roomcast_options join{};
  roomcast_camera depth{}, color{};
  std::array<double, 16> pose{1, 0, 0, 0.5, 0, 1, 0, 2, 0, 0, 1, 3, 0, 0, 0, 1};
  roomcast_sensor_options sensor{};
};

TEST(SensorOptions, every_number_arrives) {
  const GivenSensor given;
  const auto options = publisher_options(&given.join, &given.sensor);
  ASSERT_TRUE(options.ok()) << options.error().message;
  EXPECT_EQ(options->name, "left");
  const CameraIntrinsics depth{.width = 64,
                               .height = 48,
                               .fx = 60,
                               .fy = 61,
                               .cx = 32,
                               .cy = 24,
                               .k1 = 0.1,
                               .k2 = 0.2,
                               .k3 = 0.3,
                               .p1 = 0.01,
                               .p2 = 0.02};
  EXPECT_EQ(options->calibration.depth, depth);
  EXPECT_EQ(options->calibration.color.width, 128);
  EXPECT_FALSE(options->calibration.color_is_registered);
  EXPECT_EQ(options->calibration.color_from_depth.translation_m, Eigen::Vector3d(0.5, 2, 3));
  ASSERT_TRUE(options->world_from_depth.has_value());
  EXPECT_EQ(options->world_from_depth->translation_m, Eigen::Vector3d(0.5, 2, 3));
  EXPECT_EQ(options->fps, 30);
}

TEST(SensorOptions, without_a_colour_camera_colour_is_in_the_depth_grid) {
  GivenSensor given;
  given.sensor.color = nullptr;
  given.sensor.world_from_depth = nullptr;
  const auto options = publisher_options(&given.join, &given.sensor);
  ASSERT_TRUE(options.ok());
  EXPECT_TRUE(options->calibration.color_is_registered);
  EXPECT_EQ(options->calibration.color, options->calibration.depth);
  EXPECT_FALSE(options->world_from_depth.has_value());
}

TEST(SensorOptions, fields_beyond_the_size_are_not_read) {
  GivenSensor given;
  given.sensor.size = offsetof(roomcast_sensor_options, color);
  given.sensor.color = reinterpret_cast<const roomcast_camera*>(1);
  given.sensor.world_from_depth = reinterpret_cast<const double*>(1);
  given.depth.size = offsetof(roomcast_camera, k1);
  const auto options = publisher_options(&given.join, &given.sensor);
  ASSERT_TRUE(options.ok());
  EXPECT_EQ(options->calibration.depth.k1, 0);
}

TEST(SensorOptions, what_is_no_sensor_is_refused_with_the_field) {
  const std::vector<std::pair<std::string, std::function<void(GivenSensor&)>>> cases = {
      {"name", [](auto& given) { given.join.name = nullptr; }},
      {"name", [](auto& given) { given.join.name = ""; }},
      {"name", [](auto& given) { given.join.size = 0; }},
      {"sensor->depth", [](auto& given) { given.sensor.depth = nullptr; }},
      {"sensor->depth", [](auto& given) { given.sensor.size = 0; }},
      {"width", [](auto& given) { given.depth.size = 0; }},
      {"width", [](auto& given) { given.depth.width = 0; }},
      {"width", [](auto& given) { given.depth.width = -64; }},
      {"height", [](auto& given) { given.depth.height = std::numeric_limits<int>::max(); }},
      {"sensor->color: camera field height", [](auto& given) { given.color.height = 0; }},
      {"fx", [](auto& given) { given.depth.fx = kNan; }},
      {"fx", [](auto& given) { given.depth.fx = 0; }},
      {"fy", [](auto& given) { given.depth.fy = -60; }},
      {"cx", [](auto& given) { given.depth.cx = kInfinity; }},
      {"p2", [](auto& given) { given.color.p2 = kNan; }},
      {"sensor->world_from_depth", [](auto& given) { given.pose[0] = -1; }},
      {"sensor->color_from_depth", [](auto& given) { given.pose[3] = kNan; }},
  };
  for (const auto& [field, spoil] : cases) {
    GivenSensor given;
    if (field == "sensor->world_from_depth") given.sensor.color_from_depth = nullptr;
    spoil(given);
    const auto options = publisher_options(&given.join, &given.sensor);
    ASSERT_FALSE(options.ok()) << field;
    EXPECT_NE(options.error().message.find(field), std::string::npos) << options.error().message;
  }
  const GivenSensor given;
  EXPECT_FALSE(publisher_options(nullptr, &given.sensor).ok());
  EXPECT_FALSE(publisher_options(&given.join, nullptr).ok());
}

TEST(SensorOptions, codec_settings_have_defaults_and_known_modes) {
  GivenSensor given;
  EXPECT_EQ(codec_choice(&given.sensor)->depth_bound_mm, 2);
  given.sensor.depth_mode = ROOMCAST_DEPTH_NEAR_LOSSLESS;
  given.sensor.depth_bound_mm = 5;
  EXPECT_EQ(codec_choice(&given.sensor)->depth_mode, codec::DepthMode::kNearLossless);
  EXPECT_EQ(codec_choice(&given.sensor)->depth_bound_mm, 5);
  given.sensor.depth_mode = 3;
  EXPECT_FALSE(codec_choice(&given.sensor).ok());
  given.sensor.depth_mode = -1;
  EXPECT_FALSE(codec_choice(&given.sensor).ok());
  given.sensor.depth_mode = 0;
  given.sensor.color_kbit_per_s = -1;
  EXPECT_FALSE(codec_choice(&given.sensor).ok());
}

class GivenCapture : public testing::Test {
 protected:
  GivenCapture() {
    calibration.depth = {.width = 16, .height = 16, .fx = 1, .fy = 1};
    calibration.color = {.width = 20, .height = 18, .fx = 1, .fy = 1};
    capture = {sizeof(capture), 0, depth.data(), 16, 16, color.data(), 20, 18};
  }
  [[nodiscard]] std::string refusal() const {
    const auto frame = given_frame(&capture, calibration, now);
    return frame ? "" : frame.error().message;
  }
  SensorCalibration calibration;
  std::vector<std::uint16_t> depth = std::vector<std::uint16_t>(256);
  std::vector<std::uint8_t> color = std::vector<std::uint8_t>(20 * 18 * 3);
  roomcast_capture capture{};
  const HostTime now{1h};
};

TEST_F(GivenCapture, pictures_are_used_where_they_are) {
  const auto frame = given_frame(&capture, calibration, now);
  ASSERT_TRUE(frame.ok());
  EXPECT_EQ(frame->depth_mm.data, depth.data());
  EXPECT_EQ(&frame->color.data->r, color.data());
  EXPECT_EQ(frame->capture_time, now);
}

TEST_F(GivenCapture, missing_and_misplaced_pictures_are_refused) {
  EXPECT_FALSE(given_frame(nullptr, calibration, now).ok());
  capture.depth_mm =
      reinterpret_cast<const std::uint16_t*>(reinterpret_cast<const char*>(depth.data()) + 1);
  EXPECT_NE(refusal().find("aligned"), std::string::npos);
  capture.depth_mm = nullptr;
  EXPECT_NE(refusal().find("depth_mm is NULL"), std::string::npos);
  capture.size = 0;
  EXPECT_NE(refusal().find("depth_mm is NULL"), std::string::npos);
}

TEST_F(GivenCapture, other_sizes_are_refused) {
  for (int* const side :
       {&capture.depth_width, &capture.depth_height, &capture.color_width, &capture.color_height}) {
    for (const int wrong : {0, -16, 15, 17, std::numeric_limits<int>::max()}) {
      const int right = std::exchange(*side, wrong);
      EXPECT_NE(refusal().find("pixels"), std::string::npos) << wrong;
      *side = right;
    }
  }
  EXPECT_EQ(refusal(), "");
}

TEST_F(GivenCapture, times_of_another_clock_are_refused) {
  const auto at = [&](nanoseconds age) {
    capture.capture_ns = (now - age).time_since_epoch().count();
    return refusal();
  };
  EXPECT_EQ(at(1s), "");
  EXPECT_EQ(at(-100ms), "");
  EXPECT_NE(at(11s), "");
  EXPECT_NE(at(-1s), "");
  for (const std::int64_t time :
       {std::int64_t{-1}, std::int64_t{1}, std::numeric_limits<std::int64_t>::min(),
        std::numeric_limits<std::int64_t>::max()}) {
    capture.capture_ns = time;
    EXPECT_NE(refusal(), "") << time;
  }
}

}  // namespace
}  // namespace roomcast::capi
