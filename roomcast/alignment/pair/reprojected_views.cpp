// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/reprojected_views.h"

#include <algorithm>
#include <cmath>

namespace roomcast::alignment {

std::optional<Eigen::Vector2f> CorrectedView::pixel_of(const Eigen::Vector3f& point_m) const {
  const Eigen::Vector3f in_color = view_.picture.in_color_frame(point_m);
  if (!(in_color.z() > view_.picture.nearest_m)) return std::nullopt;
  return view_.picture.pixel_of(in_color) - shift_px_;
}

std::optional<float> CorrectedView::grey_of(const Eigen::Vector3f& point_m) const {
  const auto pixel = pixel_of(point_m);
  return pixel ? texture_grey(view_.texture, *pixel) : std::nullopt;
}

std::optional<float> CorrectedView::tint_of(const Eigen::Vector3f& point_m) const {
  const auto pixel = pixel_of(point_m);
  return pixel ? texture_tint(view_.texture, *pixel) : std::nullopt;
}

std::optional<float> CorrectedView::grey_of(const TexturedPoint& point) const {
  return shift_px_.isZero() ? point.grey : grey_of(point.point_m);
}

namespace {

/// Whether a point with this normal (0 = unknown), both in the other's frame, is on the side of its
/// surface that the other camera sees. Both sides of a board are within the noise of each other,
/// and bear different pictures.
bool faces(const Eigen::Vector3f& point_m, const Eigen::Vector3f& normal,
           const Eigen::Vector3f& seen_normal, const ReprojectionOptions& options) {
  if (!(normal.squaredNorm() > 0)) return true;
  if (!(-normal.dot(point_m.normalized()) > options.min_facing)) return false;
  return !(seen_normal.squaredNorm() > 0) || normal.dot(seen_normal) > options.min_cosine;
}

}  // namespace

ReprojectedViews reprojected_views(const CorrectedView& from, const CorrectedView& other,
                                   const RigidTransform& other_from_view,
                                   const ReprojectionOptions& options) {
  const Eigen::Matrix3f rotation = other_from_view.rotation.cast<float>();
  const Eigen::Vector3f shift = other_from_view.translation_m.cast<float>();
  const DepthSurface& surface = other.view().surface;
  const DepthNoiseOptions noise = surface.options.noise;
  const float same_reading_sigmas = options.same_reading_sigmas;
  ReprojectedViews out(from.view().texture.width, from.view().texture.height);
  for (const TexturedPoint& point : from.view().texture.points) {
    const Eigen::Vector3f in_other = rotation * point.point_m + shift;
    Eigen::Vector2f pixel;
    if (!surface.lens.project(in_other, pixel)) continue;
    const int u = static_cast<int>(std::lround(pixel.x())),
              v = static_cast<int>(std::lround(pixel.y()));
    if (u < 0 || v < 0 || u >= surface.z_m.width() || v >= surface.z_m.height()) continue;
    const float z = surface.z_m.at(u, v);
    if (!(z > 0) || std::abs(z - in_other.z()) > same_reading_sigmas * noise.sigma_m(z)) continue;
    const Eigen::Vector3f& normal =
        from.view().surface.at.at(kTextureStep * point.x, kTextureStep * point.y).normal;
    if (!faces(in_other, rotation * normal, surface.at.at(u, v).normal, options)) continue;
    const auto mine = from.grey_of(point), theirs = other.grey_of(in_other);
    if (!mine || !theirs) continue;
    const std::size_t i = out.place(point.x, point.y);
    out.mine[i] = *mine;
    out.theirs[i] = *theirs;
    out.known[i] = 1;
    ++out.count;
  }
  return out;
}

void add_place(float mine, float theirs, ReprojectionSums& sums) {
  const double p = double(mine), q = double(theirs);
  const ReprojectionSums here = {1, p, q, p * p, q * q, p * q};
  for (std::size_t k = 0; k < here.size(); ++k) sums[k] += here[k];
}

WindowSums::WindowSums(const ReprojectedViews& reprojected_views)
    : width_(reprojected_views.width),
      height_(reprojected_views.height),
      sums_((static_cast<std::size_t>(width_) + 1) * (static_cast<std::size_t>(height_) + 1)) {
  const std::size_t columns = static_cast<std::size_t>(width_) + 1;
  for (std::size_t y = 1; y <= static_cast<std::size_t>(height_); ++y) {
    ReprojectionSums row{};
    for (std::size_t x = 1; x < columns; ++x) {
      const std::size_t i = (y - 1) * (columns - 1) + x - 1;
      if (reprojected_views.known[i])
        add_place(reprojected_views.mine[i], reprojected_views.theirs[i], row);
      for (std::size_t k = 0; k < row.size(); ++k) {
        sums_[y * columns + x][k] = sums_[(y - 1) * columns + x][k] + row[k];
      }
    }
  }
}

ReprojectionSums WindowSums::around(int x, int y, int reach) const {
  const auto at = [&](int column, int row) -> const ReprojectionSums& {
    return sums_[static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1) +
                 static_cast<std::size_t>(column)];
  };
  const int left = std::max(0, x - reach), right = std::min(width_, x + reach + 1);
  const int top = std::max(0, y - reach), bottom = std::min(height_, y + reach + 1);
  ReprojectionSums out;
  for (std::size_t k = 0; k < out.size(); ++k)
    out[k] = at(right, bottom)[k] - at(right, top)[k] - at(left, bottom)[k] + at(left, top)[k];
  return out;
}

WindowContrast::WindowContrast(const ReprojectionSums& sums) {
  const double n = sums[0], mean_p = sums[1] / n, mean_q = sums[2] / n;
  mine = std::sqrt(std::max(0.0, sums[3] / n - mean_p * mean_p));
  theirs = std::sqrt(std::max(0.0, sums[4] / n - mean_q * mean_q));
  together = sums[5] / n - mean_p * mean_q;
}

double WindowContrast::correlation(const ReprojectionOptions& options) const {
  return together / (mine * theirs + options.noise_contrast);
}

}  // namespace roomcast::alignment
