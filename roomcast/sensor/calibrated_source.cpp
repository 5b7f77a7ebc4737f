// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/calibrated_source.h"

#include <string>
#include <utility>

#include "roomcast/io/camera_json.h"
#include "roomcast/io/depth_values.h"

namespace roomcast::sensor {
namespace {

class CalibratedSource final : public source::FrameSource {
 public:
  CalibratedSource(std::unique_ptr<source::FrameSource> source, const io::RecordedCamera& camera)
      : source_(std::move(source)), description_(source_->description()), depth_values_(camera) {
    description_.calibration = camera.calibration;
  }

  [[nodiscard]] const source::SensorDescription& description() const override {
    return description_;
  }
  [[nodiscard]] source::SourceHealth health() const override { return source_->health(); }
  void set_idle(bool is_idle) override { source_->set_idle(is_idle); }
  [[nodiscard]] Result<bool> next(source::CapturedFrame& frame, std::stop_token stop) override {
    auto more = source_->next(frame, std::move(stop));
    if (more && *more) depth_values_.to_mm(frame.depth_mm);
    return more;
  }

 private:
  std::unique_ptr<source::FrameSource> source_;
  source::SensorDescription description_;
  io::DepthValues depth_values_;
};

std::string size_text(const CameraIntrinsics& camera) {
  return std::to_string(camera.width) + "x" + std::to_string(camera.height);
}

}  // namespace

Result<std::unique_ptr<source::FrameSource>> with_calibration(
    std::unique_ptr<source::FrameSource> source, const std::filesystem::path& camera_json) {
  auto camera = io::read_camera_json(camera_json);
  if (!camera) return camera.error();
  const SensorCalibration& own = source->description().calibration;
  const auto differs = [&](const char* what, const CameraIntrinsics& a, const CameraIntrinsics& b) {
    return Error{ErrorCode::kInvalidArgument, camera_json.string() + " is for " + what + " of " +
                                                  size_text(a) + " pixels, but this source gives " +
                                                  size_text(b)};
  };
  if (!same_size(camera->calibration.depth, own.depth))
    return differs("depth", camera->calibration.depth, own.depth);
  if (!same_size(camera->calibration.color, own.color))
    return differs("colour", camera->calibration.color, own.color);
  return std::unique_ptr<source::FrameSource>(
      std::make_unique<CalibratedSource>(std::move(source), *camera));
}

}  // namespace roomcast::sensor
