// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/solid.h"

#include <algorithm>
#include <cmath>

#include "roomcast/core/assert.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::Isometry3f;
using Eigen::Matrix3f;
using Eigen::Vector3f;

/// Smooth minimum of two distances: rounded where they differ by less than `blend`.
float smooth_minimum(float a, float b, float blend) {
  const float h = std::max(0.0F, blend - std::abs(a - b)) / blend;
  return std::min(a, b) - 0.25F * h * h * blend;
}

}  // namespace

void Solid::add(const Isometry3f& frame, const Bar& bar) {
  const Vector3f along = bar.to_m - bar.from_m;
  const Vector3f up = along.normalized();
  const Vector3f hint = std::abs(up.z()) < 0.9F ? Vector3f::UnitZ() : Vector3f::UnitY();
  const Vector3f side = up.cross(hint).normalized();
  Matrix3f axes;
  axes << side * bar.flat.x(), up, side.cross(up) * bar.flat.y();
  Affine3f local = Affine3f::Identity();
  local.linear() = axes;
  local.translation() = bar.from_m;

  Part part{};
  part.local_from_world = (frame * local).inverse();
  part.from_radius = bar.from_radius_m;
  part.to_radius = bar.to_radius_m;
  part.length = along.norm();
  part.sine = (bar.from_radius_m - bar.to_radius_m) / part.length;
  ROOMCAST_ASSERT(std::abs(part.sine) < 1.0F);
  part.cosine = std::sqrt(1.0F - part.sine * part.sine);
  part.blend = bar.blend_m;
  part.smallest_scale = std::min({1.0F, bar.flat.x(), bar.flat.y()});
  parts_.push_back(part);

  const float widest =
      std::max(bar.from_radius_m, bar.to_radius_m) * std::max({1.0F, bar.flat.x(), bar.flat.y()});
  for (const Vector3f& end : {bar.from_m, bar.to_m}) {
    box_.extend(Vector3f(frame * end + Vector3f::Constant(widest)));
    box_.extend(Vector3f(frame * end - Vector3f::Constant(widest)));
  }
}

void Solid::cut(const Vector3f& point, const Vector3f& normal, float reach_m) {
  cuts_.push_back({point, normal.normalized(), reach_m});
}

float Solid::distance_to(const Part& part, const Vector3f& at) {
  const Vector3f local = part.local_from_world * at;
  const float out = std::hypot(local.x(), local.z());
  const float level = part.cosine * local.y() - part.sine * out;
  float distance = 0.0F;
  if (level < 0.0F) {
    distance = local.norm() - part.from_radius;
  } else if (level > part.length * part.cosine) {
    distance = std::hypot(out, local.y() - part.length) - part.to_radius;
  } else {
    distance = part.cosine * out + part.sine * local.y() - part.from_radius;
  }
  return distance * part.smallest_scale;
}

float Solid::distance(const Vector3f& at) const {
  float nearest = 1e3F;
  for (const Part& part : parts_)
    nearest = smooth_minimum(nearest, distance_to(part, at), part.blend);
  for (const Cut& cut : cuts_) {
    const Vector3f way = at - cut.point;
    nearest = std::max(nearest, std::min(cut.normal.dot(way), cut.reach - way.norm()));
  }
  return nearest;
}

Vector3f Solid::outward(const Vector3f& at) const {
  constexpr float kStep_m = 0.002F;
  Vector3f slope;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3f step = kStep_m * Vector3f::Unit(axis);
    slope[axis] = distance(at + step) - distance(at - step);
  }
  return slope.norm() > 1e-9F ? Vector3f(slope.normalized()) : Vector3f(Vector3f::UnitY());
}

}  // namespace roomcast::simulator
