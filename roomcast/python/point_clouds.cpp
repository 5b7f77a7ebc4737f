// SPDX-License-Identifier: Apache-2.0
#include "roomcast/python/point_clouds.h"

namespace roomcast::python {
namespace {

bool same(const recording::MergedCloudOptions& a, const recording::MergedCloudOptions& b) {
  const bool same_crop =
      a.crop_m.has_value() == b.crop_m.has_value() &&
      (!a.crop_m || (a.crop_m->min() == b.crop_m->min() && a.crop_m->max() == b.crop_m->max()));
  return same_crop && a.voxel_m == b.voxel_m && a.keep_doubles == b.keep_doubles;
}

}  // namespace

Result<std::shared_ptr<const recording::PointCloud>> CloudMaker::make(
    const recording::FrameSet& set, const recording::MergedCloudOptions& options) {
  if (auto status = options.check(); !status) return status.error();
  auto cloud = std::make_shared<recording::PointCloud>();
  const std::lock_guard lock(mutex_);
  if (!merged_ || !same(options_, options)) {
    options_ = options;
    merged_.emplace(sensors_, options);
  }
  merged_->merge(set, *cloud);
  return std::shared_ptr<const recording::PointCloud>(std::move(cloud));
}

}  // namespace roomcast::python
