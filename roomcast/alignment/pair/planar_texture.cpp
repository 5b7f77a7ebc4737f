// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/planar_texture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace roomcast::alignment {
namespace {

struct TextureLimits {
  PlanarTextureOptions texture;
  ReprojectionOptions reprojection;

  /// Places in a window.
  [[nodiscard]] int window() const { return (2 * texture.reach + 1) * (2 * texture.reach + 1); }
};

/// Compares normals exactly: points on planes have the plane's own normal (flat_normals.h).
bool lies_on_plane(const SensorView& view, const TexturedPoint& point) {
  const Eigen::Vector3f& normal =
      view.surface.at.at(kTextureStep * point.x, kTextureStep * point.y).normal;
  return std::ranges::any_of(view.planes,
                             [&](const Plane& plane) { return plane.normal == normal; });
}

/// The point in the colour camera's frame; nothing outside its picture or where there is no
/// reading.
std::optional<Eigen::Vector3f> seen_at(const ColorPicture& picture, const Eigen::Vector2f& pixel) {
  if (!(pixel.x() > -0.5F && pixel.y() > -0.5F)) return std::nullopt;
  const int x = static_cast<int>(std::lround(pixel.x()));
  const int y = static_cast<int>(std::lround(pixel.y()));
  if (x >= picture.z_m.width() || y >= picture.z_m.height()) return std::nullopt;
  const float z = picture.z_m.at(x, y);
  if (!(z > 0)) return std::nullopt;
  const Pinhole& camera = picture.camera;
  return z * Eigen::Vector3f((pixel.x() - camera.cx) / camera.fx,
                             (pixel.y() - camera.cy) / camera.fy, 1);
}

/// Whether the colour camera sees only the plane around a place, within the radius of the blur. The
/// colour camera is apart from the depth camera, so an object in front of a plane may cover in one
/// picture what the other shows. A person may be where depth has no reading.
bool sees_plane_around(const ColorPicture& picture, const SurfacePoint& on_plane, float before_m) {
  const Eigen::Vector3f point = picture.in_color_frame(on_plane.point_m);
  if (!(point.z() > picture.nearest_m)) return false;
  const Eigen::Vector3f normal = picture.color_from_depth_rotation * on_plane.normal;
  const Eigen::Vector2f middle = picture.pixel_of(point);
  for (const int dy : {-kTextureBlurReach, 0, kTextureBlurReach}) {
    for (const int dx : {-kTextureBlurReach, 0, kTextureBlurReach}) {
      const auto seen = seen_at(picture, middle + Eigen::Vector2f(dx, dy));
      if (!seen || normal.dot(*seen - point) > before_m) return false;
    }
  }
  return true;
}

/// Keeps only the places where both sensors see nothing but a plane.
void keep_planes_only(const SensorView& from, const SensorView& other,
                      const RigidTransform& other_from_view, float before_m,
                      ReprojectedViews& common) {
  const Eigen::Matrix3f rotation = other_from_view.rotation.cast<float>();
  const Eigen::Vector3f shift = other_from_view.translation_m.cast<float>();
  for (const TexturedPoint& point : from.texture.points) {
    char& known = common.known[common.place(point.x, point.y)];
    if (!known) continue;
    const SurfacePoint& mine = from.surface.at.at(kTextureStep * point.x, kTextureStep * point.y);
    const SurfacePoint theirs{rotation * mine.point_m + shift, rotation * mine.normal};
    known = lies_on_plane(from, point) && sees_plane_around(from.picture, mine, before_m) &&
            sees_plane_around(other.picture, theirs, before_m);
  }
}

/// Sums over a window of `mine` and the window of `theirs` shifted by (dx, dy).
ReprojectionSums sums_aside(const ReprojectedViews& common, const TexturedPoint& centre, int dx,
                            int dy, int reach) {
  ReprojectionSums sums{};
  for (int y = centre.y - reach; y <= centre.y + reach; ++y) {
    for (int x = centre.x - reach; x <= centre.x + reach; ++x) {
      if (x < 0 || y < 0 || x >= common.width || y >= common.height) continue;
      if (x + dx < 0 || y + dy < 0 || x + dx >= common.width || y + dy >= common.height) continue;
      const std::size_t here = common.place(x, y), aside = common.place(x + dx, y + dy);
      if (!common.known[here] || !common.known[aside]) continue;
      add_place(common.mine[here], common.theirs[aside], sums);
    }
  }
  return sums;
}

bool can_be_judged(const ReprojectionSums& sums, const TextureLimits& limits) {
  return sums[0] >= limits.texture.min_filled * limits.window();
}

/// Whether both pictures agree at a shift after all: at a small one, or clearly at a larger one.
bool agrees_when_shifted(const ReprojectedViews& common, const TexturedPoint& centre,
                         const TextureLimits& limits) {
  const PlanarTextureOptions& options = limits.texture;
  for (int dy = -options.far_shift; dy <= options.far_shift; ++dy) {
    for (int dx = -options.far_shift; dx <= options.far_shift; ++dx) {
      const bool is_far = std::max(std::abs(dx), std::abs(dy)) > options.near_shift;
      const ReprojectionSums sums = sums_aside(common, centre, dx, dy, options.reach);
      if (sums[0] < (is_far ? options.min_filled_aside : options.min_filled) * limits.window())
        continue;
      const double correlation = WindowContrast(sums).correlation(limits.reprojection);
      if (correlation >= (is_far ? options.found_far_aside : options.contradiction)) return true;
    }
  }
  return false;
}

/// Slope of a picture's tint over its grey, window by window, on the grid of a ReprojectedViews.
class TintByGrey {
 public:
  /// `tint_of(point)` is the tint of a point of the view that defines the grid.
  template <class TintOf>
  TintByGrey(const ReprojectedViews& common, const std::vector<float>& grey,
             std::span<const TexturedPoint> points, int reach, TintOf tint_of)
      : reach_(reach), windows_(overlaid(common, grey, points, tint_of)) {}

