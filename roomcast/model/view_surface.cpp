// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/view_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

namespace roomcast::model {
namespace {

/// Largest difference of neighbouring readings of one surface, unless they go on evenly.
constexpr float kStep_m = 0.01F, kStepPerDepth = 0.02F;
/// A slanted surface may go on in steps up to this share of the depth while its inverse depth, on a
/// plane a linear function of the pixel, changes by nearly the same from pixel to pixel.
constexpr float kSlantedStepPerDepth = 0.15F, kUnevenStep = 0.3F;
constexpr float kMinSlope = 0.1F;  // of a surface against the ray; noise makes less meaningless
constexpr int kMinJoined = 2;      // of 8 neighbours
constexpr int kFillPasses = 2;
constexpr float kMinFillPairs = 2;  // of opposite neighbours, of 4
constexpr float kMaxTruncationVoxels = 8;
constexpr float kWeightUnit_m = 0.001F;  // an exact reading has sigma 1 mm and weight 1

/// Of a reading: what averaging does not remove.
float bias_at(float z_m, const ModelOptions& options) {
  return options.bias_m + options.bias_per_depth * z_m;
}

float depth_of(const ViewSurface::Texel& texel) {
  return 1 / texel.inverse_m;
}

}  // namespace

ViewSurface::ViewSurface(const StillView& view, const ModelOptions& options)
    : camera_(view.camera()),
      options_(options),
      rays_(ray_table(view.camera())),
      texels_(view.camera().width, view.camera().height) {
  const RigidTransform& pose = view.world_from_depth();
  world_from_depth_ = pose.rotation.cast<float>();
  depth_from_world_ = world_from_depth_.transpose();
  world_origin_m_ = pose.translation_m.cast<float>();
  depth_origin_m_ = -(pose.rotation.transpose() * pose.translation_m).cast<float>();
  largest_radius2_ = static_cast<float>(widest_radius_squared(camera_));
  read(view);
  drop_stray(view);
  fill_holes();
  join();
  add_normals();
  weigh(view);
}

void ViewSurface::read(const StillView& view) {
  for (int y = 0; y < camera_.height; ++y) {
    for (int x = 0; x < camera_.width; ++x) {
      const float z_m = 0.001F * view.depth_mm(x, y);
      if (!(z_m > 0) || z_m > options_.max_range_m || !rays_.at(x, y).allFinite()) continue;
      Texel& texel = texels_.at(x, y);
      texel.inverse_m = 1 / z_m;
      texel.has_color = view.has_color(x, y);
      if (texel.has_color) texel.color = view.color(x, y);
    }
  }
}

bool ViewSurface::is_joined(int x, int y, int dx, int dy) const {
  const auto inverse = [&](int steps) {
    const int px = x + steps * dx, py = y + steps * dy;
    const bool inside = px >= 0 && py >= 0 && px < camera_.width && py < camera_.height;
    return inside ? texels_.at(px, py).inverse_m : 0.0F;
  };
  const float here = inverse(0), there = inverse(1);
  if (here == 0 || there == 0) return false;
  const float near_m = 1 / std::max(here, there), step_m = std::abs(1 / here - 1 / there);
  if (step_m < kStep_m + kStepPerDepth * near_m) return true;
  const float before = inverse(-1), after = inverse(2);
  if (before == 0 || after == 0 || step_m > kSlantedStepPerDepth * near_m) return false;
  const float allowed = kUnevenStep * std::abs(there - here);
  return std::abs(before - 2 * here + there) < allowed &&
         std::abs(here - 2 * there + after) < allowed;
}

void ViewSurface::join() {
  for (int y = 0; y < camera_.height; ++y) {
    for (int x = 0; x < camera_.width; ++x) {
      Texel& texel = texels_.at(x, y);
      texel.joins_right = is_joined(x, y, 1, 0);
      texel.joins_down = is_joined(x, y, 0, 1);
      const float joined =
          static_cast<float>(joined_neighbours(x, y, [](int, int) { return true; })) / 8;
      texel.rim = joined * joined;
    }
  }
}

template <class Counts>
int ViewSurface::joined_neighbours(int x, int y, const Counts& counts) const {
  int joined = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      joined += (dx != 0 || dy != 0) && is_joined(x, y, dx, dy) && counts(x + dx, y + dy);
  return joined;
}

/// Pixels that mix two surfaces have hardly any neighbour of one surface; what was hardly ever read
/// is believed only beside what was.
void ViewSurface::drop_stray(const StillView& view) {
  const auto all = [](int, int) { return true; };
  const auto sure = [&](int x, int y) { return view.is_sure(x, y); };
  Image<std::uint8_t> stray(camera_.width, camera_.height);
  for (int y = 0; y < camera_.height; ++y) {
    for (int x = 0; x < camera_.width; ++x) {
      if (texels_.at(x, y).inverse_m == 0) continue;
      stray.at(x, y) = joined_neighbours(x, y, all) < kMinJoined ||
                       (!view.is_sure(x, y) && joined_neighbours(x, y, sure) < kMinJoined);
    }
  }
  for (int y = 0; y < camera_.height; ++y)
    for (int x = 0; x < camera_.width; ++x)
      if (stray.at(x, y) != 0) texels_.at(x, y) = {};
}

/// Fills pixels without a reading within a surface, so that dark or slanted ones, which are read
/// now and then only, have no holes of a pixel or two.
void ViewSurface::fill_holes() {
  for (int pass = 0; pass < kFillPasses; ++pass) {
    const Image<Texel> before = texels_;
    for (int y = 1; y + 1 < camera_.height; ++y)
      for (int x = 1; x + 1 < camera_.width; ++x)
        if (before.at(x, y).inverse_m == 0 && rays_.at(x, y).allFinite()) fill_hole(x, y, before);
  }
}

/// From pairs of opposite neighbours: on a plane, inverse depth between them is their mean.
void ViewSurface::fill_hole(int x, int y, const Image<Texel>& before) {
  constexpr std::array<std::array<int, 2>, 4> kSides = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  float sum = 0, pairs = 0;
  for (const auto& [dx, dy] : kSides) {
    const Texel& a = before.at(x - dx, y - dy);
    const Texel& b = before.at(x + dx, y + dy);
    if (a.inverse_m == 0 || b.inverse_m == 0) continue;
    const float near_m = 1 / std::max(a.inverse_m, b.inverse_m);
    const float step_m = std::abs(1 / a.inverse_m - 1 / b.inverse_m);
    if (step_m > 2 * (kStep_m + kStepPerDepth * near_m)) return;
    sum += a.inverse_m + b.inverse_m;
    pairs += 1;
  }
  if (pairs < kMinFillPairs) return;
  texels_.at(x, y).inverse_m = sum / (2 * pairs);
}

Eigen::Vector3f ViewSurface::point(int x, int y) const {
  const Eigen::Vector2f& ray = rays_.at(x, y);
  return Eigen::Vector3f(ray.x(), ray.y(), 1) / texels_.at(x, y).inverse_m;
}

Eigen::Vector3f ViewSurface::world_point(int x, int y) const {
  return world_from_depth_ * point(x, y) + world_origin_m_;
}

/// The way along the surface through this pixel, over up to two pixels to either side.
std::optional<Eigen::Vector3f> ViewSurface::surface_step(int x, int y, int dx, int dy) const {
  const auto joins = [&](int from) {
    const int px = x + from * dx, py = y + from * dy;
    if (px < 0 || py < 0 || px + dx >= camera_.width || py + dy >= camera_.height) return false;
    return dx != 0 ? texels_.at(px, py).joins_right : texels_.at(px, py).joins_down;
  };
  int low = 0, high = 0;
  while (low > -2 && joins(low - 1)) --low;
  while (high < 2 && joins(high)) ++high;
  if (low == high) return std::nullopt;
  return (point(x + high * dx, y + high * dy) - point(x + low * dx, y + low * dy)).eval();
}

void ViewSurface::add_normals() {
  for (int y = 0; y < camera_.height; ++y) {
    for (int x = 0; x < camera_.width; ++x) {
      Texel& texel = texels_.at(x, y);
      if (texel.inverse_m == 0) continue;
      const Eigen::Vector3f at = point(x, y);
      const auto right = surface_step(x, y, 1, 0), down = surface_step(x, y, 0, 1);
      const Eigen::Vector3f facing = -at.normalized();
      Eigen::Vector3f normal = facing;  // where neighbours are missing
      if (right && down) normal = down->cross(*right).normalized();
      if (!normal.allFinite() || normal.dot(facing) < kMinSlope) {
        const Eigen::Vector3f along = normal.allFinite() ? normal : facing;
        normal = (along + (kMinSlope - along.dot(facing)) * facing).normalized();
      }
      texel.normal = normal;
      texel.plane_m = normal.dot(at);
    }
  }
}

void ViewSurface::weigh(const StillView& view) {
  for (int y = 0; y < camera_.height; ++y) {
    for (int x = 0; x < camera_.width; ++x) {
      Texel& texel = texels_.at(x, y);
      if (texel.inverse_m == 0) continue;
      const float z_m = depth_of(texel);
      const float noise_m = 0.001F * view.sigma_mm(1000 * z_m);
      const float bias_m = bias_at(z_m, options_);
      const float sigma_m = std::sqrt(
          noise_m * noise_m / static_cast<float>(std::max(1, view.count(x, y))) + bias_m * bias_m);
      const float wanted_m = std::max(options_.truncation_voxels * options_.voxel_m,
                                      options_.voxel_m + options_.truncation_sigmas * sigma_m);
      texel.truncation_m = std::min(wanted_m, kMaxTruncationVoxels * options_.voxel_m);
      const float facing = std::abs(texel.plane_m) / point(x, y).norm();
      const float exact = kWeightUnit_m / sigma_m;
      texel.weight = std::max(1e-6F, facing * texel.rim * exact * exact);
    }
  }
}

bool ViewSurface::project(const Eigen::Vector3f& point_m, float& u, float& v) const {
  if (!(point_m.z() > 0.05F)) return false;
  const float x = point_m.x() / point_m.z(), y = point_m.y() / point_m.z();
  const float r2 = x * x + y * y;
  if (!(r2 <= largest_radius2_)) return false;
  const CameraIntrinsics& c = camera_;
  const auto k1 = static_cast<float>(c.k1), k2 = static_cast<float>(c.k2),
             k3 = static_cast<float>(c.k3), p1 = static_cast<float>(c.p1),
             p2 = static_cast<float>(c.p2);
  const float radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const float dx = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x);
  const float dy = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y;
  u = static_cast<float>(c.fx) * dx + static_cast<float>(c.cx);
  v = static_cast<float>(c.fy) * dy + static_cast<float>(c.cy);
  return u > -0.5F && v > -0.5F && u < static_cast<float>(c.width) - 0.5F &&
         v < static_cast<float>(c.height) - 0.5F;
}

