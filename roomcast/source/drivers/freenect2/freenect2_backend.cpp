// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/freenect2/freenect2_backend.h"

#include <array>
#include <cmath>

#include <libfreenect2/frame_listener_impl.h>
#include <libfreenect2/libfreenect2.hpp>
#include <libfreenect2/logger.h>
#include <libfreenect2/registration.h>

#include "roomcast/source/camera/color_camera_fit.h"
#include "roomcast/source/camera/device_clock.h"

namespace roomcast::source {
namespace {

using libfreenect2::Frame;

constexpr int kDepthWidth = 512, kDepthHeight = 424, kColorWidth = 1920, kColorHeight = 1080;
constexpr double kFps = 30;
constexpr double kTicksPerSecond = 8000;  // 0.125 ms
constexpr double kColorFromDepth_m = -0.052;

CameraIntrinsics depth_camera(const libfreenect2::Freenect2Device::IrCameraParams& from) {
  return {kDepthWidth,     kDepthHeight,    double(from.fx), double(from.fy),
          double(from.cx), double(from.cy), double(from.k1), double(from.k2),
          double(from.k3), double(from.p1), double(from.p2)};
}

/// The library's mapping from depth readings to colour pixels, for pixels of an undistorted depth
/// picture.
std::vector<MappedPoint> mapped_points(libfreenect2::Freenect2Device& device) {
  constexpr int kStep = 16;
  constexpr std::array<float, 4> kDepths_mm = {700, 1500, 3000, 4500};
  const auto depth = device.getIrCameraParams();
  const libfreenect2::Registration registration(depth, device.getColorCameraParams());
  std::vector<MappedPoint> points;
  for (int y = kStep; y < kDepthHeight; y += kStep) {
    for (int x = kStep; x < kDepthWidth; x += kStep) {
      for (const float mm : kDepths_mm) {
        float u = -1, v = -1;
        registration.apply(x, y, mm, u, v);
        if (!(u >= 0 && v >= 0 && u < kColorWidth && v < kColorHeight)) continue;
        const double z_m = 0.001 * double(mm);
        points.push_back({{z_m * (x - double(depth.cx)) / double(depth.fx),
                           z_m * (y - double(depth.cy)) / double(depth.fy), z_m},
                          {double(u), double(v)}});
      }
    }
  }
  return points;
}

/// The colour camera fitted to the library's mapping; nominal if none fits.
SensorCalibration cameras_of(libfreenect2::Freenect2Device& device) {
  const auto color = device.getColorCameraParams();
  SensorCalibration start;
  start.depth = depth_camera(device.getIrCameraParams());
  start.color = {kColorWidth,      kColorHeight,     double(color.fx),
                 double(color.fy), double(color.cx), double(color.cy)};
  start.color_from_depth.translation_m.x() = kColorFromDepth_m;
  const auto fitted = fit_color_camera(start, mapped_points(device));
  return mirrored(fitted ? *fitted : start);
}

class KinectV2 final : public Camera {
 public:
  KinectV2(std::unique_ptr<libfreenect2::Freenect2> library, libfreenect2::Freenect2Device* device,
           const std::string& serial)
      : library_(std::move(library)), device_(device) {
    description_.serial = serial;
    description_.fps = kFps;
    device_->setColorFrameListener(&listener_);
    device_->setIrAndDepthFrameListener(&listener_);
  }
  ~KinectV2() override {
    device_->stop();
    device_->close();
  }

  [[nodiscard]] Status start() {
    if (!device_->start()) {
      return Error{ErrorCode::kUnavailable,
                   "the Kinect v2 does not start: it needs USB 3 and its own power supply"};
    }
    description_.calibration = cameras_of(*device_);  // known only while it runs
    return {};
  }

  [[nodiscard]] const CameraDescription& description() const override { return description_; }

  [[nodiscard]] Status wait(FramePairing& pictures, std::chrono::milliseconds patience) override {
    libfreenect2::FrameMap frames;
    if (!listener_.waitForNewFrame(frames, static_cast<int>(patience.count()))) return {};
    const Frame* const depth = frames[Frame::Depth];
    const Frame* const color = frames[Frame::Color];
    if (take_depth(*depth)) pictures.depth(counter_.time(depth->timestamp), depth_mm_);
    if (take_color(*color)) pictures.color(counter_.time(color->timestamp), color_);
    listener_.release(frames);
    return {};
  }

 private:
  bool take_depth(const Frame& frame) {
    if (frame.status != 0 || frame.width != kDepthWidth || frame.height != kDepthHeight)
      return false;
    depth_mm_.resize(kDepthWidth, kDepthHeight);
    const auto* const mm = reinterpret_cast<const float*>(frame.data);
    for (int y = 0; y < kDepthHeight; ++y) {
      for (int x = 0; x < kDepthWidth; ++x) {
        const float value = mm[y * kDepthWidth + x];
        if (value > 0 && value < 65535)
          depth_mm_.at(kDepthWidth - 1 - x, y) = static_cast<std::uint16_t>(std::lround(value));
      }
    }
    return true;
  }

  bool take_color(const Frame& frame) {
    if (frame.status != 0 || frame.width != kColorWidth || frame.height != kColorHeight)
      return false;
    if (color_.empty()) color_.resize(kColorWidth, kColorHeight);
    const int red = frame.format == Frame::RGBX ? 0 : 2;
    for (int y = 0; y < kColorHeight; ++y) {
      const unsigned char* from = frame.data + std::ptrdiff_t{4} * y * kColorWidth;
      for (Rgb8* to = color_.view().row(y) + kColorWidth; to != color_.view().row(y); from += 4)
        *--to = {from[red], from[1], from[2 - red]};
    }
    return true;
  }

  std::unique_ptr<libfreenect2::Freenect2> library_;
  libfreenect2::Freenect2Device* const device_;  // owned by the library
  libfreenect2::SyncMultiFrameListener listener_{Frame::Color | Frame::Depth};
  CameraDescription description_;
  TickCounter counter_{32, kTicksPerSecond};
  DepthImage depth_mm_;  // reused
  ColorImage color_;
};

class Freenect2Backend final : public CameraBackend {
 public:
  Freenect2Backend() { libfreenect2::setGlobalLogger(nullptr); }

  [[nodiscard]] std::string kind() const override { return "freenect2"; }
  [[nodiscard]] std::string library() const override { return "libfreenect2"; }
  [[nodiscard]] CameraAbilities abilities() const override { return {}; }

  [[nodiscard]] Result<std::vector<CameraInfo>> list() override {
    libfreenect2::Freenect2 library;
    std::vector<CameraInfo> cameras;
    const int count = library.enumerateDevices();
    for (int i = 0; i < count; ++i) {
      const std::string serial = library.getDeviceSerialNumber(i);
      cameras.push_back({serial, "Kinect v2", serial});
    }
    return cameras;
  }

  [[nodiscard]] Result<std::unique_ptr<Camera>> open(const CameraInfo& info,
                                                     const CameraSettings&) override {
    auto library = std::make_unique<libfreenect2::Freenect2>();
    libfreenect2::Freenect2Device* const device = library->openDevice(info.place);
    if (device == nullptr)
      return Error{ErrorCode::kUnavailable, "the Kinect v2 is busy: another program has opened it"};
    auto kinect = std::make_unique<KinectV2>(std::move(library), device, info.serial);
    if (Status status = kinect->start(); !status) return status.error();
    return std::unique_ptr<Camera>(std::move(kinect));
  }
};

}  // namespace

std::unique_ptr<CameraBackend> freenect2_backend() {
  return std::make_unique<Freenect2Backend>();
}

}  // namespace roomcast::source
