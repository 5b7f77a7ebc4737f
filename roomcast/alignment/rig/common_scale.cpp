// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/common_scale.h"

#include <algorithm>
#include <cmath>

namespace roomcast::alignment {

std::vector<DepthScale> in_common_scale(std::vector<DepthScale> relative, std::size_t origin) {
  const auto is_determined = [](const DepthScale& scale) { return scale.standard_error > 0; };
  double sum = 0, determined = 0;
  for (const DepthScale& scale : relative) {
    if (!is_determined(scale)) continue;
    if (scale.factor == 1) return relative;
    sum += std::log(scale.factor);
    ++determined;
  }
  if (determined == 0) return relative;
  const double to_common = std::exp(-sum / (determined + 1));  // the origin's logarithm is 0
  for (std::size_t i = 0; i < relative.size(); ++i) {
    if (i == origin || is_determined(relative[i])) relative[i].factor *= to_common;
  }
  return relative;
}

double common_scale_error(std::size_t sensors, double uncalibrated_belief, double sigma,
                          const CommonScaleOptions& options) {
  const double count = static_cast<double>(std::max<std::size_t>(1, sensors));
  return std::sqrt(options.calibrated_sigma * options.calibrated_sigma +
                   uncalibrated_belief * sigma * sigma / count);
}

}  // namespace roomcast::alignment