bool ViewSurface::is_quad(int x, int y) const {
  if (x < 0 || y < 0 || x + 1 >= camera_.width || y + 1 >= camera_.height) return false;
  const Texel& texel = texels_.at(x, y);
  return texel.joins_right && texel.joins_down && texels_.at(x + 1, y).joins_down &&
         texels_.at(x, y + 1).joins_right;
}

std::optional<ViewSample> ViewSurface::sample(const Eigen::Vector3f& world_m) const {
  const Eigen::Vector3f at = depth_from_world_ * world_m + depth_origin_m_;
  float u = 0, v = 0;
  if (!project(at, u, v)) return std::nullopt;
  const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
  const float fu = u - static_cast<float>(x), fv = v - static_cast<float>(y);
  const int nearest_x = std::clamp(x + (fu >= 0.5F), 0, camera_.width - 1);
  const int nearest_y = std::clamp(y + (fv >= 0.5F), 0, camera_.height - 1);
  const Texel& nearest = texels_.at(nearest_x, nearest_y);
  if (nearest.inverse_m == 0) return std::nullopt;
  const float exact = kWeightUnit_m / bias_at(at.z(), options_);
  ViewSample sample{0, nearest.truncation_m, nearest.weight, nearest.rim * exact * exact,
                    world_from_depth_ * nearest.normal};
  if (is_quad(x, y)) {
    const float above = (1 - fu) * texels_.at(x, y).inverse_m + fu * texels_.at(x + 1, y).inverse_m;
    const float below =
        (1 - fu) * texels_.at(x, y + 1).inverse_m + fu * texels_.at(x + 1, y + 1).inverse_m;
    const float surface_m = 1 / ((1 - fv) * above + fv * below);
    // Along the normal: the surface is nearly a plane here.
    const float slope = -nearest.normal.dot(at) / at.z();
    sample.distance_m = (surface_m - at.z()) * std::max(slope, kMinSlope);
  } else {
    sample.distance_m = nearest.normal.dot(at) - nearest.plane_m;
  }
  return sample;
}

