// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/pair/photo_consistency.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "roomcast/align/view/depth_noise.h"

namespace roomcast::align {
namespace {

constexpr int kReach = 5;             // windows of 11 x 11 grid points
constexpr double kLeastFilled = 0.5;  // of a window
constexpr float kSameReading = 10;    // sigmas of the depth noise
constexpr double kLeastContrast = 4;  // grey levels (standard deviation) in either view
constexpr double kFullContrast = 25;
constexpr double kNoiseContrast = 6;  // added below: faint texture correlates by chance
constexpr std::size_t kLeastPoints = 50;

/// Two pictures on the same grid, where both are known.
struct Overlay {
  int width, height;
  std::vector<float> mine, theirs;
  std::vector<char> known;
  std::size_t count = 0;

  Overlay(int w, int h)
      : width(w),
        height(h),
        mine(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)),
        theirs(mine.size()),
        known(mine.size()) {}
};

Overlay overlay(const SensorView& view, const SensorView& other,
                const RigidTransform& other_from_view) {
  const Eigen::Matrix3f rotation = other_from_view.rotation.cast<float>();
  const Eigen::Vector3f shift = other_from_view.translation_m.cast<float>();
  const Image<float>& seen = other.surface.z_m;
  Overlay out(view.texture.width, view.texture.height);
  for (const TexturedPoint& point : view.texture.points) {
    const Eigen::Vector3f in_other = rotation * point.point_m + shift;
    Eigen::Vector2f pixel;
    if (!other.surface.lens.project(in_other, pixel)) continue;
    const int u = static_cast<int>(std::lround(pixel.x())),
              v = static_cast<int>(std::lround(pixel.y()));
    if (u < 0 || v < 0 || u >= seen.width() || v >= seen.height()) continue;
    const float z = seen.at(u, v);
    if (!(z > 0) || std::abs(z - in_other.z()) > kSameReading * depth_sigma_m(z)) continue;
    const Eigen::Vector3f in_color = other.picture.in_color_frame(in_other);
    if (!(in_color.z() > kNearestSurface_m)) continue;
    const auto grey = texture_grey(other.texture, other.picture.pixel_of(in_color));
    if (!grey) continue;
    const auto i = static_cast<std::size_t>(point.y) * static_cast<std::size_t>(out.width) +
                   static_cast<std::size_t>(point.x);
    out.mine[i] = point.grey;
    out.theirs[i] = *grey;
    out.known[i] = 1;
    ++out.count;
  }
  return out;
}

/// Sums over rectangles in constant time (Crow 1984): how many, x, y, xx, yy, xy.
class WindowSums {
 public:
  using Sums = std::array<double, 6>;

  explicit WindowSums(const Overlay& overlay)
      : columns_(static_cast<std::size_t>(overlay.width) + 1),
        sums_(columns_ * (static_cast<std::size_t>(overlay.height) + 1)) {
    for (std::size_t y = 1; y <= static_cast<std::size_t>(overlay.height); ++y) {
      Sums row{};
      for (std::size_t x = 1; x < columns_; ++x) {
        const std::size_t i = (y - 1) * (columns_ - 1) + x - 1;
        if (overlay.known[i]) {
          const double p = double(overlay.mine[i]), q = double(overlay.theirs[i]);
          const Sums here = {1, p, q, p * p, q * q, p * q};
          for (std::size_t k = 0; k < here.size(); ++k) row[k] += here[k];
        }
        for (std::size_t k = 0; k < row.size(); ++k) {
          sums_[y * columns_ + x][k] = sums_[(y - 1) * columns_ + x][k] + row[k];
        }
      }
    }
  }

  /// Over left..right-1, top..bottom-1.
  [[nodiscard]] Sums over(std::size_t left, std::size_t top, std::size_t right,
                          std::size_t bottom) const {
    Sums out;
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k] = sums_[bottom * columns_ + right][k] - sums_[top * columns_ + right][k] -
               sums_[bottom * columns_ + left][k] + sums_[top * columns_ + left][k];
    }
    return out;
  }

 private:
  std::size_t columns_;
  std::vector<Sums> sums_;
};

struct Agreement {
  double weight = 0, correlation = 0;  // of one window; the correlation times the weight
};

Agreement agreement(const WindowSums::Sums& sums) {
  const double n = sums[0];
  if (n < kLeastFilled * (2 * kReach + 1) * (2 * kReach + 1)) return {};
  const double mean_p = sums[1] / n, mean_q = sums[2] / n;
  const double contrast_p = std::sqrt(std::max(0.0, sums[3] / n - mean_p * mean_p));
  const double contrast_q = std::sqrt(std::max(0.0, sums[4] / n - mean_q * mean_q));
  const double contrast = std::max(contrast_p, contrast_q);
  if (contrast < kLeastContrast) return {};
  const double covariance = sums[5] / n - mean_p * mean_q;
  const double weight = std::min(contrast, kFullContrast) / kFullContrast;
  return {weight, weight * covariance / (contrast_p * contrast_q + kNoiseContrast)};
}

Agreement agreement_seen_from(const SensorView& view, const SensorView& other,
                              const RigidTransform& other_from_view) {
  const Overlay common = overlay(view, other, other_from_view);
  if (common.count < kLeastPoints) return {};
  const WindowSums sums(common);
  Agreement total;
  for (const TexturedPoint& point : view.texture.points) {
    const auto x = static_cast<std::size_t>(point.x), y = static_cast<std::size_t>(point.y);
    const auto width = static_cast<std::size_t>(common.width);
    const auto height = static_cast<std::size_t>(common.height);
    if (!common.known[y * width + x]) continue;
    const Agreement here =
        agreement(sums.over(x < kReach ? 0 : x - kReach, y < kReach ? 0 : y - kReach,
                            std::min(x + kReach + 1, width), std::min(y + kReach + 1, height)));
    total.weight += here.weight;
    total.correlation += here.correlation;
  }
  const auto points = static_cast<double>(view.texture.points.size());
  return {total.weight / points, total.correlation / points};
}

}  // namespace

PhotoConsistency check_photo_consistency(const SensorView& a, const SensorView& b,
                                         const RigidTransform& a_from_b) {
  const Agreement from_a = agreement_seen_from(a, b, a_from_b.inverse());
  const Agreement from_b = agreement_seen_from(b, a, a_from_b);
  const double weight = from_a.weight + from_b.weight;
  if (!(weight > 0)) return {};
  return {weight / 2, (from_a.correlation + from_b.correlation) / weight};
}

}  // namespace roomcast::align
