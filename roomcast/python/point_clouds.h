// SPDX-License-Identifier: Apache-2.0
// CloudMaker: point clouds of a room's frame sets, the same as `roomcast export` writes. Threading:
// thread-safe; clouds are made one after the other.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/export/merged_cloud.h"

namespace roomcast::python {

class CloudMaker {
 public:
  explicit CloudMaker(std::vector<recording::SetSensor> sensors) : sensors_(std::move(sensors)) {}

  /// Errors of MergedCloudOptions::check.
  [[nodiscard]] Result<std::shared_ptr<const recording::PointCloud>> make(
      const recording::FrameSet& set, const recording::MergedCloudOptions& options);

 private:
  const std::vector<recording::SetSensor> sensors_;
  std::mutex mutex_;
  recording::MergedCloudOptions options_;         // of merged_
  std::optional<recording::MergedCloud> merged_;  // has tables of the sensors' pixels
};

}  // namespace roomcast::python
