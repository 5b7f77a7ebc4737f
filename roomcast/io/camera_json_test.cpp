// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/camera_json.h"

#include <functional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/io/json_fields.h"
#include "roomcast/recording/dataset/recording_fixture.h"

namespace roomcast::io {
namespace {

using nlohmann::json;

Result<RecordedCamera> read(const std::string& text) {
  const TemporaryFolder folder;
  recording::put_text(folder / "camera.json", text);
  return read_camera_json(folder / "camera.json");
}

std::string refusal_of(const std::string& text) {
  const auto camera = read(text);
  EXPECT_FALSE(camera.ok());
  if (camera.ok()) return {};
  EXPECT_NE(camera.error().message.find("camera.json"), std::string::npos);
  return camera.error().message;
}

/// A valid file after a change.
std::string changed(const std::function<void(json&)>& change) {
  json camera = json::parse(camera_json_text(recording::small_calibration()));
  change(camera);
  return camera.dump();
}

TEST(CameraJson, reads_back_its_own_output) {
  const SensorCalibration written = recording::small_calibration();
  const auto camera = read(camera_json_text(written));
  ASSERT_TRUE(camera.ok()) << camera.error().message;
  EXPECT_TRUE(camera->has_color);
  EXPECT_EQ(camera->calibration.depth, written.depth);
  EXPECT_EQ(camera->calibration.color, written.color);
  EXPECT_FALSE(camera->calibration.color_is_registered);
  EXPECT_LT(
      (camera->calibration.color_from_depth.translation_m - Eigen::Vector3d(-0.05, 0, 0)).norm(),
      1e-12);
  EXPECT_EQ(camera->depth_scale_to_metre, 0.001);
}

TEST(CameraJson, lens_terms_may_be_left_out) {
  const auto camera =
      read(changed([](json& c) { c["color"].erase("k1"), c["color"].erase("p2"); }));
  ASSERT_TRUE(camera.ok());
  EXPECT_EQ(camera->calibration.color.k1, 0);
}

TEST(CameraJson, a_sensor_without_colour_counts_as_registered) {
  const auto camera = read(changed([](json& c) { c.erase("color"); }));
  ASSERT_TRUE(camera.ok());
  EXPECT_FALSE(camera->has_color);
  EXPECT_TRUE(camera->calibration.color_is_registered);
  EXPECT_EQ(camera->calibration.color, camera->calibration.depth);
}

TEST(CameraJson, scale_and_invalid_values_are_read) {
  const auto camera = read(changed([](json& c) {
    c["depth_scale_to_metre"] = 0.0002;
    c["invalid_depth"] = {0, 65535};
  }));
  ASSERT_TRUE(camera.ok());
  EXPECT_EQ(camera->depth_scale_to_metre, 0.0002);
  EXPECT_EQ(camera->invalid_depth.back(), 65535);
}

TEST(CameraJson, the_flat_form_is_read) {
  const auto camera = read(R"({"width": 640, "height": 480, "depth_scale_to_metre": 0.001,
    "depth_intrinsics": {"fx": 585, "fy": 586, "cx": 320, "cy": 240, "distortion": "none given"},
    "colour_registered_to_depth": false,
    "colour_intrinsics_estimated": {"fx": 532, "fy": 532, "cx": 320, "cy": 240,
      "depth_to_colour_translation_m": [-0.025, 0, 0]}})");
  ASSERT_TRUE(camera.ok()) << camera.error().message;
  EXPECT_EQ(camera->calibration.depth.fy, 586);
  EXPECT_EQ(camera->calibration.color.fx, 532);
  EXPECT_EQ(camera->calibration.color.width, 640);
  EXPECT_EQ(camera->calibration.color_from_depth.translation_m.x(), -0.025);
}

TEST(CameraJson, the_flat_form_knows_registered_and_no_colour) {
  const std::string start = R"({"width": 64, "height": 48,
    "depth_intrinsics": {"fx": 58, "fy": 58, "cx": 32, "cy": 24}, "colour_registered_to_depth": )";
  const auto registered = read(start + "true}");
  ASSERT_TRUE(registered.ok());
  EXPECT_TRUE(registered->has_color);
  EXPECT_TRUE(registered->calibration.color_is_registered);
  const auto none = read(start + "null}");
  ASSERT_TRUE(none.ok());
  EXPECT_FALSE(none->has_color);
}

