// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/bundle/bundle_capture.h"

#include <utility>

#include "roomcast/alignment/bundle/steady_color.h"

namespace roomcast::alignment {
namespace {

/// Keeps every second picture, beginning with the first.
void thin_out(std::vector<ColorImage>& pictures) {
  for (std::size_t i = 0; 2 * i < pictures.size(); ++i) std::swap(pictures[i], pictures[2 * i]);
  pictures.resize((pictures.size() + 1) / 2);
}

}  // namespace

BundleCapture::BundleCapture(std::string name, const SensorCalibration& calibration,
                             const BundleCaptureOptions& options)
    : name_(std::move(name)), calibration_(calibration), options_(options) {}

Result<bool> BundleCapture::add(const DepthImage& depth_mm, const ColorImage& color,
                                std::optional<double> time_s) {
  if (depth_mm_.size() == options_.frames) return true;
  if (!same_size(depth_mm.view(), calibration_.depth) ||
      (!color.empty() && !same_size(color.view(), calibration_.color))) {
    return Error{ErrorCode::kInvalidArgument,
                 "sensor " + name_ + " gave a picture of another size than its camera's"};
  }
  if (!color.empty()) add_color(color);
  depth_mm_.push_back(depth_mm);
  if (time_s) times_s_.push_back(*time_s);
  return depth_mm_.size() == options_.frames;
}

void BundleCapture::add_color(const ColorImage& color) {
  const std::size_t place = seen_colors_++;
  if (place % colors_apart_ == 0 && colors_.size() == options_.color_frames) {
    thin_out(colors_);
    colors_apart_ *= 2;
  }
  if (place % colors_apart_ == 0) colors_.push_back(color);
}

Result<CalibrationBundle> BundleCapture::finish() const {
  if (depth_mm_.empty()) {
    return Error{ErrorCode::kUnavailable, "sensor " + name_ + " has not given a frame yet"};
  }
  CalibrationBundle bundle;
  bundle.name = name_;
  bundle.calibration = calibration_;
  SteadyDepth steady = steady_depth(depth_mm_, options_.steady_depth);
  bundle.depth_mm = std::move(steady.depth_mm);
  bundle.moving = std::move(steady.moving);
  if (times_s_.size() == depth_mm_.size())
    bundle.instants = depth_instants(depth_mm_, times_s_, options_.instants);
  if (!colors_.empty()) bundle.color = steady_color(colors_);
  if (const Status status = check(bundle, options_.usable); !status) return status.error();
  return bundle;
}

}  // namespace roomcast::alignment
