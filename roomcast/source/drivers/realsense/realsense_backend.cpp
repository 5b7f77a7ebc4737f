// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/realsense/realsense_backend.h"

#include <atomic>
#include <cmath>
#include <filesystem>

#include <librealsense2/rs.hpp>

#include "roomcast/source/camera/copy_rows.h"
#include "roomcast/source/drivers/realsense/realsense_calibration.h"

namespace roomcast::source {
namespace {

constexpr int kWidth = 640, kHeight = 480, kFps = 30;

/// librealsense throws exceptions; none leaves this file.
Error error_of(const rs2::error& error) {
  return {ErrorCode::kUnavailable, std::string("librealsense: ") + error.what()};
}

template <class Pixel>
bool take_rows(const rs2::video_frame& frame, Image<Pixel>& picture) {
  const int row_bytes = static_cast<int>(sizeof(Pixel)) * frame.get_width();
  if (frame.get_stride_in_bytes() < row_bytes) return false;
  copy_rows(frame.get_data(), frame.get_stride_in_bytes(), frame.get_width(), frame.get_height(),
            picture);
  return true;
}

void set_where_supported(const rs2::device& device, rs2_option option, float value) {
  for (const rs2::sensor& sensor : device.query_sensors()) {
    if (sensor.supports(option) && !sensor.is_option_read_only(option))
      sensor.set_option(option, value);
  }
}

class RealSense final : public Camera {
 public:
  RealSense(const CameraInfo& info, const CameraSettings& settings, bool is_file)
      : pipeline_(context_) {
    rs2::config config;
    if (is_file) {
      config.enable_device_from_file(info.place, settings.loop);
    } else {
      config.enable_device(info.place);
      config.enable_stream(RS2_STREAM_DEPTH, kWidth, kHeight, RS2_FORMAT_Z16, kFps);
      config.enable_stream(RS2_STREAM_COLOR, kWidth, kHeight, RS2_FORMAT_RGB8, kFps);
      synchronise(settings, config);
    }
    profile_ = pipeline_.start(config);
    describe(info);
    context_.set_devices_changed_callback([this](rs2::event_information& change) {
      if (change.was_removed(profile_.get_device())) is_lost_ = true;
    });
  }
  ~RealSense() override {
    try {
      context_.set_devices_changed_callback([](rs2::event_information&) {});
      pipeline_.stop();
    } catch (const rs2::error&) {  // already disconnected
    }
  }

  [[nodiscard]] const CameraDescription& description() const override { return description_; }

  [[nodiscard]] Status wait(FramePairing& pictures, std::chrono::milliseconds patience) override {
    if (is_lost_) return Error{ErrorCode::kUnavailable, "it was unplugged"};
    try {
      rs2::frameset frames;
      if (!pipeline_.try_wait_for_frames(&frames, static_cast<unsigned>(patience.count())))
        return {};
      const rs2::depth_frame depth = frames.get_depth_frame();
      const rs2::video_frame color = frames.get_color_frame();
      if (depth && take_depth(depth)) pictures.depth(time_of(depth), depth_mm_);
      if (color && color.get_profile().format() == RS2_FORMAT_RGB8 && take_rows(color, color_))
        pictures.color(time_of(color), color_);
      return {};
    } catch (const rs2::error& error) {
      return error_of(error);
    }
  }

  [[nodiscard]] Status lock_color(bool exposure, bool white_balance) override {
    try {
      const rs2::device device = profile_.get_device();
      if (exposure) set_where_supported(device, RS2_OPTION_ENABLE_AUTO_EXPOSURE, 0);
      if (white_balance) set_where_supported(device, RS2_OPTION_ENABLE_AUTO_WHITE_BALANCE, 0);
      return {};
    } catch (const rs2::error& error) {
      return error_of(error);
    }
  }

 private:
  /// Call before streaming. 0: alone, 1: triggers others, 2: is triggered.
  static void synchronise(const CameraSettings& settings, rs2::config& config) {
    if (settings.sync == SyncRole::kAlone) return;
    const rs2::device device = config.resolve(rs2::pipeline()).get_device();
    const float mode = settings.sync == SyncRole::kPrimary ? 1.0F : 2.0F;
    set_where_supported(device, RS2_OPTION_INTER_CAM_SYNC_MODE, mode);
  }

  void describe(const CameraInfo& info) {
    const auto depth = profile_.get_stream(RS2_STREAM_DEPTH).as<rs2::video_stream_profile>();
    const auto color = profile_.get_stream(RS2_STREAM_COLOR).as<rs2::video_stream_profile>();
    description_.serial = info.serial;
    description_.fps = depth.fps();
    description_.calibration = realsense_calibration(depth.get_intrinsics(), color.get_intrinsics(),
                                                     depth.get_extrinsics_to(color));
    const auto sensor = profile_.get_device().first<rs2::depth_sensor>();
    mm_per_unit_ = 1000.0 * double(sensor.get_depth_scale());
  }

  bool take_depth(const rs2::depth_frame& frame) {
    if (!take_rows(frame, depth_mm_)) return false;
    if (mm_per_unit_ == 1) return true;
    std::uint16_t* const values = depth_mm_.data();
    for (std::size_t i = 0; i < depth_mm_.view().pixel_count(); ++i) {
      const double mm = mm_per_unit_ * values[i];
      values[i] = mm < 65535 ? static_cast<std::uint16_t>(std::lround(mm)) : std::uint16_t{0};
    }
    return true;
  }

  static nanoseconds time_of(const rs2::frame& frame) {
    return nanoseconds(std::llround(frame.get_timestamp() * 1e6));
  }

  rs2::context context_;
  rs2::pipeline pipeline_;
  rs2::pipeline_profile profile_;
  CameraDescription description_;
  double mm_per_unit_ = 1;
  std::atomic<bool> is_lost_{false};
  DepthImage depth_mm_;  // reused
  ColorImage color_;
};

class RealSenseBackend final : public CameraBackend {
 public:
  [[nodiscard]] std::string kind() const override { return "realsense"; }
  [[nodiscard]] std::string library() const override {
    return std::string("librealsense ") + RS2_API_VERSION_STR;
  }
  [[nodiscard]] CameraAbilities abilities() const override {
    return {.lock_exposure = true, .lock_white_balance = true, .sync = true};
  }
  [[nodiscard]] bool plays(const std::string& place) const override {
    return std::filesystem::path(place).extension() == ".bag";
  }

  [[nodiscard]] Result<std::vector<CameraInfo>> list() override {
    try {
      std::vector<CameraInfo> cameras;
      for (const rs2::device& device : rs2::context().query_devices()) {
        const std::string serial = device.get_info(RS2_CAMERA_INFO_SERIAL_NUMBER);
        cameras.push_back({serial, device.get_info(RS2_CAMERA_INFO_NAME), serial});
      }
      return cameras;
    } catch (const rs2::error& error) {
      return error_of(error);
    }
  }

  [[nodiscard]] Result<std::unique_ptr<Camera>> open(const CameraInfo& info,
                                                     const CameraSettings& settings) override {
    try {
      return std::unique_ptr<Camera>(
          std::make_unique<RealSense>(info, settings, plays(info.place)));
    } catch (const rs2::error& error) {
      return error_of(error);
    }
  }
};

}  // namespace

std::unique_ptr<CameraBackend> realsense_backend() {
  return std::make_unique<RealSenseBackend>();
}

}  // namespace roomcast::source
