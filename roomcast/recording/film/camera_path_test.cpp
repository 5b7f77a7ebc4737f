// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/film/camera_path.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/io/file_bytes.h"

namespace roomcast::recording {
namespace {

using Eigen::Vector3d;

const Vector3d kAhead(0, 1, -5);

std::vector<CameraKey> straight_walk() {
  return {{0, {0, 1, 0}, kAhead}, {1, {1, 1, 0}, kAhead}, {3, {3, 1, 0}, kAhead}};
}

Vector3d eye_at(const CameraPath& path, double time_s) {
  return path.world_from_view(time_s).translation_m;
}

TEST(CameraPath, passes_its_keys_and_stands_still_beyond_them) {
  const auto path = CameraPath::create(straight_walk());
  ASSERT_TRUE(path.ok());
  for (const CameraKey& key : straight_walk())
    EXPECT_LT((eye_at(*path, key.time_s) - key.eye_m).norm(), 1e-12);
  EXPECT_EQ(eye_at(*path, -7), Vector3d(0, 1, 0));
  EXPECT_EQ(eye_at(*path, 99), Vector3d(3, 1, 0));
}

TEST(CameraPath, an_even_walk_stays_even_between_keys_that_are_not) {
  const auto path = CameraPath::create(straight_walk());
  for (double t = 0; t <= 3; t += 0.1) EXPECT_NEAR(eye_at(*path, t).x(), t, 1e-9);
}

TEST(CameraPath, has_no_sudden_change_of_speed_at_a_key) {
  const auto path =
      CameraPath::create({{0, {0, 1, 0}, kAhead}, {1, {1, 1, 0}, kAhead}, {2, {1, 2, 0}, kAhead}});
  constexpr double kStep_s = 1e-4;
  const Vector3d before = (eye_at(*path, 1) - eye_at(*path, 1 - kStep_s)) / kStep_s;
  const Vector3d after = (eye_at(*path, 1 + kStep_s) - eye_at(*path, 1)) / kStep_s;
  EXPECT_LT((before - after).norm(), 0.01);
}

TEST(CameraPath, looks_at_its_target) {
  const auto path = CameraPath::create(straight_walk());
  const RigidTransform pose = path->world_from_view(1.7);
  const Vector3d forward = pose.rotation * Vector3d(0, 0, -1);
  EXPECT_LT((forward - (kAhead - pose.translation_m).normalized()).norm(), 1e-9);
}

TEST(CameraPath, that_runs_through_its_target_goes_on_looking_ahead) {
  const auto path = CameraPath::create({{0, {0, 0, 1}, {0, 0, 0}}, {2, {0, 0, -1}, {0, 0, 0}}});
  EXPECT_TRUE(path->world_from_view(1).rotation.allFinite());
}

TEST(CameraPath, refuses_invalid_paths) {
  EXPECT_FALSE(CameraPath::create({}).ok());
  EXPECT_FALSE(CameraPath::create({{0, kAhead, kAhead}}).ok());
  EXPECT_FALSE(CameraPath::create({{1, {0, 0, 0}, kAhead}, {1, {1, 0, 0}, kAhead}}).ok());
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(CameraPath::create({{0, {nothing, 0, 0}, kAhead}}).ok());
}

TEST(SwingingPath, keeps_its_distance_and_swings_to_both_sides) {
  const Vector3d pivot(0, 1, -2);
  const CameraPath path = swinging_path({0, 1.5, 0}, pivot, 60);
  double left = 0, right = 0;
  for (double t = 0; t < 60; t += 0.5) {
    const Vector3d eye = eye_at(path, t);
    EXPECT_NEAR((eye - pivot).norm(), std::hypot(2, 0.5), 0.01);
    left = std::min(left, eye.x());
    right = std::max(right, eye.x());
  }
  EXPECT_NEAR(right, 2 * std::sin(25 * std::numbers::pi / 180), 0.01);
  EXPECT_NEAR(left, -right, 0.01);
}

class CameraPathFile : public testing::Test {
 protected:
  Result<CameraPath> read(const std::string& text) {
    EXPECT_TRUE(io::write_file(file_, text).ok());
    return read_camera_path(file_);
  }

 private:
  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "path.json";
};

TEST_F(CameraPathFile, holds_keys) {
  const auto path = read(R"({"keys": [{"time_s": 0, "at": [1, 2, 3], "look": [0, 0, 0]},
                                      {"time_s": 2, "at": [3, 2, 3], "look": [0, 0, 0]}]})");
  ASSERT_TRUE(path.ok()) << path.error().message;
  EXPECT_NEAR(eye_at(*path, 1).x(), 2, 1e-9);
}

TEST_F(CameraPathFile, errors_name_the_file_and_the_fault) {
  const auto no_place = read(R"({"keys": [{"time_s": 0, "at": [1, 2], "look": [0, 0, 0]}]})");
  ASSERT_FALSE(no_place.ok());
  EXPECT_NE(no_place.error().message.find("at"), std::string::npos);
  EXPECT_NE(no_place.error().message.find("path.json"), std::string::npos);
  EXPECT_FALSE(read("{}").ok());
  EXPECT_FALSE(read("not json").ok());
}

}  // namespace
}  // namespace roomcast::recording
