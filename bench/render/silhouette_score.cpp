// SPDX-License-Identifier: Apache-2.0
#include "bench/render/silhouette_score.h"

#include <limits>

#include "bench/render/depth_tolerance.h"
#include "roomcast/core/assert.h"

namespace roomcast::bench {
namespace {

constexpr double kMinShareOfPicture = 0.001;
constexpr double kNotJudged = std::numeric_limits<double>::quiet_NaN();

Rgb8 half_bright_grey(Rgb8 c) {
  const auto level = static_cast<std::uint8_t>((c.r + 2 * c.g + c.b) / 8 + 64);
  return {level, level, level};
}

}  // namespace

SilhouetteErrors find_errors(const Image<float>& drawn_m, const TruthView& truth,
                             const Silhouette& silhouette) {
  const int width = drawn_m.width(), height = drawn_m.height();
  SilhouetteErrors errors{MaskImage(width, height), MaskImage(width, height), kNotJudged,
                          kNotJudged};
  if (silhouette.mask.empty()) return errors;
  ROOMCAST_ASSERT(silhouette.mask.width() == width && silhouette.mask.height() == height);
  double pixels = 0, missing = 0, doubled = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double reach_m = static_cast<double>(silhouette.reach_m.at(x, y));
      if (reach_m <= 0) continue;
      const double z_m = static_cast<double>(drawn_m.at(x, y));
      // Nothing is at all in the way of a true pixel without depth: its surface is infinitely far.
      const double true_m = truth.depth_mm.at(x, y) > 0 ? 0.001 * truth.depth_mm.at(x, y)
                                                        : std::numeric_limits<double>::max();
      const double tolerance_m = depth_tolerance_m(true_m);
      if (silhouette.mask.at(x, y) != 0) {
        pixels += 1;
        if (z_m <= 0 || z_m > true_m + tolerance_m) {
          errors.missing.at(x, y) = 255;
          missing += 1;
        }
      }
      if (z_m > 0 && z_m < true_m - tolerance_m && z_m <= reach_m) {
        errors.doubled.at(x, y) = 255;
        doubled += 1;
      }
    }
  }
  if (pixels > 0 && pixels >= kMinShareOfPicture * width * height) {
    errors.missing_share = missing / pixels;
    errors.doubled_share = doubled / pixels;
  }
  return errors;
}

ColorImage picture_of(const SilhouetteErrors& errors, const Silhouette& silhouette,
                      const ColorImage& drawn) {
  ColorImage picture(drawn.width(), drawn.height());
  for (int y = 0; y < drawn.height(); ++y) {
    for (int x = 0; x < drawn.width(); ++x) {
      if (errors.missing.at(x, y) != 0) {
        picture.at(x, y) = {255, 0, 0};
      } else if (errors.doubled.at(x, y) != 0) {
        picture.at(x, y) = {0, 0, 255};
      } else {
        const Rgb8 color = drawn.at(x, y);
        picture.at(x, y) = silhouette.mask.at(x, y) != 0 ? color : half_bright_grey(color);
      }
    }
  }
  return picture;
}

}  // namespace roomcast::bench
