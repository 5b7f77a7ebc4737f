// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/openni2/openni2_backend.h"

#include <filesystem>

#include "roomcast/source/drivers/openni2/oni_file_camera.h"
#include "roomcast/source/drivers/openni2/openni2_device.h"

namespace roomcast::source {
namespace {

class OpenNi2Camera final : public Camera {
 public:
  ~OpenNi2Camera() override {
    on_openni2_thread([this] { device_.reset(); });
  }

  [[nodiscard]] Status open(const CameraInfo& info) {
    Status status;
    on_openni2_thread([&] {
      const OpenNi2Session session;
      status = session.status();
      if (!status) return;
      device_ = std::make_unique<OpenNi2Device>(info);
      status = device_->start(info.place, false);
    });
    return status;
  }

  [[nodiscard]] const CameraDescription& description() const override {
    return device_->description();
  }

  [[nodiscard]] Status wait(FramePairing& pictures, std::chrono::milliseconds patience) override {
    if (device_->is_gone()) return Error{ErrorCode::kUnavailable, "it was unplugged"};
    const auto is_depth = device_->bell().wait(patience);
    if (is_depth) on_openni2_thread([&] { device_->take(*is_depth, pictures); });
    return {};
  }

  [[nodiscard]] Status lock_color(bool exposure, bool white_balance) override {
    Status status;
    on_openni2_thread([&] { status = device_->lock_color(exposure, white_balance); });
    return status;
  }

 private:
  std::unique_ptr<OpenNi2Device> device_;
};

/// Opens each briefly: only an open device gives its serial number.
Result<std::vector<CameraInfo>> list_cameras() {
  const OpenNi2Session session;
  if (Status status = session.status(); !status) return status.error();
  openni::Array<openni::DeviceInfo> devices;
  openni::OpenNI::enumerateDevices(&devices);
  std::vector<CameraInfo> cameras;
  for (int i = 0; i < devices.getSize(); ++i) {
    CameraInfo camera{devices[i].getUri(),
                      std::string(devices[i].getVendor()) + " " + devices[i].getName(), ""};
    openni::Device device;
    if (device.open(devices[i].getUri()) == openni::STATUS_OK) {
      camera.serial = openni2_serial(device);
      device.close();
    } else {
      camera.obstacle = Error{ErrorCode::kUnavailable, openni::OpenNI::getExtendedError()};
    }
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

class OpenNi2Backend final : public CameraBackend {
 public:
  [[nodiscard]] std::string kind() const override { return "openni2"; }
  [[nodiscard]] std::string library() const override {
    const openni::Version v = openni::OpenNI::getVersion();
    return "OpenNI " + std::to_string(v.major) + "." + std::to_string(v.minor) + "." +
           std::to_string(v.maintenance);
  }
  [[nodiscard]] CameraAbilities abilities() const override {
    return {.lock_exposure = true, .lock_white_balance = true};
  }
  [[nodiscard]] bool plays(const std::string& place) const override {
    return std::filesystem::path(place).extension() == ".oni";
  }

  [[nodiscard]] Result<std::vector<CameraInfo>> list() override {
    Result<std::vector<CameraInfo>> cameras(std::vector<CameraInfo>{});
    on_openni2_thread([&] { cameras = list_cameras(); });
    return cameras;
  }

  [[nodiscard]] Result<std::unique_ptr<Camera>> open(const CameraInfo& info,
                                                     const CameraSettings& settings) override {
    std::error_code error;
    if (plays(info.place)) {
      if (!std::filesystem::is_regular_file(info.place, error))
        return Error{ErrorCode::kNotFound, "there is no file " + info.place};
      return open_oni_file(info.place, settings.loop);
    }
    auto camera = std::make_unique<OpenNi2Camera>();
    if (Status status = camera->open(info); !status) return status.error();
    return std::unique_ptr<Camera>(std::move(camera));
  }
};

}  // namespace

std::unique_ptr<CameraBackend> openni2_backend() {
  return std::make_unique<OpenNi2Backend>();
}

}  // namespace roomcast::source