TEST(CameraJson, the_flat_form_takes_a_recorded_transform) {
  const std::string start = R"({"width": 64, "height": 48,
    "depth_intrinsics": {"fx": 58, "fy": 58, "cx": 32, "cy": 24}, "colour_registered_to_depth": false,
    "colour_intrinsics": {"fx": 60, "fy": 60, "cx": 32, "cy": 24},
    "colour_tf_recorded": {"translation_m": [0.014, 0, 0], "rotation_xyzw": )";
  const auto camera = read(start + "[0, 0, 0.7071068, 0.7071068]}}");  // a quarter turn about z
  ASSERT_TRUE(camera.ok()) << camera.error().message;
  const auto turned = camera->calibration.color_from_depth * Eigen::Vector3d(1, 0, 0);
  EXPECT_LT((turned - Eigen::Vector3d(0.014, 1, 0)).norm(), 1e-6);
  EXPECT_NE(refusal_of(start + "[0, 0, 0, 0]}}").find("rotation_xyzw"), std::string::npos);
}

TEST(CameraJson, names_the_field_that_is_wrong) {
  const std::pair<std::function<void(json&)>, const char*> cases[] = {
      {[](json& c) { c.erase("depth"); }, "depth is missing"},
      {[](json& c) { c["depth"] = 3; }, "depth must be an object"},
      {[](json& c) { c["depth"].erase("fx"); }, "depth.fx is missing"},
      {[](json& c) { c["depth"]["fx"] = "wide"; }, "depth.fx must be a number"},
      {[](json& c) { c["depth"]["fx"] = -1; }, "depth is refused: camera field fx"},
      {[](json& c) { c["depth"]["width"] = 10.5; }, "depth.width must be a whole number"},
      {[](json& c) { c["color"]["height"] = 100000; }, "color is refused: camera field height"},
      {[](json& c) { c["color"]["distortion_model"] = "fisheye"; }, "color.distortion_model"},
      {[](json& c) { c.erase("color_from_depth"); }, "color_from_depth is missing"},
      {[](json& c) {
         c["color_from_depth"] = {1, 2, 3};
       },
       "color_from_depth"},
      {[](json& c) { c["color_from_depth"][0] = 2; }, "color_from_depth"},
      {[](json& c) { c["color_from_depth"][5] = "x"; }, "color_from_depth"},
      {[](json& c) { c["color_is_registered"] = true; }, "size of depth"},
      {[](json& c) { c["color_is_registered"] = 1; }, "color_is_registered"},
      {[](json& c) { c["depth_scale_to_metre"] = 0; }, "depth_scale_to_metre"},
      {[](json& c) { c["invalid_depth"] = {-1}; }, "invalid_depth"},
      {[](json& c) { c["invalid_depth"] = {65536}; }, "invalid_depth"},
  };
  for (const auto& [change, part] : cases) {
    const std::string message = refusal_of(changed(change));
    EXPECT_NE(message.find(part), std::string::npos) << part << " / " << message;
  }
}

TEST(CameraJson, numbers_that_no_lens_has_are_refused) {
  for (const double focal : {1e9, 0.001}) {
    const auto refusal = refusal_of(changed([&](json& c) { c["depth"]["fx"] = focal; }));
    EXPECT_NE(refusal.find("focal length"), std::string::npos) << refusal;
  }
  const auto refusal = refusal_of(changed([](json& c) { c["color"]["cy"] = -1e5; }));
  EXPECT_NE(refusal.find("centre"), std::string::npos) << refusal;
}

TEST(CameraJson, refuses_input_other_than_a_json_object) {
  EXPECT_NE(refusal_of("{\"depth\": ").find("not valid JSON"), std::string::npos);
  EXPECT_NE(refusal_of("").find("not valid JSON"), std::string::npos);
  EXPECT_NE(refusal_of("[]").find("one JSON object"), std::string::npos);
  EXPECT_NE(refusal_of(std::string(100000, '[')).find("not valid JSON"), std::string::npos);
  EXPECT_FALSE(read_camera_json("/nowhere/camera.json").ok());
}

}  // namespace
}  // namespace roomcast::io
