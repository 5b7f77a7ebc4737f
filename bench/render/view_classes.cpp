// SPDX-License-Identifier: Apache-2.0
#include "bench/render/view_classes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace roomcast::bench {
namespace {

constexpr int kCoarser = 4;
constexpr float kFar = 1e9F;
constexpr double kSightMargin_m = 0.06, kSightMarginPer_m = 0.02;
constexpr int kMovingLevels = 10, kMovingDepth_mm = 30, kMovingReach = 2;

Image<float> nearest_of_neighbours(const Image<float>& image) {
  Image<float> out(image.width(), image.height(), kFar);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height() - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.width() - 1); ++u) {
          out.at(x, y) = std::min(out.at(x, y), image.at(u, v));
        }
      }
    }
  }
  return out;
}

/// Sets pixels that have more than `quorum` set pixels among the (2 reach + 1)^2 around them.
MaskImage where_more_than(const MaskImage& mask, int reach, int quorum) {
  MaskImage out(mask.width(), mask.height());
  for (int y = reach; y < mask.height() - reach; ++y) {
    for (int x = reach; x < mask.width() - reach; ++x) {
      int count = 0;
      for (int v = -reach; v <= reach; ++v) {
        for (int u = -reach; u <= reach; ++u) count += mask.at(x + u, y + v) != 0;
      }
      out.at(x, y) = count > quorum ? 255 : 0;
    }
  }
  return out;
}

bool differs(Rgb8 a, Rgb8 b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) > kMovingLevels;
}

MaskImage moving_pixels(const TruthView& a, const TruthView& b) {
  MaskImage raw(a.color.width(), a.color.height());
  for (int y = 0; y < raw.height(); ++y) {
    for (int x = 0; x < raw.width(); ++x) {
      const bool moved = differs(a.color.at(x, y), b.color.at(x, y)) ||
                         std::abs(a.depth_mm.at(x, y) - b.depth_mm.at(x, y)) > kMovingDepth_mm;
      raw.at(x, y) = moved ? 255 : 0;
    }
  }
  const MaskImage without_specks = where_more_than(raw, 1, 4);  // the median of 3x3
  return where_more_than(without_specks, kMovingReach, 0);
}

}  // namespace

ColorSight::ColorSight(const TrueSensor& sensor)
    : color_(sensor.calibration.color),
      color_from_world_(sensor.calibration.color_from_depth * sensor.world_from_depth.inverse()) {
  Image<float> nearest(color_.width / kCoarser, color_.height / kCoarser, kFar);
  const Image<Eigen::Vector2f> rays = ray_table(sensor.calibration.depth);
  for (int y = 0; y < rays.height(); ++y) {
    for (int x = 0; x < rays.width(); ++x) {
      const double z_m = 0.001 * sensor.depth_mm.at(x, y);
      if (z_m <= 0 || !rays.at(x, y).allFinite()) continue;
      const Eigen::Vector2d ray = rays.at(x, y).cast<double>();
      const Eigen::Vector3d in_color =
          sensor.calibration.color_from_depth * Eigen::Vector3d(ray.x() * z_m, ray.y() * z_m, z_m);
      const auto pixel = project(color_, in_color);
      if (!pixel) continue;
      const int u = static_cast<int>(std::floor(pixel->x() / kCoarser));
      const int v = static_cast<int>(std::floor(pixel->y() / kCoarser));
      if (u < 0 || v < 0 || u >= nearest.width() || v >= nearest.height()) continue;
      nearest.at(u, v) = std::min(nearest.at(u, v), static_cast<float>(in_color.z()));
    }
  }
  nearest_m_ = nearest_of_neighbours(nearest);
}

bool ColorSight::sees(const Eigen::Vector3d& point_world) const {
  const Eigen::Vector3d point = color_from_world_ * point_world;
  const auto pixel = project(color_, point);
  if (!pixel || pixel->x() < 1 || pixel->y() < 1 || pixel->x() > color_.width - 2 ||
      pixel->y() > color_.height - 2) {
    return false;
  }
  const int u = std::min(static_cast<int>(pixel->x()) / kCoarser, nearest_m_.width() - 1);
  const int v = std::min(static_cast<int>(pixel->y()) / kCoarser, nearest_m_.height() - 1);
  const double nearest_m = nearest_m_.at(u, v);
  return point.z() <= nearest_m + kSightMargin_m + kSightMarginPer_m * nearest_m;
}

ViewClasses classify(const TruthViewEntry& entry, const TruthView& now,
                     const TruthView& other_instant, std::span<const ColorSight> sights,
                     std::span<const StillBackground> backgrounds) {
  ViewClasses classes{MaskImage(now.color.width(), now.color.height()),
                      moving_pixels(now, other_instant),
                      find_silhouette(entry.camera, now, backgrounds)};
  const ViewPoints points(entry.camera);
  for (int y = 0; y < now.color.height(); ++y) {
    for (int x = 0; x < now.color.width(); ++x) {
      const unsigned seen = now.seen.at(x, y);
      if (seen == 0) continue;
      const Eigen::Vector3d point = points.at(x, y, 0.001 * now.depth_mm.at(x, y));
      for (std::size_t s = 0; s < sights.size() && classes.colored.at(x, y) == 0; ++s) {
        if ((seen >> s & 1U) != 0 && sights[s].sees(point)) classes.colored.at(x, y) = 255;
      }
    }
  }
  return classes;
}

}  // namespace roomcast::bench
