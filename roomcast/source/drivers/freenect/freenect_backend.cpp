// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/freenect/freenect_backend.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>

#include <libfreenect.h>

#include "roomcast/source/camera/device_clock.h"
#include "roomcast/source/drivers/freenect/kinect_depth.h"
#include "roomcast/source/drivers/freenect/kinect_memory.h"

// The library that replays recordings in place of libfreenect lacks these functions.
#pragma weak freenect_list_device_attributes
#pragma weak freenect_free_device_attributes
#pragma weak freenect_set_flag

namespace roomcast::source {
namespace {

constexpr double kTicksPerSecond = 60e6;
constexpr double kFps = 30;

struct CloseContext {
  void operator()(freenect_context* context) const { freenect_shutdown(context); }
};
using Context = std::unique_ptr<freenect_context, CloseContext>;

struct CloseDevice {
  void operator()(freenect_device* device) const { freenect_close_device(device); }
};
using Device = std::unique_ptr<freenect_device, CloseDevice>;

Result<Context> start_library() {
  freenect_context* context = nullptr;
  if (freenect_init(&context, nullptr) < 0)
    return Error{ErrorCode::kUnavailable, "libfreenect does not start: this machine has no USB"};
  freenect_set_log_level(context, FREENECT_LOG_FATAL);
  freenect_select_subdevices(context, FREENECT_DEVICE_CAMERA);
  return Context(context);
}

/// One for each Kinect, empty if it has none.
std::vector<std::string> serial_numbers(freenect_context* context) {
  std::vector<std::string> serials;
  if (freenect_list_device_attributes != nullptr) {
    freenect_device_attributes* first = nullptr;
    if (freenect_list_device_attributes(context, &first) < 0) return serials;
    for (const auto* device = first; device != nullptr; device = device->next)
      serials.emplace_back(device->camera_serial == nullptr ? "" : device->camera_serial);
    freenect_free_device_attributes(first);
  } else {
    serials.resize(static_cast<std::size_t>(std::max(0, freenect_num_devices(context))));
  }
  return serials;
}

class Kinect final : public Camera {
 public:
  Kinect(Context context, Device device, const std::string& serial)
      : context_(std::move(context)), device_(std::move(device)) {
    const KinectMemory memory =
        read_kinect_memory(device_.get()).value_or(KinectMemory{{}, typical_kinect({})});
    mm_from_raw_ = kinect_mm_from_raw(memory.plane);
    description_ = {serial, memory.cameras, true, kFps};
  }
  ~Kinect() override {
    freenect_stop_depth(device_.get());
    freenect_stop_video(device_.get());
  }

  [[nodiscard]] Status start() {
    freenect_device* const device = device_.get();
    freenect_set_user(device, this);
    freenect_set_depth_callback(device, [](freenect_device* from, void* raw, std::uint32_t ticks) {
      static_cast<Kinect*>(freenect_get_user(from))->take_depth(raw, ticks);
    });
    freenect_set_video_callback(device, [](freenect_device* from, void* rgb, std::uint32_t ticks) {
      static_cast<Kinect*>(freenect_get_user(from))->take_color(rgb, ticks);
    });
    const auto depth = freenect_find_depth_mode(FREENECT_RESOLUTION_MEDIUM, FREENECT_DEPTH_11BIT);
    const auto color = freenect_find_video_mode(FREENECT_RESOLUTION_MEDIUM, FREENECT_VIDEO_RGB);
    const bool started = freenect_set_depth_mode(device, depth) == 0 &&
                         freenect_set_video_mode(device, color) == 0 &&
                         freenect_start_depth(device) == 0 && freenect_start_video(device) == 0;
    if (started) return {};
    return Error{ErrorCode::kUnavailable,
                 "the Kinect does not start: plug it into another USB controller"};
  }

  [[nodiscard]] const CameraDescription& description() const override { return description_; }

  [[nodiscard]] Status wait(FramePairing& pictures, std::chrono::milliseconds patience) override {
    pictures_ = &pictures;
    timeval longest{.tv_sec = 0, .tv_usec = std::chrono::microseconds(patience).count()};
    if (freenect_process_events_timeout(context_.get(), &longest) < 0)
      return Error{ErrorCode::kUnavailable, "the Kinect does not answer any more"};
    return {};
  }

  [[nodiscard]] Status lock_color(bool exposure, bool white_balance) override {
    const auto keep = [&](freenect_flag what) {
      return freenect_set_flag(device_.get(), what, FREENECT_OFF) == 0;
    };
    if ((!exposure || keep(FREENECT_AUTO_EXPOSURE)) &&
        (!white_balance || keep(FREENECT_AUTO_WHITE_BALANCE))) {
      return {};
    }
    return Error{ErrorCode::kUnsupported, "this Kinect cannot lock its colours"};
  }

 private:
  void take_depth(const void* raw, std::uint32_t ticks) {
    kinect_depth_from_raw(static_cast<const std::uint16_t*>(raw), mm_from_raw_, depth_mm_);
    pictures_->depth(counter_.time(ticks), depth_mm_);
  }
  void take_color(const void* rgb, std::uint32_t ticks) {
    if (color_.width() != kKinectWidth) color_.resize(kKinectWidth, kKinectHeight);
    std::memcpy(color_.data(), rgb, sizeof(Rgb8) * color_.view().pixel_count());
    pictures_->color(counter_.time(ticks), color_);
  }

  Context context_;
  Device device_;
  CameraDescription description_;
  std::vector<std::uint16_t> mm_from_raw_;
  TickCounter counter_{32, kTicksPerSecond};
  FramePairing* pictures_ = nullptr;  // set while the library may call back
  DepthImage depth_mm_;               // reused
  ColorImage color_;
};

class FreenectBackend final : public CameraBackend {
 public:
  [[nodiscard]] std::string kind() const override { return "freenect"; }
  [[nodiscard]] std::string library() const override { return "libfreenect"; }
  [[nodiscard]] CameraAbilities abilities() const override {
    const bool has_flags = freenect_set_flag != nullptr;
    return {.lock_exposure = has_flags, .lock_white_balance = has_flags};
  }

  [[nodiscard]] Result<std::vector<CameraInfo>> list() override {
    auto context = start_library();
    if (!context) return context.error();
    std::vector<CameraInfo> cameras;
    for (const std::string& serial : serial_numbers(context->get())) {
      const std::string place = serial.empty() ? std::to_string(cameras.size()) : serial;
      cameras.push_back({place, "Kinect v1", serial});
    }
    return cameras;
  }

  [[nodiscard]] Result<std::unique_ptr<Camera>> open(const CameraInfo& camera,
                                                     const CameraSettings&) override {
    auto context = start_library();
    if (!context) return context.error();
    freenect_device* device = nullptr;
    const int failed =
        camera.serial.empty()
            ? freenect_open_device(context->get(), &device, std::atoi(camera.place.c_str()))
            : freenect_open_device_by_camera_serial(context->get(), &device, camera.serial.c_str());
    if (failed != 0 || device == nullptr)
      return Error{ErrorCode::kUnavailable, "the Kinect is busy: another program has opened it"};
    auto kinect = std::make_unique<Kinect>(*std::move(context), Device(device), camera.serial);
    if (Status status = kinect->start(); !status) return status.error();
    return std::unique_ptr<Camera>(std::move(kinect));
  }
};

}  // namespace

std::unique_ptr<CameraBackend> freenect_backend() {
  return std::make_unique<FreenectBackend>();
}

}  // namespace roomcast::source
