// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/people/round_cone.h"

#include <cmath>
#include <limits>

#include "roomcast/core/assert.h"

namespace roomcast::sim {
namespace {

using Eigen::Vector3f;

constexpr float kNever = std::numeric_limits<float>::infinity();

/// Where a t^2 + 2 b t + c falls below zero: entering what the quadratic describes.
float entering_root(float a, float b, float c) {
  const float discriminant = b * b - a * c;
  if (discriminant < 0.0F || std::abs(a) < 1e-12F) return kNever;
  return (-b - std::sqrt(discriminant)) / a;
}

float ball_entry(const Vector3f& from_centre, const Vector3f& direction, float radius) {
  return entering_root(direction.squaredNorm(), from_centre.dot(direction),
                       from_centre.squaredNorm() - radius * radius);
}

}  // namespace

RoundCone::RoundCone(float first_radius_m, float second_radius_m, float length_m)
    : first_radius_(first_radius_m), second_radius_(second_radius_m), length_(length_m) {
  const float sine = (first_radius_ - second_radius_) / length_;
  ROOMCAST_ASSERT(std::abs(sine) < 1.0F);
  const float cosine = std::sqrt(1.0F - sine * sine);
  slope_ = sine / cosine;
  intercept_ = first_radius_ / cosine;
  low_ = first_radius_ * sine;
  high_ = length_ + second_radius_ * sine;
}

std::optional<float> RoundCone::entry(const Vector3f& origin, const Vector3f& direction) const {
  const float width = intercept_ - slope_ * origin.y();
  const float a = direction.x() * direction.x() + direction.z() * direction.z() -
                  slope_ * slope_ * direction.y() * direction.y();
  const float b =
      origin.x() * direction.x() + origin.z() * direction.z() + slope_ * direction.y() * width;
  const float c = origin.x() * origin.x() + origin.z() * origin.z() - width * width;
  if (a > 0.0F && b * b < a * c) return std::nullopt;  // both balls lie inside the endless cone
  const float on_cone = entering_root(a, b, c);
  const float cone_y = origin.y() + on_cone * direction.y();
  if (on_cone > 0.0F && cone_y >= low_ && cone_y <= high_) return on_cone;

  const float on_first = ball_entry(origin, direction, first_radius_);
  if (on_first > 0.0F && on_first < kNever && origin.y() + on_first * direction.y() <= low_)
    return on_first;
  const Vector3f from_second(origin.x(), origin.y() - length_, origin.z());
  const float on_second = ball_entry(from_second, direction, second_radius_);
  if (on_second > 0.0F && on_second < kNever && origin.y() + on_second * direction.y() >= high_) {
    return on_second;
  }
  return std::nullopt;
}

Vector3f RoundCone::normal_at(const Vector3f& point) const {
  if (point.y() < low_) return point;
  if (point.y() > high_) return {point.x(), point.y() - length_, point.z()};
  return {point.x(), slope_ * (intercept_ - slope_ * point.y()), point.z()};
}

}  // namespace roomcast::sim
