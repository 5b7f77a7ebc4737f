// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/openni2/openni2_device.h"

#include <array>
#include <thread>

#include "roomcast/source/drivers/openni2/openni2_streams.h"

namespace roomcast::source {
namespace {

constexpr double kColorFromDepth_m = -0.025;                      // PrimeSense's reference design
constexpr auto kPlayerStopDelay = std::chrono::milliseconds(50);  // it sleeps for 10 ms at a time

}  // namespace

OpenNi2Device::OpenNi2Device(const CameraInfo& info) : departure_(info.place) {
  description_.serial = info.serial;
}

/// OpenNI's playback thread iterates over the streams without a lock, and without a pause at the
/// file's end, while any of them is started; it crashes if one is destroyed meanwhile (seen with
/// Debian's 2.2.0.33). Once all are stopped it sleeps.
OpenNi2Device::~OpenNi2Device() {
  bell_.silence();
  const std::array streams{&depth_, &color_};
  for (openni::VideoStream* stream : streams) {
    if (stream->isValid()) stream->stop();
  }
  if (device_.isValid() && device_.isFile()) std::this_thread::sleep_for(kPlayerStopDelay);
  for (openni::VideoStream* stream : streams) {
    if (stream->isValid()) stream->destroy();
  }
  device_.close();
}

Status OpenNi2Device::start(const std::string& uri, bool loop) {
  if (device_.open(uri.c_str()) != openni::STATUS_OK) {
    return Error{ErrorCode::kUnavailable,
                 "OpenNI cannot open " + uri + ": " + openni::OpenNI::getExtendedError()};
  }
  plays_once_ = device_.isFile() && !loop;
  if (device_.isFile()) device_.getPlaybackControl()->setRepeatEnabled(loop);
  if (Status status = make_openni2_stream(device_, openni::SENSOR_DEPTH, depth_); !status)
    return status;
  description_.has_color = device_.hasSensor(openni::SENSOR_COLOR);
  if (description_.has_color) {
    Status status = make_openni2_stream(device_, openni::SENSOR_COLOR, color_);
    if (!status) return status;
  }
  calibrate();
  bell_.listen(depth_, description_.has_color ? &color_ : nullptr);
  if (depth_.start() == openni::STATUS_OK &&
      (!description_.has_color || color_.start() == openni::STATUS_OK))
    return {};
  return Error{ErrorCode::kUnavailable,
               std::string("the device does not start: ") + openni::OpenNI::getExtendedError()};
}

/// Prefers depth registered to colour by the device to nominal lenses.
void OpenNi2Device::calibrate() {
  constexpr auto kOver = openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR;
  if (!device_.isFile() && device_.isImageRegistrationModeSupported(kOver))
    device_.setImageRegistrationMode(kOver);
  SensorCalibration& calibration = description_.calibration;
  calibration.depth = calibration.color = openni2_camera(depth_);
  calibration.color_is_registered = true;
  description_.fps = depth_.getVideoMode().getFps();
  if (!description_.has_color) return;
  device_.setDepthColorSyncEnabled(true);
  const CameraIntrinsics color = openni2_camera(color_);
  const bool same_grid =
      color.width == calibration.depth.width && color.height == calibration.depth.height;
  calibration.color_is_registered =
      same_grid && (device_.getImageRegistrationMode() == kOver || !reports_registration());
  calibration.color = color;
  if (calibration.color_is_registered) {
    calibration.depth = color;
  } else {
    calibration.color_from_depth.translation_m.x() = kColorFromDepth_m;
  }
}

/// Most files do not state it; most were recorded with depth registered to colour.
bool OpenNi2Device::reports_registration() const {
  return !device_.isFile() || device_.isPropertySupported(ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION);
}

void OpenNi2Device::take(bool is_depth, FramePairing& pictures) {
  openni::VideoStream& stream = is_depth ? depth_ : color_;
  openni::VideoStream* streams[] = {&stream};
  openni::VideoFrameRef frame;
  int ready = -1;
  constexpr int kNow = 0;  // reading would block forever for a disconnected device
  if (openni::OpenNI::waitForAnyStream(streams, 1, &ready, kNow) != openni::STATUS_OK ||
      stream.readFrame(&frame) != openni::STATUS_OK)
    return;
  const nanoseconds time = std::chrono::microseconds(frame.getTimestamp());
  const SensorCalibration& calibration = description_.calibration;
  if (is_depth && copy_openni2_depth(frame, calibration.depth, depth_mm_))
    pictures.depth(time, depth_mm_);
  if (!is_depth && copy_openni2_color(frame, calibration.color, color_picture_))
    pictures.color(time, color_picture_);
}

Status OpenNi2Device::lock_color(bool exposure, bool white_balance) {
  openni::CameraSettings* const settings = color_.getCameraSettings();
  const bool locked =
      settings != nullptr && settings->isValid() &&
      (!exposure || settings->setAutoExposureEnabled(false) == openni::STATUS_OK) &&
      (!white_balance || settings->setAutoWhiteBalanceEnabled(false) == openni::STATUS_OK);
  if (locked) return {};
  return Error{ErrorCode::kUnsupported, "this device cannot lock its colours"};
}

}  // namespace roomcast::source
