// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/pair/plane_prints.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "roomcast/align/pair/overlay.h"

namespace roomcast::align {
namespace {

constexpr int kReach = 5;  // windows of 11 x 11 grid points
constexpr int kWindow = (2 * kReach + 1) * (2 * kReach + 1);
constexpr double kLeastFilled = 0.9;     // of a window
constexpr double kLeastContrast = 6;     // grey levels (standard deviation) in both views
constexpr double kContradiction = 0.12;  // a correlation below it
constexpr float kBefore_m = 0.05F;       // a plane: what is nearer than that
constexpr int kMostAside = 1;            // grid points: refined poses are no further off

/// Points on planes have a plane's very normal (flat_normals.h).
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

/// Whether the colour camera sees nothing but the plane around a place, as far as its greys are
/// mixed: it stands aside of the depth camera, so what is before a plane may cover in one picture
/// what the other shows. Where depth has no reading, somebody may stand.
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

/// Places where both see nothing but a plane.
void keep_planes_only(const SensorView& from, const SensorView& other,
                      const RigidTransform& other_from_view, Overlay& common) {
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

/// Of a window in mine with one that lies aside in theirs.
OverlaySums sums_aside(const Overlay& common, const TexturedPoint& centre, int dx, int dy) {
  OverlaySums sums{};
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

bool can_be_judged(const OverlaySums& sums) {
  return sums[0] >= kLeastFilled * kWindow;
}

bool agrees_aside(const Overlay& common, const TexturedPoint& centre) {
  for (int dy = -kMostAside; dy <= kMostAside; ++dy) {
    for (int dx = -kMostAside; dx <= kMostAside; ++dx) {
      const OverlaySums sums = sums_aside(common, centre, dx, dy);
      if (can_be_judged(sums) && WindowContrast(sums).correlation() >= kContradiction) return true;
    }
  }
  return false;
}

PlanePrints prints_seen_from(const SeenPicture& from, const SeenPicture& other,
                             const RigidTransform& other_from_view) {
  Overlay common = overlay(from, other, other_from_view);
  if (common.count == 0) return {};
  keep_planes_only(from.view(), other.view(), other_from_view, common);
  const WindowSums windows(common);
  PlanePrints prints;
  for (const TexturedPoint& point : from.view().texture.points) {
    if (!common.known[common.place(point.x, point.y)]) continue;
    const OverlaySums sums = windows.around(point.x, point.y, kReach);
    if (!can_be_judged(sums)) continue;
    const WindowContrast contrast(sums);
    if (std::min(contrast.mine, contrast.theirs) < kLeastContrast) continue;
    const double correlation = contrast.correlation();
    ++prints.judged;
    prints.agreement += correlation;
    prints.contradicting += correlation < kContradiction && !agrees_aside(common, point);
  }
  const auto points = static_cast<double>(from.view().texture.points.size());
  return {prints.judged / points, prints.contradicting / points, prints.agreement / points};
}

}  // namespace

PlanePrints compare_plane_prints(const SensorView& a, const SensorView& b, const PairState& state) {
  const SeenPicture seen_a(a, state.a), seen_b(b, state.b);
  PlanePrints prints = prints_seen_from(seen_a, seen_b, state.a_from_b.inverse());
  prints.add(prints_seen_from(seen_b, seen_a, state.a_from_b));
  return prints;
}

}  // namespace roomcast::align
