// SPDX-License-Identifier: Apache-2.0
#include "bench/model/model_score.h"

#include <algorithm>
#include <cmath>

#include "roomcast/recording/export/depth_points.h"

namespace roomcast::bench {
namespace {

float error_at(std::vector<float>& errors_m, double share) {
  if (errors_m.empty()) return 0;
  const auto place = errors_m.begin() +
                     static_cast<std::ptrdiff_t>(share * static_cast<double>(errors_m.size() - 1));
  std::ranges::nth_element(errors_m, place);
  return *place;
}

Rgb8 class_color(bool drawn, bool covered, bool floats, float error_m) {
  if (floats) return {255, 255, 0};
  if (!drawn) return {255, 0, 0};
  if (!covered) return {0, 0, 255};
  const auto level = static_cast<std::uint8_t>(255 - std::min(155.0F, 5000 * error_m));
  return {level, level, level};
}

double share_of(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}  // namespace

ColorImage add_score(const Image<float>& model_m, const StillTruth& truth, SurfaceScore& score) {
  recording::DepthPoints points(truth.camera);
  points.set(truth.depth_mm);
  ColorImage picture(truth.camera.width, truth.camera.height);
  for (int y = 0; y < truth.camera.height; ++y) {
    for (int x = 0; x < truth.camera.width; ++x) {
      if (!points.has(x, y)) continue;
      const float true_m = points.z_m(x, y), drawn_m = model_m.at(x, y);
      const float slope = std::abs(points.normal(x, y).dot(points.point_m(x, y))) / true_m;
      const float error_m = slope * std::abs(drawn_m - true_m);
      const bool floats = drawn_m > 0 && drawn_m < true_m - 0.05F - 0.02F * true_m;
      score.drawn += drawn_m > 0;
      score.floating += floats;
      const int readings = truth.readings.at(x, y);
      const bool covered = drawn_m > 0 && error_m <= std::max(0.03F, 0.01F * true_m);
      score.read_once += readings > 0;
      score.covered_once += readings > 0 && covered;
      if (readings < kMinReadings) continue;
      ++score.seen;
      score.covered += covered;
      if (drawn_m > 0) score.errors_m.push_back(error_m);
      picture.at(x, y) = class_color(drawn_m > 0, covered, floats, error_m);
    }
  }
  return picture;
}

ScoreFigures figures_of(SurfaceScore score) {
  ScoreFigures figures;
  figures.median_mm = 1000 * error_at(score.errors_m, 0.5);
  figures.p90_mm = 1000 * error_at(score.errors_m, 0.9);
  figures.coverage = share_of(score.covered, score.seen);
  figures.coverage_once = share_of(score.covered_once, score.read_once);
  figures.floating = share_of(score.floating, score.drawn);
  figures.pixels = score.seen;
  return figures;
}

}  // namespace roomcast::bench