  /// Slope of red minus green over grey; a tint is half of red minus green.
  [[nodiscard]] double slope(const TexturedPoint& at) const {
    const WindowContrast contrast(windows_.around(at.x, at.y, reach_));
    return 2 * contrast.together / (contrast.mine * contrast.mine);
  }

 private:
  template <class TintOf>
  static ReprojectedViews overlaid(const ReprojectedViews& common, const std::vector<float>& grey,
                                   std::span<const TexturedPoint> points, TintOf tint_of) {
    ReprojectedViews out = common;
    out.mine = grey;
    for (const TexturedPoint& point : points) {
      const std::size_t i = common.place(point.x, point.y);
      if (!common.known[i]) continue;
      const std::optional<float> tint = tint_of(point);
      out.known[i] = tint.has_value();
      out.theirs[i] = tint.value_or(0);
    }
    return out;
  }

  int reach_;
  WindowSums windows_;
};

bool are_other_hues(double slope, double other, const PlanarTextureOptions& options) {
  const double smaller = std::min(std::abs(slope), std::abs(other));
  const double larger = std::max(std::abs(slope), std::abs(other));
  return std::abs(slope - other) > options.other_slope &&
         (slope * other < 0 || smaller < options.other_ratio * larger);
}

PlanarTexture prints_seen_from(const CorrectedView& from, const CorrectedView& other,
                               const RigidTransform& other_from_view, const TextureLimits& limits) {
  const PlanarTextureOptions& options = limits.texture;
  ReprojectedViews common = reprojected_views(from, other, other_from_view, limits.reprojection);
  if (common.count == 0) return {};
  keep_planes_only(from.view(), other.view(), other_from_view, options.before_m, common);
  const WindowSums windows(common);
  const auto& points = from.view().texture.points;
  std::optional<TintByGrey> mine, theirs;
  if (from.view().texture.has_hues && other.view().texture.has_hues) {
    mine.emplace(common, common.mine, points, options.reach,
                 [&](const TexturedPoint& point) { return from.tint_of(point.point_m); });
    theirs.emplace(common, common.theirs, points, options.reach, [&](const TexturedPoint& point) {
      return other.tint_of((other_from_view * point.point_m.cast<double>()).cast<float>());
    });
  }
  PlanarTexture prints;
  for (const TexturedPoint& point : points) {
    if (!common.known[common.place(point.x, point.y)]) continue;
    const ReprojectionSums sums = windows.around(point.x, point.y, options.reach);
    if (!can_be_judged(sums, limits)) continue;
    const WindowContrast contrast(sums);
    if (std::min(contrast.mine, contrast.theirs) < options.min_contrast) continue;
    const double correlation = contrast.correlation(limits.reprojection);
    ++prints.judged;
    prints.agreement += correlation;
    prints.contradicting +=
        correlation < options.contradiction && !agrees_when_shifted(common, point, limits);
    if (correlation < options.alike_correlation || !mine) continue;
    ++prints.alike;
    prints.different_hue += are_other_hues(mine->slope(point), theirs->slope(point), options);
  }
  return prints.over(static_cast<double>(points.size()));
}

}  // namespace

PlanarTexture compare_planar_texture(const SensorView& a, const SensorView& b,
                                     const PairState& state, const PlanarTextureOptions& options,
                                     const ReprojectionOptions& reprojection) {
  const TextureLimits limits{options, reprojection};
  const CorrectedView seen_a(a, state.a), seen_b(b, state.b);
  PlanarTexture prints = prints_seen_from(seen_a, seen_b, state.a_from_b.inverse(), limits);
  prints.add(prints_seen_from(seen_b, seen_a, state.a_from_b, limits));
  return prints;
}

}  // namespace roomcast::alignment
