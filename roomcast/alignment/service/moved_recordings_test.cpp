// SPDX-License-Identifier: Apache-2.0
// Real, stationary sensors, if their recordings are available (ROOMCAST_DATA): none is reported as
// moved; each is reported once its pictures are replaced by those that it would see from 2 cm or
// half a degree away.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/alignment/bundle/steady_depth.h"
#include "roomcast/alignment/motion/pose_change_detector.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::alignment {
namespace {

struct Recorded {
  CameraIntrinsics camera;
  std::vector<DepthImage> depth_mm;
};

Recorded read(const std::string& folder) {
  sensor::SourceOptions options;
  options.pace = source::Pace::kAsFastAsPossible;
  options.loop = false;
  auto source = sensor::open_source("tum:" + folder, options).value();
  Recorded recorded{source->description().calibration.depth, {}};
  source::CapturedFrame frame;
  while (source->next(frame, {}).value()) recorded.depth_mm.push_back(frame.depth_mm);
  return recorded;
}

alignment::MotionCheck check_of_first_half(const Recorded& recorded) {
  const std::size_t half = (recorded.depth_mm.size() + 1) / 2;
  alignment::CalibrationBundle bundle;
  bundle.calibration.depth = recorded.camera;
  bundle.depth_mm = alignment::steady_depth(std::span(recorded.depth_mm).first(half)).depth_mm;
  return alignment::MotionCheck(bundle);
}

/// The picture that the sensor would see after the motion `push`; surfaces behind edges stay
/// unknown.
DepthImage seen_from(const DepthImage& depth_mm, const CameraIntrinsics& camera,
                     const RigidTransform& push) {
  const auto rays = ray_table(camera);
  const RigidTransform now_from_then = push.inverse();
  DepthImage seen(depth_mm.width(), depth_mm.height());
  for (int y = 0; y < depth_mm.height(); ++y) {
    for (int x = 0; x < depth_mm.width(); ++x) {
      if (depth_mm.at(x, y) == 0 || std::isnan(rays.at(x, y).x())) continue;
      const Eigen::Vector3d point =
          now_from_then * (0.001 * depth_mm.at(x, y) * rays.at(x, y).cast<double>().homogeneous());
      const auto pixel = project(camera, point);
      if (!pixel) continue;
      const auto u = std::lround(pixel->x()), v = std::lround(pixel->y());
      if (u < 0 || v < 0 || u >= seen.width() || v >= seen.height()) continue;
      const auto z_mm = static_cast<std::uint16_t>(std::lround(1000 * point.z()));
      auto& there = seen.at(static_cast<int>(u), static_cast<int>(v));
      if (there == 0 || z_mm < there) there = z_mm;
    }
  }
  return seen;
}

class MovedRecordings : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    folder_ = recording::shared_data() / GetParam();
    if (!std::filesystem::exists(folder_))
      GTEST_SKIP() << "no recordings at " << folder_ << "; set ROOMCAST_DATA to test with them";
  }
  std::filesystem::path folder_;
};

TEST_P(MovedRecordings, a_sensor_that_stands_is_not_taken_for_moved) {
  const auto recorded = read(folder_);
  const auto check = check_of_first_half(recorded);
  for (std::size_t i = recorded.depth_mm.size() / 2; i < recorded.depth_mm.size(); ++i) {
    const auto evidence = check.compare(recorded.depth_mm[i].view());
    EXPECT_NE(alignment::indicates_motion(evidence), true)
        << i << ": " << 1000 * evidence.shift_m << " mm, " << evidence.angle_rad << " rad";
  }
}

TEST_P(MovedRecordings, half_a_degree_and_two_centimetres_are_seen) {
  constexpr double kDegree = std::numbers::pi / 180;
  const auto recorded = read(folder_);
  const auto check = check_of_first_half(recorded);
  int noticed = 0, pushes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    RigidTransform turn, shift;
    turn.rotation =
        Eigen::AngleAxisd(0.5 * kDegree, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
    shift.translation_m = 0.02 * Eigen::Vector3d::Unit(axis);
    for (const RigidTransform& push : {turn, shift}) {
      const auto seen = seen_from(recorded.depth_mm.back(), recorded.camera, push);
      const auto evidence = check.compare(seen.view());
      const bool says = alignment::indicates_motion(evidence) == true;
      noticed += says;
      ++pushes;
      if (!says) {
        GTEST_LOG_(INFO) << "axis " << axis << (push.translation_m.norm() > 0 ? " shift" : " turn")
                         << " found as " << 1000 * evidence.shift_m << " mm, "
                         << evidence.angle_rad / kDegree << " deg, gain " << evidence.gain
                         << ", agree " << evidence.agree_if_moved;
      }
    }
  }
  EXPECT_GE(noticed, pushes - 1) << "a bare wall may hide a shift along it";
}

INSTANTIATE_TEST_SUITE_P(Real, MovedRecordings,
                         testing::Values("kinect1_oni_fixed", "azurekinect_room",
                                         "azurekinect_ceiling"));

}  // namespace
}  // namespace roomcast::alignment
