// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/pair/photo_consistency.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
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

/// A view whose colour is taken from `shift_px` aside.
struct Seen {
  const SensorView& view;
  Eigen::Vector2f shift_px;

  Seen(const SensorView& of, const SensorCorrection& correction)
      : view(of), shift_px(correction.color_shift_px.cast<float>()) {}

  [[nodiscard]] std::optional<float> grey_of(const Eigen::Vector3f& point_m) const {
    const Eigen::Vector3f in_color = view.picture.in_color_frame(point_m);
    if (!(in_color.z() > kNearestSurface_m)) return std::nullopt;
    return texture_grey(view.texture, view.picture.pixel_of(in_color) - shift_px);
  }
  /// Of one of its own points.
  [[nodiscard]] std::optional<float> grey_of(const TexturedPoint& point) const {
    return shift_px.isZero() ? point.grey : grey_of(point.point_m);
  }
};

Overlay overlay(const Seen& from, const Seen& other, const RigidTransform& other_from_view) {
  const Eigen::Matrix3f rotation = other_from_view.rotation.cast<float>();
  const Eigen::Vector3f shift = other_from_view.translation_m.cast<float>();
  const DepthSurface& surface = other.view.surface;
  Overlay out(from.view.texture.width, from.view.texture.height);
  for (const TexturedPoint& point : from.view.texture.points) {
    const Eigen::Vector3f in_other = rotation * point.point_m + shift;
    Eigen::Vector2f pixel;
    if (!surface.lens.project(in_other, pixel)) continue;
    const int u = static_cast<int>(std::lround(pixel.x())),
              v = static_cast<int>(std::lround(pixel.y()));
    if (u < 0 || v < 0 || u >= surface.z_m.width() || v >= surface.z_m.height()) continue;
    const float z = surface.z_m.at(u, v);
    if (!(z > 0) || std::abs(z - in_other.z()) > kSameReading * depth_sigma_m(z)) continue;
    const auto mine = from.grey_of(point), theirs = other.grey_of(in_other);
    if (!mine || !theirs) continue;
    const auto i = static_cast<std::size_t>(point.y) * static_cast<std::size_t>(out.width) +
                   static_cast<std::size_t>(point.x);
    out.mine[i] = *mine;
    out.theirs[i] = *theirs;
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

Agreement agreement_seen_from(const Seen& from, const Seen& other,
                              const RigidTransform& other_from_view) {
  const Overlay common = overlay(from, other, other_from_view);
  if (common.count < kLeastPoints) return {};
  const WindowSums sums(common);
  Agreement total;
  for (const TexturedPoint& point : from.view.texture.points) {
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
  const auto points = static_cast<double>(from.view.texture.points.size());
  return {total.weight / points, total.correlation / points};
}

}  // namespace

PhotoConsistency check_photo_consistency(const SensorView& a, const SensorView& b,
                                         const PairState& state) {
  const Seen seen_a(a, state.a), seen_b(b, state.b);
  const Agreement from_a = agreement_seen_from(seen_a, seen_b, state.a_from_b.inverse());
  const Agreement from_b = agreement_seen_from(seen_b, seen_a, state.a_from_b);
  const double weight = from_a.weight + from_b.weight;
  if (!(weight > 0)) return {};
  return {weight / 2, (from_a.correlation + from_b.correlation) / weight};
}

}  // namespace roomcast::align
