// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/k4a/k4a_backend.h"

#include <k4a/k4a.h>

#include "roomcast/source/camera/copy_rows.h"
#include "roomcast/source/drivers/k4a/k4a_calibration.h"

namespace roomcast::source {
namespace {

constexpr double kFps = 30;

struct Close {
  void operator()(k4a_device_t device) const { k4a_device_close(device); }
};
using Device = std::unique_ptr<std::remove_pointer_t<k4a_device_t>, Close>;

struct ReleaseCapture {
  void operator()(k4a_capture_t capture) const { k4a_capture_release(capture); }
};
using Capture = std::unique_ptr<std::remove_pointer_t<k4a_capture_t>, ReleaseCapture>;

struct ReleaseImage {
  void operator()(k4a_image_t image) const { k4a_image_release(image); }
};
using Picture = std::unique_ptr<std::remove_pointer_t<k4a_image_t>, ReleaseImage>;

Device open_at(std::uint32_t index) {
  k4a_device_t device = nullptr;
  if (k4a_device_open(index, &device) != K4A_RESULT_SUCCEEDED) return nullptr;
  return Device(device);
}

std::string serial_of(k4a_device_t device) {
  std::size_t size = 0;
  if (k4a_device_get_serialnum(device, nullptr, &size) != K4A_BUFFER_RESULT_TOO_SMALL) return "";
  std::string serial(size, '\0');
  if (k4a_device_get_serialnum(device, serial.data(), &size) != K4A_BUFFER_RESULT_SUCCEEDED)
    return "";
  return serial.c_str();
}

k4a_device_configuration_t configuration_of(const CameraSettings& settings) {
  k4a_device_configuration_t configuration = K4A_DEVICE_CONFIG_INIT_DISABLE_ALL;
  configuration.color_format = K4A_IMAGE_FORMAT_COLOR_BGRA32;
  configuration.color_resolution = K4A_COLOR_RESOLUTION_720P;
  configuration.depth_mode = K4A_DEPTH_MODE_NFOV_UNBINNED;
  configuration.camera_fps = K4A_FRAMES_PER_SECOND_30;
  configuration.synchronized_images_only = true;
  if (settings.sync == SyncRole::kPrimary)
    configuration.wired_sync_mode = K4A_WIRED_SYNC_MODE_MASTER;
  if (settings.sync == SyncRole::kSecondary) {
    configuration.wired_sync_mode = K4A_WIRED_SYNC_MODE_SUBORDINATE;
    configuration.subordinate_delay_off_master_usec =
        static_cast<std::uint32_t>(settings.trigger_delay.count());
  }
  return configuration;
}

bool has_size(k4a_image_t image, const CameraIntrinsics& camera, int bytes_per_pixel) {
  return image != nullptr && k4a_image_get_width_pixels(image) == camera.width &&
         k4a_image_get_height_pixels(image) == camera.height &&
         k4a_image_get_stride_bytes(image) >= bytes_per_pixel * camera.width;
}

nanoseconds time_of(k4a_image_t image) {
  return std::chrono::microseconds(k4a_image_get_device_timestamp_usec(image));
}

class AzureKinect final : public Camera {
 public:
  AzureKinect(Device device, const CameraInfo& info) : device_(std::move(device)) {
    description_.serial = info.serial;
    description_.fps = kFps;
  }
  ~AzureKinect() override { k4a_device_stop_cameras(device_.get()); }

  [[nodiscard]] Status start(const CameraSettings& settings) {
    k4a_device_configuration_t configuration = configuration_of(settings);
    k4a_calibration_t calibration;
    const bool started =
        k4a_device_get_calibration(device_.get(), configuration.depth_mode,
                                   configuration.color_resolution,
                                   &calibration) == K4A_RESULT_SUCCEEDED &&
        k4a_device_start_cameras(device_.get(), &configuration) == K4A_RESULT_SUCCEEDED;
    if (!started) {
      return Error{ErrorCode::kUnavailable,
                   "the camera does not start: it needs a USB 3 controller of its own and its "
                   "maker's depth engine"};
    }
    description_.calibration = k4a_calibration(calibration);
    return {};
  }

  [[nodiscard]] const CameraDescription& description() const override { return description_; }

