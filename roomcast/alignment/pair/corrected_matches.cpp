// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/corrected_matches.h"

namespace roomcast::alignment {
namespace {

Eigen::Vector3f corrected(const ColorPicture& picture, const Eigen::Vector2f& shift_px,
                          const Eigen::Vector3f& point_m) {
  const float z = picture.in_color_frame(point_m).z();
  const Eigen::Vector3f in_color(z * shift_px.x() / picture.camera.fx,
                                 z * shift_px.y() / picture.camera.fy, 0);
  return point_m + picture.color_from_depth_rotation.transpose() * in_color;
}

}  // namespace

std::vector<PointMatch> corrected_matches(std::span<const PointMatch> matches,
                                          const ColorPicture& a, const ColorPicture& b,
                                          const PairState& state) {
  const Eigen::Vector2f of_a = state.a.color_shift_px.cast<float>();
  const Eigen::Vector2f of_b = state.b.color_shift_px.cast<float>();
  std::vector<PointMatch> moved(matches.begin(), matches.end());
  for (PointMatch& match : moved) {
    match.a_m = corrected(a, of_a, match.a_m);
    match.b_m = corrected(b, of_b, match.b_m);
  }
  return moved;
}

}  // namespace roomcast::alignment
