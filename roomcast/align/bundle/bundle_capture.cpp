// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/bundle/bundle_capture.h"

#include <utility>

#include "roomcast/align/bundle/steady_color.h"
#include "roomcast/align/bundle/steady_depth.h"

namespace roomcast::align {
namespace {

/// Whether the colour of this depth picture is one of the few that are kept.
bool takes_color(std::size_t frame) {
  const std::size_t before = frame * kBundleColorFrames / kBundleFrames;
  const std::size_t after = (frame + 1) * kBundleColorFrames / kBundleFrames;
  return frame == 0 || (after != before && after < kBundleColorFrames);
}

}  // namespace

BundleCapture::BundleCapture(std::string name, const SensorCalibration& calibration)
    : name_(std::move(name)), calibration_(calibration) {}

Result<bool> BundleCapture::add(const DepthImage& depth_mm, const ColorImage& color) {
  if (depth_mm_.size() == kBundleFrames) return true;
  if (!same_size(depth_mm.view(), calibration_.depth) ||
      (!color.empty() && !same_size(color.view(), calibration_.color))) {
    return Error{ErrorCode::kInvalidArgument,
                 "sensor " + name_ + " gave a picture of another size than its camera's"};
  }
  if (!color.empty() && (colors_.empty() || takes_color(depth_mm_.size())))
    colors_.push_back(color);
  depth_mm_.push_back(depth_mm);
  return depth_mm_.size() == kBundleFrames;
}

Result<CalibrationBundle> BundleCapture::finish() const {
  if (depth_mm_.empty()) {
    return Error{ErrorCode::kUnavailable, "sensor " + name_ + " has not given a frame yet"};
  }
  CalibrationBundle bundle;
  bundle.name = name_;
  bundle.calibration = calibration_;
  SteadyDepth steady = steady_depth(depth_mm_);
  bundle.depth_mm = std::move(steady.depth_mm);
  bundle.moving = std::move(steady.moving);
  if (!colors_.empty()) bundle.color = steady_color(colors_);
  if (const Status status = check(bundle); !status) return status.error();
  return bundle;
}

}  // namespace roomcast::align
