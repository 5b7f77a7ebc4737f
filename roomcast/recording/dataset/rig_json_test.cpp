// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/dataset/rig_json.h"

#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/recording/dataset/recording_fixture.h"

namespace roomcast::recording {
namespace {

using nlohmann::json;

RigDescription two_sensors() {
  RigDescription rig{25, "a test", {}};
  rig.sensors.push_back({"s0", "s0", RigidTransform{}, 0, 8, {23}});
  rig.sensors.push_back({"kitchen", "two/k", std::nullopt, -1.5, 0, {}, 0.98});
  rig.sensors[0].world_from_depth->translation_m = {1, 2, 3};
  rig.sensors[0].expected_error_mm = 39.5;
  rig.scale_error = 0.018;
  return rig;
}

Result<RigDescription> read(const std::string& text) {
  const TemporaryFolder folder;
  put_text(folder / "rig.json", text);
  return read_rig_json(folder / "rig.json");
}

TEST(RigJson, reads_back_its_own_output) {
  const auto rig = read(rig_json_text(two_sensors()));
  ASSERT_TRUE(rig.ok()) << rig.error().message;
  EXPECT_EQ(rig->fps, 25);
  EXPECT_EQ(rig->source, "a test");
  ASSERT_EQ(rig->sensors.size(), 2U);
  EXPECT_EQ(rig->sensors[0].world_from_depth->translation_m, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(rig->sensors[0].rate_ppm, 8);
  EXPECT_EQ(rig->sensors[0].drop, (std::vector<std::uint64_t>{23}));
  EXPECT_EQ(rig->sensors[1].id, "kitchen");
  EXPECT_EQ(rig->sensors[1].path, "two/k");
  EXPECT_FALSE(rig->sensors[1].world_from_depth);
  EXPECT_EQ(rig->sensors[1].clock_offset_s, -1.5);
  EXPECT_EQ(rig->sensors[0].depth_scale, 1);
  EXPECT_EQ(rig->sensors[1].depth_scale, 0.98);
  EXPECT_EQ(rig->sensors[0].expected_error_mm, 39.5);
  EXPECT_EQ(rig->sensors[1].expected_error_mm, 0);
  EXPECT_EQ(rig->scale_error, 0.018);
}

TEST(RigJson, names_the_field_that_is_wrong) {
  const std::pair<std::function<void(json&)>, const char*> cases[] = {
      {[](json& r) { r.erase("fps"); }, "fps is missing"},
      {[](json& r) { r["fps"] = 0; }, "fps"},
      {[](json& r) { r["fps"] = 241; }, "fps"},
      {[](json& r) { r["fps"] = "fast"; }, "fps must be a number"},
      {[](json& r) { r.erase("sensors"); }, "sensors is missing"},
      {[](json& r) { r["sensors"] = json::array(); }, "sensors must list 1 to 32"},
      {[](json& r) { r["sensors"] = "s0"; }, "sensors must be a list"},
      {[](json& r) { r["sensors"][1] = 7; }, "sensors[1] must be an object"},
      {[](json& r) { r["sensors"][1].erase("id"); }, "sensors[1].id is missing"},
      {[](json& r) { r["sensors"][1]["id"] = ""; }, "sensors[1].id"},
      {[](json& r) { r["sensors"][1]["id"] = "a\nb"; }, "sensors[1].id"},
      {[](json& r) { r["sensors"][1]["id"] = std::string(65, 'a'); }, "sensors[1].id"},
      {[](json& r) { r["sensors"][1]["id"] = "s0"; }, "two sensors with the id s0"},
      {[](json& r) { r["sensors"][1]["path"] = "../x"; }, "sensors[1].path"},
      {[](json& r) { r["sensors"][1]["path"] = "/etc"; }, "sensors[1].path"},
      {[](json& r) { r["sensors"][0]["world_from_depth"][0] = 5; }, "sensors[0].world_from_depth"},
      {[](json& r) { r["sensors"][0]["world_from_depth"] = {1}; }, "sensors[0].world_from_depth"},
      {[](json& r) { r["sensors"][0]["world_from_depth"] = 1; }, "sensors[0].world_from_depth"},
      {[](json& r) { r["sensors"][0]["clock_offset_s"] = 1e300; }, "clock_offset_s"},
      {[](json& r) { r["sensors"][0]["rate_ppm"] = "x"; }, "rate_ppm"},
      {[](json& r) { r["sensors"][0]["drop"] = {-1}; }, "drop"},
      {[](json& r) { r["sensors"][0]["drop"] = {1.5}; }, "drop"},
      {[](json& r) { r["sensors"][0]["depth_scale"] = 0; }, "sensors[0].depth_scale"},
      {[](json& r) { r["sensors"][0]["depth_scale"] = 2.1; }, "sensors[0].depth_scale"},
      {[](json& r) { r["sensors"][0]["depth_scale"] = "1"; }, "sensors[0].depth_scale"},
      {[](json& r) { r["sensors"][0]["expected_error_mm"] = -1; }, "sensors[0].expected_error_mm"},
      {[](json& r) { r["sensors"][0]["expected_error_mm"] = 1e9; }, "expected_error_mm"},
      {[](json& r) { r["scale_error"] = -0.1; }, "scale_error"},
      {[](json& r) { r["scale_error"] = 2; }, "scale_error"},
  };
  for (const auto& [change, part] : cases) {
    json changed = json::parse(rig_json_text(two_sensors()));
    change(changed);
    const auto rig = read(changed.dump());
    ASSERT_FALSE(rig.ok()) << part;
    EXPECT_EQ(rig.error().code, ErrorCode::kMalformed);
    EXPECT_NE(rig.error().message.find(part), std::string::npos)
        << part << " / " << rig.error().message;
    EXPECT_NE(rig.error().message.find("rig.json"), std::string::npos);
  }
}

TEST(RigJson, another_version_is_unsupported) {
  json later = json::parse(rig_json_text(two_sensors()));
  later["version"] = 2;
  const auto rig = read(later.dump());
  ASSERT_FALSE(rig.ok());
  EXPECT_EQ(rig.error().code, ErrorCode::kUnsupported);
}

TEST(RigJson, refuses_broken_and_missing_files) {
  EXPECT_EQ(read("{").error().code, ErrorCode::kMalformed);
  EXPECT_EQ(read("[1]").error().code, ErrorCode::kMalformed);
  EXPECT_EQ(read_rig_json("/nowhere/rig.json").error().code, ErrorCode::kNotFound);
}

TEST(RigJson, paths_that_leave_the_folder_are_recognised) {
  EXPECT_TRUE(stays_inside("depth/000001.png"));
  EXPECT_TRUE(stays_inside("a..b/c"));
  EXPECT_FALSE(stays_inside(""));
  EXPECT_FALSE(stays_inside("/a"));
  EXPECT_FALSE(stays_inside("a/../../b"));
}

}  // namespace
}  // namespace roomcast::recording
