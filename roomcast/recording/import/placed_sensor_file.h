// SPDX-License-Identifier: Apache-2.0
// PlacedSensorFile: a recording's sensor whose pose comes from elsewhere. Single-threaded.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

class PlacedSensorFile final : public SensorFile {
 public:
  /// `notes` are added to the file's.
  PlacedSensorFile(std::unique_ptr<SensorFile> file, std::optional<RigidTransform> world_from_depth,
                   const std::vector<std::string>& notes)
      : file_(std::move(file)), info_(file_->info()) {
    if (world_from_depth) info_.description.world_from_depth = *world_from_depth;
    info_.notes.insert(info_.notes.end(), notes.begin(), notes.end());
  }

  [[nodiscard]] const SensorFileInfo& info() const override { return info_; }
  [[nodiscard]] Status read_depth(std::size_t frame, DepthImage& depth_mm) override {
    return file_->read_depth(frame, depth_mm);
  }
  [[nodiscard]] Status read_color(std::size_t frame, ColorImage& color) override {
    return file_->read_color(frame, color);
  }
  [[nodiscard]] Status read_jpeg(std::size_t frame, std::vector<std::uint8_t>& jpeg) override {
    return file_->read_jpeg(frame, jpeg);
  }

 private:
  std::unique_ptr<SensorFile> file_;
  SensorFileInfo info_;
};

}  // namespace roomcast::recording
