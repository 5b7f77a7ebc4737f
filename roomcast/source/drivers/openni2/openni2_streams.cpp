// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/openni2/openni2_streams.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include "roomcast/source/camera/copy_rows.h"

namespace roomcast::source {
namespace {

constexpr int kWidestPicture = 640;
constexpr int kWantedFps = 30;
constexpr double kHorizontalField = 1.0145, kVerticalField = 0.7898;  // PrimeSense's, radians

openni::PixelFormat wanted_format(openni::SensorType sensor) {
  return sensor == openni::SENSOR_DEPTH ? openni::PIXEL_FORMAT_DEPTH_1_MM
                                        : openni::PIXEL_FORMAT_RGB888;
}

bool is_better(const openni::VideoMode& a, const openni::VideoMode& b) {
  if (a.getResolutionX() != b.getResolutionX()) return a.getResolutionX() > b.getResolutionX();
  return std::abs(a.getFps() - kWantedFps) < std::abs(b.getFps() - kWantedFps);
}

/// Finds the best mode of the required format; false if there is none.
bool best_mode(const openni::SensorInfo& sensor, openni::VideoMode& best) {
  const auto& modes = sensor.getSupportedVideoModes();
  bool found = false;
  for (int i = 0; i < modes.getSize(); ++i) {
    const openni::VideoMode& mode = modes[i];
    if (mode.getPixelFormat() != wanted_format(sensor.getSensorType())) continue;
    if (mode.getResolutionX() > kWidestPicture || mode.getFps() < 1) continue;
    if (!found || is_better(mode, best)) best = mode;
    found = true;
  }
  return found;
}

template <class Pixel>
bool take_rows(const openni::VideoFrameRef& frame, const CameraIntrinsics& camera,
               Image<Pixel>& picture) {
  const std::ptrdiff_t stride = frame.getStrideInBytes();
  const auto row_bytes = static_cast<std::ptrdiff_t>(sizeof(Pixel)) * camera.width;
  const bool fits = frame.getWidth() == camera.width && frame.getHeight() == camera.height &&
                    stride >= row_bytes &&
                    frame.getDataSize() >= stride * (camera.height - 1) + row_bytes;
  if (!fits || frame.getData() == nullptr) return false;
  copy_rows(frame.getData(), stride, camera.width, camera.height, picture);
  return true;
}

}  // namespace

Status make_openni2_stream(openni::Device& device, openni::SensorType sensor,
                           openni::VideoStream& stream) {
  const char* const what = sensor == openni::SENSOR_DEPTH ? "depth" : "colour";
  const openni::SensorInfo* const info = device.getSensorInfo(sensor);
  openni::VideoMode mode;
  if (info == nullptr || !best_mode(*info, mode)) {
    return Error{ErrorCode::kUnsupported,
                 std::string("this device has no ") + what + " in a format that roomcast can read"};
  }
  if (stream.create(device, sensor) != openni::STATUS_OK) {
    return Error{ErrorCode::kUnavailable, std::string("the device sends no ") + what +
                                              " stream: " + openni::OpenNI::getExtendedError()};
  }
  if (!device.isFile()) {
    stream.setVideoMode(mode);
    if (stream.isPropertySupported(openni::STREAM_PROPERTY_MIRRORING))
      stream.setMirroringEnabled(false);
  }
  return {};
}

CameraIntrinsics openni2_camera(const openni::VideoStream& stream) {
  const openni::VideoMode mode = stream.getVideoMode();
  CameraIntrinsics camera;
  camera.width = mode.getResolutionX();
  camera.height = mode.getResolutionY();
  const auto half = [](float told, double nominal) {
    const double field = static_cast<double>(told);
    return std::tan(0.5 * (field > 0 && field < std::numbers::pi ? field : nominal));
  };
  camera.fx = 0.5 * camera.width / half(stream.getHorizontalFieldOfView(), kHorizontalField);
  camera.fy = 0.5 * camera.height / half(stream.getVerticalFieldOfView(), kVerticalField);
  camera.cx = 0.5 * (camera.width - 1);
  camera.cy = 0.5 * (camera.height - 1);
  return camera;
}

bool copy_openni2_depth(const openni::VideoFrameRef& frame, const CameraIntrinsics& camera,
                        DepthImage& depth_mm) {
  return take_rows(frame, camera, depth_mm);
}

bool copy_openni2_color(const openni::VideoFrameRef& frame, const CameraIntrinsics& camera,
                        ColorImage& color) {
  return take_rows(frame, camera, color);
}

}  // namespace roomcast::source
