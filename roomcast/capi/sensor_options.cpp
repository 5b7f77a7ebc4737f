// SPDX-License-Identifier: Apache-2.0
#include "roomcast/capi/sensor_options.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "roomcast/capi/c_border.h"
#include "roomcast/sensor/sender/capture_time.h"

namespace roomcast::capi {
namespace {

constexpr double kUsualFps = 30;

Error in_field(const std::string& field, const Error& error) {
  return {error.code, field + ": " + error.message};
}

Result<CameraIntrinsics> camera(const roomcast_camera* from, const char* field) {
  const roomcast_camera given = known_part(from);
  const CameraIntrinsics camera{.width = given.width,
                                .height = given.height,
                                .fx = given.fx,
                                .fy = given.fy,
                                .cx = given.cx,
                                .cy = given.cy,
                                .k1 = given.k1,
                                .k2 = given.k2,
                                .k3 = given.k3,
                                .p1 = given.p1,
                                .p2 = given.p2};
  if (auto status = camera.check(); !status) return in_field(field, status.error());
  return camera;
}

/// Nothing for NULL.
Result<std::optional<RigidTransform>> transform(const double* row_major, const char* field) {
  if (row_major == nullptr) return std::optional<RigidTransform>();
  const auto read = transform_from_row_major(std::span(row_major, 16));
  if (!read) return in_field(field, read.error());
  return std::optional(*read);
}

Result<SensorCalibration> calibration(const roomcast_sensor_options& sensor) {
  if (sensor.depth == nullptr) return invalid_argument("sensor->depth is NULL");
  const auto depth = camera(sensor.depth, "sensor->depth");
  if (!depth) return depth.error();
  SensorCalibration calibration{
      .depth = *depth, .color = *depth, .color_from_depth = {}, .color_is_registered = true};
  if (sensor.color == nullptr) return calibration;
  const auto color = camera(sensor.color, "sensor->color");
  if (!color) return color.error();
  const auto color_from_depth = transform(sensor.color_from_depth, "sensor->color_from_depth");
  if (!color_from_depth) return color_from_depth.error();
  calibration.color = *color;
  calibration.color_from_depth = color_from_depth->value_or(RigidTransform());
  calibration.color_is_registered = false;
  return calibration;
}

Status check_size(const char* picture, int width, int height, const CameraIntrinsics& camera) {
  if (width == camera.width && height == camera.height) return {};
  return invalid_argument(std::string(picture) + " has " + std::to_string(width) + " x " +
                          std::to_string(height) + " pixels, and its camera " +
                          std::to_string(camera.width) + " x " + std::to_string(camera.height));
}

Result<HostTime> capture_time(std::int64_t capture_ns, HostTime now) {
  if (capture_ns == 0) return now;
  const HostTime time{nanoseconds(capture_ns)};
  if (!sensor::is_recent(time, now)) {
    return invalid_argument("capture_ns is not of the last ten seconds by roomcast_host_time_ns()");
  }
  return time;
}

}  // namespace

Result<client::PublisherOptions> publisher_options(const roomcast_options* options,
                                                   const roomcast_sensor_options* sensor) {
  if (options == nullptr) return invalid_argument("options is NULL");
  if (sensor == nullptr) return invalid_argument("sensor is NULL");
  const roomcast_options join = known_part(options);
  const roomcast_sensor_options given = known_part(sensor);
  client::PublisherOptions out;
  out.hub_url = text(join.hub);
  out.room = text(join.room);
  out.name = text(join.name);
  if (out.name.empty()) return invalid_argument("a sensor needs a name: options->name is missing");
  out.credential = client::credential_of(text(join.token));
  auto calibrated = calibration(given);
  if (!calibrated) return calibrated.error();
  out.calibration = *calibrated;
  auto pose = transform(given.world_from_depth, "sensor->world_from_depth");
  if (!pose) return pose.error();
  out.world_from_depth = *pose;
  out.send_unwatched = given.send_unwatched != 0;
  out.fps = given.fps == 0 ? kUsualFps : given.fps;
  return out;
}

Result<sensor::CodecChoice> codec_choice(const roomcast_sensor_options* sensor) {
  const roomcast_sensor_options given = known_part(sensor);
  sensor::CodecChoice choice;
  switch (given.depth_mode) {
    case ROOMCAST_DEPTH_LIVE:
      choice.depth_mode = codec::DepthMode::kLive;
      break;
    case ROOMCAST_DEPTH_NEAR_LOSSLESS:
      choice.depth_mode = codec::DepthMode::kNearLossless;
      break;
    case ROOMCAST_DEPTH_LOSSLESS:
      choice.depth_mode = codec::DepthMode::kLossless;
      break;
    default:
      return invalid_argument("sensor->depth_mode is none of ROOMCAST_DEPTH_...");
  }
  if (given.depth_bound_mm != 0) choice.depth_bound_mm = given.depth_bound_mm;
  if (given.color_kbit_per_s < 0) return invalid_argument("sensor->color_kbit_per_s is negative");
  choice.color_kbit_per_s = given.color_kbit_per_s;
  return choice;
}

Result<GivenFrame> given_frame(const roomcast_capture* capture,
                               const SensorCalibration& calibration, HostTime now) {
  if (capture == nullptr) return invalid_argument("capture is NULL");
  const roomcast_capture given = known_part(capture);
  if (given.depth_mm == nullptr) return invalid_argument("capture->depth_mm is NULL");
  if (reinterpret_cast<std::uintptr_t>(given.depth_mm) % alignof(std::uint16_t) != 0)
    return invalid_argument("capture->depth_mm is not aligned to 2 bytes");
  if (auto status =
          check_size("depth_mm", given.depth_width, given.depth_height, calibration.depth);
      !status)
    return status.error();
  const auto time = capture_time(given.capture_ns, now);
  if (!time) return time.error();
  GivenFrame frame{
      .depth_mm = {given.depth_mm, given.depth_width, given.depth_height, given.depth_width},
      .color = {},
      .capture_time = *time};
  if (given.color_rgb == nullptr) return frame;
  if (auto status =
          check_size("color_rgb", given.color_width, given.color_height, calibration.color);
      !status)
    return status.error();
  frame.color = {reinterpret_cast<const Rgb8*>(given.color_rgb), given.color_width,
                 given.color_height, given.color_width};
  return frame;
}

}  // namespace roomcast::capi
