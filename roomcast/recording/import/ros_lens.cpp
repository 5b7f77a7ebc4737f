// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/ros_lens.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Geometry>

namespace roomcast::recording {
namespace {

constexpr double kQuaternionTolerance = 1e-2;
constexpr double kWidestRay = 2;  // the conversion ends at the picture's corner

int side(std::uint32_t size) {
  return static_cast<int>(std::min<std::uint32_t>(size, std::numeric_limits<int>::max()));
}

}  // namespace

Result<ConvertedLens> lens_of(const ros::CameraInfoMessage& info, bool is_rectified) {
  RationalLens lens;
  CameraIntrinsics& c = lens.camera;
  c.width = side(info.width), c.height = side(info.height);
  c.fx = is_rectified ? info.p[0] : info.k[0];
  c.cx = is_rectified ? info.p[2] : info.k[2];
  c.fy = is_rectified ? info.p[5] : info.k[4];
  c.cy = is_rectified ? info.p[6] : info.k[5];
  if (Status status = c.check(); !status)
    return malformed("a camera_info of it is invalid: " + status.error().message);
  const bool is_straight =
      is_rectified || std::ranges::all_of(info.d, [](double term) { return term == 0; });
  if (is_straight) return ConvertedLens{c, 0};
  const auto term = [&](std::size_t i) { return i < info.d.size() ? info.d[i] : 0.0; };
  if (info.distortion_model != "plumb_bob" && info.distortion_model != "rational_polynomial" &&
      info.distortion_model != "Brown Conrady" &&
      info.distortion_model != "Modified Brown Conrady") {
    return Error{ErrorCode::kUnsupported,
                 "the lens model \"" + info.distortion_model + "\" of it is not supported"};
  }
  c.k1 = term(0), c.k2 = term(1), c.p1 = term(2), c.p2 = term(3), c.k3 = term(4);
  if (info.distortion_model == "rational_polynomial")
    lens.k4 = term(5), lens.k5 = term(6), lens.k6 = term(7);
  return polynomial_lens(lens, kWidestRay);
}

void set_color_camera(const CameraIntrinsics& color, const RigidTransform& color_from_depth,
                      bool is_same_frame, SensorCalibration& calibration) {
  calibration.color = color;
  calibration.color_from_depth = color_from_depth;
  calibration.color_is_registered = is_same_frame && color == calibration.depth;
}

Result<RigidTransform> transform_of(const ros::TransformMessage& message) {
  const auto& q = message.rotation_xyzw;
  const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
  const Eigen::Vector3d translation(message.translation[0], message.translation[1],
                                    message.translation[2]);
  if (!(std::abs(rotation.norm() - 1) < kQuaternionTolerance) || !translation.allFinite())
    return malformed("a transform in it is not one");
  return RigidTransform{rotation.normalized().toRotationMatrix(), translation};
}

}  // namespace roomcast::recording
