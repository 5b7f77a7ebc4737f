// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/planar_texture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "roomcast/alignment/pair/reprojected_views.h"

namespace roomcast::alignment {
namespace {

constexpr int kReach = 5;  // windows of 11 x 11 grid points
constexpr int kWindow = (2 * kReach + 1) * (2 * kReach + 1);
constexpr double kMinFilled = 0.9;         // of a window
constexpr double kMinContrast = 6;         // grey levels (standard deviation) in both views
constexpr double kContradiction = 0.12;    // correlations below it contradict
constexpr float kBefore_m = 0.05F;         // surfaces further in front of a plane cover it
constexpr double kAlikeCorrelation = 0.5;  // lowest correlation of windows alike in grey
constexpr double kOtherSlope = 0.3;     // slopes that differ by more are other hues, if besides...
constexpr double kOtherRatio = 0.5;     // ...one is less than this share of the other: cameras vary
constexpr int kNearShift = 1;           // grid points: refined poses are off by no more...
constexpr int kFarShift = 4;            // ...but colours may be, near a camera and in corners
constexpr double kFoundFarAside = 0.6;  // lowest correlation of agreement far aside
constexpr double kMinFilledAside = 0.5;

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
bool sees_plane_around(const ColorPicture& picture, const SurfacePoint& on_plane) {
  const Eigen::Vector3f point = picture.in_color_frame(on_plane.point_m);
  if (!(point.z() > kNearestSurface_m)) return false;
  const Eigen::Vector3f normal = picture.color_from_depth_rotation * on_plane.normal;
  const Eigen::Vector2f middle = picture.pixel_of(point);
  for (const int dy : {-kTextureBlurReach, 0, kTextureBlurReach}) {
    for (const int dx : {-kTextureBlurReach, 0, kTextureBlurReach}) {
      const auto seen = seen_at(picture, middle + Eigen::Vector2f(dx, dy));
      if (!seen || normal.dot(*seen - point) > kBefore_m) return false;
    }
  }
  return true;
}

/// Keeps only the places where both sensors see nothing but a plane.
void keep_planes_only(const SensorView& from, const SensorView& other,
                      const RigidTransform& other_from_view, ReprojectedViews& common) {
  const Eigen::Matrix3f rotation = other_from_view.rotation.cast<float>();
  const Eigen::Vector3f shift = other_from_view.translation_m.cast<float>();
  for (const TexturedPoint& point : from.texture.points) {
    char& known = common.known[common.place(point.x, point.y)];
    if (!known) continue;
    const SurfacePoint& mine = from.surface.at.at(kTextureStep * point.x, kTextureStep * point.y);
    const SurfacePoint theirs{rotation * mine.point_m + shift, rotation * mine.normal};
    known = lies_on_plane(from, point) && sees_plane_around(from.picture, mine) &&
            sees_plane_around(other.picture, theirs);
  }
}

/// Sums over a window of `mine` and the window of `theirs` shifted by (dx, dy).
ReprojectionSums sums_aside(const ReprojectedViews& common, const TexturedPoint& centre, int dx,
                            int dy) {
  ReprojectionSums sums{};
  for (int y = centre.y - kReach; y <= centre.y + kReach; ++y) {
    for (int x = centre.x - kReach; x <= centre.x + kReach; ++x) {
      if (x < 0 || y < 0 || x >= common.width || y >= common.height) continue;
      if (x + dx < 0 || y + dy < 0 || x + dx >= common.width || y + dy >= common.height) continue;
      const std::size_t here = common.place(x, y), aside = common.place(x + dx, y + dy);
      if (!common.known[here] || !common.known[aside]) continue;
      add_place(common.mine[here], common.theirs[aside], sums);
    }
  }
  return sums;
}

bool can_be_judged(const ReprojectionSums& sums) {
  return sums[0] >= kMinFilled * kWindow;
}

/// Whether both pictures agree at a shift after all: at a small one, or clearly at a larger one.
bool agrees_when_shifted(const ReprojectedViews& common, const TexturedPoint& centre) {
  for (int dy = -kFarShift; dy <= kFarShift; ++dy) {
    for (int dx = -kFarShift; dx <= kFarShift; ++dx) {
      const bool is_far = std::max(std::abs(dx), std::abs(dy)) > kNearShift;
      const ReprojectionSums sums = sums_aside(common, centre, dx, dy);
      if (sums[0] < (is_far ? kMinFilledAside : kMinFilled) * kWindow) continue;
      const double correlation = WindowContrast(sums).correlation();
      if (correlation >= (is_far ? kFoundFarAside : kContradiction)) return true;
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
             std::span<const TexturedPoint> points, TintOf tint_of)
      : windows_(overlaid(common, grey, points, tint_of)) {}

  /// Slope of red minus green over grey; a tint is half of red minus green.
  [[nodiscard]] double slope(const TexturedPoint& at) const {
    const WindowContrast contrast(windows_.around(at.x, at.y, kReach));
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

  WindowSums windows_;
};

bool are_other_hues(double slope, double other) {
  const double smaller = std::min(std::abs(slope), std::abs(other));
  const double larger = std::max(std::abs(slope), std::abs(other));
  return std::abs(slope - other) > kOtherSlope &&
         (slope * other < 0 || smaller < kOtherRatio * larger);
}

PlanarTexture prints_seen_from(const CorrectedView& from, const CorrectedView& other,
                               const RigidTransform& other_from_view) {
  ReprojectedViews common = reprojected_views(from, other, other_from_view);
  if (common.count == 0) return {};
  keep_planes_only(from.view(), other.view(), other_from_view, common);
  const WindowSums windows(common);
  const auto& points = from.view().texture.points;
  std::optional<TintByGrey> mine, theirs;
  if (from.view().texture.has_hues && other.view().texture.has_hues) {
    mine.emplace(common, common.mine, points,
                 [&](const TexturedPoint& point) { return from.tint_of(point.point_m); });
    theirs.emplace(common, common.theirs, points, [&](const TexturedPoint& point) {
      return other.tint_of((other_from_view * point.point_m.cast<double>()).cast<float>());
    });
  }
  PlanarTexture prints;
  for (const TexturedPoint& point : points) {
    if (!common.known[common.place(point.x, point.y)]) continue;
    const ReprojectionSums sums = windows.around(point.x, point.y, kReach);
    if (!can_be_judged(sums)) continue;
    const WindowContrast contrast(sums);
    if (std::min(contrast.mine, contrast.theirs) < kMinContrast) continue;
    const double correlation = contrast.correlation();
    ++prints.judged;
    prints.agreement += correlation;
    prints.contradicting += correlation < kContradiction && !agrees_when_shifted(common, point);
    if (correlation < kAlikeCorrelation || !mine) continue;
    ++prints.alike;
    prints.different_hue += are_other_hues(mine->slope(point), theirs->slope(point));
  }
  return prints.over(static_cast<double>(points.size()));
}

}  // namespace

PlanarTexture compare_planar_texture(const SensorView& a, const SensorView& b,
                                     const PairState& state) {
  const CorrectedView seen_a(a, state.a), seen_b(b, state.b);
  PlanarTexture prints = prints_seen_from(seen_a, seen_b, state.a_from_b.inverse());
  prints.add(prints_seen_from(seen_b, seen_a, state.a_from_b));
  return prints;
}

}  // namespace roomcast::alignment
