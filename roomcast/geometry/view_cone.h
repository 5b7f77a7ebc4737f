// SPDX-License-Identifier: Apache-2.0
// ViewCone: what an eye sees: everything within an angle of a direction or, with a rectangular
// picture, the part of it that the picture's four sides bound. ViewBounds: whether points are in
// it. Pure.
#pragma once

#include <Eigen/Core>

namespace roomcast {

/// How far a view reaches from its axis, radians.
struct ViewAngles {
  double half_angle_rad = 0;  // the largest angle between the axis and a direction that is seen
  /// To either side, and up and down: the largest angles between the axis and such a direction as
  /// it is seen from above and from the side. 0: no less than half_angle_rad.
  double half_width_rad = 0, half_height_rad = 0;

  friend bool operator==(const ViewAngles&, const ViewAngles&) = default;
};

struct ViewCone {
  Eigen::Vector3f eye_m;
  Eigen::Vector3f forward;  // unit vector
  ViewAngles angles;
  Eigen::Vector3f up =
      Eigen::Vector3f::Zero();  // unit vector across `forward`; 0: the view is round
};

/// A ViewCone, prepared for many points.
class ViewBounds {
 public:
  /// With a margin around the view, by which all its angles grow.
  explicit ViewBounds(const ViewCone& cone, float beside_rad = 0);

  [[nodiscard]] const Eigen::Vector3f& eye_m() const { return eye_m_; }
  /// How far a point is from the view, in metres; outside of a corner this may be less than the
  /// distance. 0 or less: the point is within. `away_m`: from the eye to the point.
  [[nodiscard]] float distance_outside(const Eigen::Vector3f& away_m) const;

 private:
  struct Angle {
    explicit Angle(double radians);
    float sine, cosine;
  };

  Eigen::Vector3f eye_m_, forward_, up_, right_;
  Angle corner_, side_, top_;
  bool has_sides_, has_top_;
};

}  // namespace roomcast