bool ViewSurface::may_see(const Eigen::Vector3f& center_m, float radius_m) const {
  const Eigen::Vector3f at = depth_from_world_ * center_m + depth_origin_m_;
  if (at.z() + radius_m <= 0) return false;
  // The cone around the picture, widened by the ball.
  const float tangent = std::sqrt(largest_radius2_);
  const float cosine = 1 / std::sqrt(1 + largest_radius2_);
  return at.head<2>().norm() * cosine - at.z() * tangent * cosine <= radius_m;
}

std::optional<ViewSurface::Colored> ViewSurface::color(const Eigen::Vector3f& world_m,
                                                       float tolerance_m) const {
  const Eigen::Vector3f at = depth_from_world_ * world_m + depth_origin_m_;
  float u = 0, v = 0;
  if (!project(at, u, v)) return std::nullopt;
  const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float weights = 0, quality = 0;
  for (int y = std::max(top, 0); y <= std::min(top + 1, camera_.height - 1); ++y) {
    for (int x = std::max(left, 0); x <= std::min(left + 1, camera_.width - 1); ++x) {
      const Texel& texel = texels_.at(x, y);
      if (texel.inverse_m == 0 || !texel.has_color) continue;
      if (std::abs(texel.normal.dot(at) - texel.plane_m) > tolerance_m) continue;
      const float weight = std::max(1e-3F, (1 - std::abs(u - static_cast<float>(x))) *
                                               (1 - std::abs(v - static_cast<float>(y))));
      sum += weight * Eigen::Vector3f(texel.color.r, texel.color.g, texel.color.b);
      weights += weight;
      const float facing = std::abs(texel.plane_m) / at.norm();
      quality += weight * facing / at.squaredNorm();
    }
  }
  if (weights == 0) return std::nullopt;
  return Colored{sum / weights, quality / weights};
}

}  // namespace roomcast::model
