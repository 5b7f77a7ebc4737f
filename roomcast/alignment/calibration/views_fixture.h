// SPDX-License-Identifier: Apache-2.0
// For tests: simulated frames of a sensor with known cameras that sees a board at a known pose.
// Colour is averaged over each pixel and has noise; depth is off by a known scale and bias and has
// noise that grows with the square of the distance.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "roomcast/alignment/calibration/charuco_board.h"
#include "roomcast/io/camera_json.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::alignment::calibration {

class SensorFixture {
 public:
  /// `truth`: true depth = reading * depth_scale_to_metre + depth_bias_m.
  SensorFixture(const io::RecordedCamera& truth, const CharucoBoard& board)
      : truth_(truth),
        board_(board),
        depth_rays_(ray_table(truth.calibration.depth)),
        color_rays_(ray_table(oversampled(truth.calibration.color))) {}

  [[nodiscard]] source::CapturedFrame see(const RigidTransform& color_from_board) {
    source::CapturedFrame frame;
    see_color(color_from_board, frame.color);
    see_depth(truth_.calibration.color_from_depth.inverse() * color_from_board, frame.depth_mm);
    return frame;
  }

 private:
  static constexpr int kSamples = 4;  // across a pixel
  static constexpr double kWallBehind_m = 0.4;

  static CameraIntrinsics oversampled(CameraIntrinsics camera) {
    camera.cx = kSamples * (camera.cx + 0.5) - 0.5, camera.cy = kSamples * (camera.cy + 0.5) - 0.5;
    camera.fx *= kSamples, camera.fy *= kSamples;
    camera.width *= kSamples, camera.height *= kSamples;
    return camera;
  }

  /// Where a ray of a camera meets the board's plane; z is its distance along the camera's axis.
  struct Hit {
    Eigen::Vector2d on_board_m;
    double z_m;
    bool is_on_board;
  };
  [[nodiscard]] Hit hit(const RigidTransform& camera_from_board, const Eigen::Vector2f& ray) const {
    const Eigen::Vector3d normal = camera_from_board.rotation.col(2);
    const Eigen::Vector3d direction(static_cast<double>(ray.x()), static_cast<double>(ray.y()), 1);
    const double z = normal.dot(camera_from_board.translation_m) / normal.dot(direction);
    const Eigen::Vector3d point =
        camera_from_board.rotation.transpose() * (z * direction - camera_from_board.translation_m);
    const Eigen::Vector2d size = board_.size_m();
    constexpr double kRim_m = 0.02;  // of the sheet around the print
    const bool on = z > 0 && point.x() > -kRim_m && point.y() > -kRim_m &&
                    point.x() < size.x() + kRim_m && point.y() < size.y() + kRim_m;
    return {point.head<2>(), z, on};
  }

  void see_color(const RigidTransform& color_from_board, ColorImage& color) {
    const CameraIntrinsics& camera = truth_.calibration.color;
    color.resize(camera.width, camera.height);
    std::normal_distribution<double> noise(0, 2);
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        double sum = 0;
        for (int i = 0; i < kSamples * kSamples; ++i) {
          const Hit h = hit(color_from_board, color_rays_.at(kSamples * x + i % kSamples,
                                                             kSamples * y + i / kSamples));
          sum += !h.is_on_board ? 120 : is_black(board_, h.on_board_m) ? 25 : 225;
        }
        const double grey = sum / (kSamples * kSamples) + noise(random_);
        const auto level = static_cast<std::uint8_t>(std::lround(std::clamp(grey, 0.0, 255.0)));
        color.at(x, y) = {level, level, level};
      }
    }
  }

  void see_depth(const RigidTransform& depth_from_board, DepthImage& depth_mm) {
    const CameraIntrinsics& camera = truth_.calibration.depth;
    depth_mm.resize(camera.width, camera.height);
    std::normal_distribution<double> noise(0, 1);
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        const Hit h = hit(depth_from_board, depth_rays_.at(x, y));
        double z_m = h.is_on_board ? h.z_m : depth_from_board.translation_m.z() + kWallBehind_m;
        z_m += 0.0015 * z_m * z_m * noise(random_);
        const double value = (z_m - truth_.depth_bias_m) / truth_.depth_scale_to_metre;
        depth_mm.at(x, y) = static_cast<std::uint16_t>(std::lround(value));
      }
    }
  }

  const io::RecordedCamera truth_;
  const CharucoBoard board_;
  const Image<Eigen::Vector2f> depth_rays_, color_rays_;
  std::mt19937 random_{1};
};

/// Poses of a board in front of the camera at varying places, distances and tilts.
inline std::vector<RigidTransform> held_about(const CharucoBoard& board, int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<RigidTransform> poses;
  const Eigen::Vector3d middle(0.5 * board.size_m().x(), 0.5 * board.size_m().y(), 0);
  for (int i = 0; i < count; ++i) {
    const double z = 0.55 + 0.6 * (i % 4) / 3.0;
    const Eigen::Vector3d at(0.3 * z * unit(random), 0.2 * z * unit(random), z);
    const double tilt = 0.75 * (0.6 + 0.4 * unit(random)) * (i % 5 == 0 ? 0 : 1);
    const double towards = 2.4 * i;
    const Eigen::Matrix3d rotation =
        (Eigen::AngleAxisd(tilt, Eigen::Vector3d(std::cos(towards), std::sin(towards), 0)) *
         Eigen::AngleAxisd(0.4 * unit(random), Eigen::Vector3d::UnitZ()))
            .toRotationMatrix();
    poses.push_back({rotation, at - rotation * middle});
  }
  return poses;
}

inline io::RecordedCamera kinect_fixture() {
  io::RecordedCamera truth;
  SensorCalibration& cameras = truth.calibration;
  cameras.depth = {640, 480, 580, 580, 319.5, 239.5};
  cameras.color = {640, 480, 527.3, 525.1, 324.2, 243.9, 0.09, -0.21, 0, 0.0008, -0.0006};
  cameras.color_from_depth.rotation = (Eigen::AngleAxisd(0.007, Eigen::Vector3d::UnitX()) *
                                       Eigen::AngleAxisd(-0.011, Eigen::Vector3d::UnitY()) *
                                       Eigen::AngleAxisd(0.004, Eigen::Vector3d::UnitZ()))
                                          .toRotationMatrix();
  cameras.color_from_depth.translation_m = {-0.0247, 0.0006, -0.0021};
  truth.depth_scale_to_metre = 0.001 * 1.008;
  truth.depth_bias_m = -0.009;
  return truth;
}

}  // namespace roomcast::alignment::calibration
