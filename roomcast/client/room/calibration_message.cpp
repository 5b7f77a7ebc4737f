// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room/calibration_message.h"

#include "roomcast/wire/limits.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::client {
namespace {

static_assert(kMaxImageSide == wire::kMaxImageSide,
              "what a source may give, the wire must be able to carry");

void write_intrinsics(const CameraIntrinsics& camera, wire::pb::Intrinsics& message) {
  message.set_width(static_cast<unsigned>(camera.width));
  message.set_height(static_cast<unsigned>(camera.height));
  message.set_fx(camera.fx);
  message.set_fy(camera.fy);
  message.set_cx(camera.cx);
  message.set_cy(camera.cy);
  message.set_k1(camera.k1);
  message.set_k2(camera.k2);
  message.set_k3(camera.k3);
  message.set_p1(camera.p1);
  message.set_p2(camera.p2);
}

Result<CameraIntrinsics> read_intrinsics(const wire::pb::Intrinsics& message) {
  CameraIntrinsics camera;
  camera.width = static_cast<int>(message.width());
  camera.height = static_cast<int>(message.height());
  camera.fx = message.fx();
  camera.fy = message.fy();
  camera.cx = message.cx();
  camera.cy = message.cy();
  camera.k1 = message.k1();
  camera.k2 = message.k2();
  camera.k3 = message.k3();
  camera.p1 = message.p1();
  camera.p2 = message.p2();
  if (auto status = camera.check(); !status)
    return Error{ErrorCode::kMalformed, status.error().message};
  return camera;
}

}  // namespace

wire::pb::Calibration message_from_calibration(const SensorCalibration& calibration) {
  wire::pb::Calibration message;
  write_intrinsics(calibration.depth, *message.mutable_depth());
  write_intrinsics(calibration.color, *message.mutable_color());
  wire::write_transform(calibration.color_from_depth, *message.mutable_color_from_depth());
  message.set_color_is_registered(calibration.color_is_registered);
  return message;
}

Result<SensorCalibration> calibration_from_message(const wire::pb::Calibration& message) {
  SensorCalibration calibration;
  auto depth = read_intrinsics(message.depth());
  if (!depth) return depth.error();
  auto color = read_intrinsics(message.color());
  if (!color) return color.error();
  auto color_from_depth = wire::read_transform(message.color_from_depth());
  if (!color_from_depth) return color_from_depth.error();
  return SensorCalibration{*depth, *color, *color_from_depth, message.color_is_registered()};
}

}  // namespace roomcast::client