  [[nodiscard]] Status wait(FramePairing& pictures, std::chrono::milliseconds patience) override {
    k4a_capture_t taken = nullptr;
    const auto result =
        k4a_device_get_capture(device_.get(), &taken, static_cast<std::int32_t>(patience.count()));
    if (result == K4A_WAIT_RESULT_TIMEOUT) return {};
    if (result != K4A_WAIT_RESULT_SUCCEEDED)
      return Error{ErrorCode::kUnavailable, "the camera does not answer any more"};
    const Capture capture(taken);
    const Picture depth(k4a_capture_get_depth_image(taken));
    const Picture color(k4a_capture_get_color_image(taken));
    if (take_depth(depth.get())) pictures.depth(time_of(depth.get()), depth_mm_);
    if (take_color(color.get())) pictures.color(time_of(color.get()), color_);
    return {};
  }

  /// Manual values stay fixed, so the automatic values are set as manual ones.
  [[nodiscard]] Status lock_color(bool exposure, bool white_balance) override {
    const auto keep = [&](k4a_color_control_command_t what) {
      k4a_color_control_mode_t mode = K4A_COLOR_CONTROL_MODE_AUTO;
      std::int32_t value = 0;
      return k4a_device_get_color_control(device_.get(), what, &mode, &value) ==
                 K4A_RESULT_SUCCEEDED &&
             k4a_device_set_color_control(device_.get(), what, K4A_COLOR_CONTROL_MODE_MANUAL,
                                          value) == K4A_RESULT_SUCCEEDED;
    };
    if ((!exposure || keep(K4A_COLOR_CONTROL_EXPOSURE_TIME_ABSOLUTE)) &&
        (!white_balance || keep(K4A_COLOR_CONTROL_WHITEBALANCE))) {
      return {};
    }
    return Error{ErrorCode::kUnsupported, "this camera cannot lock its colours"};
  }

 private:
  bool take_depth(k4a_image_t image) {
    const CameraIntrinsics& camera = description_.calibration.depth;
    if (!has_size(image, camera, 2)) return false;
    copy_rows(k4a_image_get_buffer(image), k4a_image_get_stride_bytes(image), camera.width,
              camera.height, depth_mm_);
    return true;
  }

  bool take_color(k4a_image_t image) {
    const CameraIntrinsics& camera = description_.calibration.color;
    if (!has_size(image, camera, 4)) return false;
    if (color_.empty()) color_.resize(camera.width, camera.height);
    const std::ptrdiff_t stride = k4a_image_get_stride_bytes(image);
    for (int y = 0; y < camera.height; ++y) {
      const std::uint8_t* from = k4a_image_get_buffer(image) + stride * y;
      Rgb8* const to = color_.view().row(y);
      for (int x = 0; x < camera.width; ++x, from += 4) to[x] = {from[2], from[1], from[0]};
    }
    return true;
  }

  const Device device_;
  CameraDescription description_;
  DepthImage depth_mm_;  // reused
  ColorImage color_;
};

class K4aBackend final : public CameraBackend {
 public:
  [[nodiscard]] std::string kind() const override { return "k4a"; }
  [[nodiscard]] std::string library() const override { return "libk4a"; }
  [[nodiscard]] CameraAbilities abilities() const override {
    return {.lock_exposure = true, .lock_white_balance = true, .sync = true, .trigger_delay = true};
  }

  /// Opens each device: only an open device gives its serial number.
  [[nodiscard]] Result<std::vector<CameraInfo>> list() override {
    std::vector<CameraInfo> cameras;
    for (std::uint32_t i = 0; i < k4a_device_get_installed_count(); ++i) {
      CameraInfo camera{std::to_string(i), "Azure Kinect", ""};
      if (const Device device = open_at(i)) {
        camera.serial = serial_of(device.get());
      } else {
        camera.obstacle = Error{ErrorCode::kUnavailable, "another program may have opened it"};
      }
      cameras.push_back(std::move(camera));
    }
    return cameras;
  }

  [[nodiscard]] Result<std::unique_ptr<Camera>> open(const CameraInfo& info,
                                                     const CameraSettings& settings) override {
    Device device = open_at(static_cast<std::uint32_t>(std::stoul(info.place)));
    if (!device)
      return Error{ErrorCode::kUnavailable, "the camera is busy: another program has opened it"};
    auto camera = std::make_unique<AzureKinect>(std::move(device), info);
    if (Status status = camera->start(settings); !status) return status.error();
    return std::unique_ptr<Camera>(std::move(camera));
  }
};

}  // namespace

std::unique_ptr<CameraBackend> k4a_backend() {
  return std::make_unique<K4aBackend>();
}

}  // namespace roomcast::source
