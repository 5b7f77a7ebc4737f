// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/openness_map.h"

#include <algorithm>
#include <cmath>

#include "roomcast/source/simulator/parallel_rows.h"

namespace roomcast::sim {
namespace {

constexpr int kSpacing = 4;  // pixels

}  // namespace

OpennessMap::OpennessMap(const RayScene& scene, const RigidTransform& world_from_camera,
                         ImageView<const Eigen::Vector2f> rays)
    : scene_(scene),
      nodes_((rays.width + kSpacing - 1) / kSpacing, (rays.height + kSpacing - 1) / kSpacing) {
  const Eigen::Matrix3f rotation = world_from_camera.rotation.cast<float>();
  const Eigen::Vector3f eye = world_from_camera.translation_m.cast<float>();
  for_each_row(nodes_.height(), [&](int j) {
    for (int i = 0; i < nodes_.width(); ++i) {
      const Eigen::Vector3f direction = rotation * rays.at(i * kSpacing, j * kSpacing).homogeneous();
      const auto hit = scene_.first_hit(eye, direction);
      if (!hit) continue;
      Node& node = nodes_.at(i, j);
      node.point = {eye + hit->t * direction, hit->normal};
      node.openness = openness_at(scene_, node.point);
    }
  });
}

float OpennessMap::at(int x, int y, const LitPoint& point) const {
  constexpr float kEnough = 0.02F;
  float weights = 0.0F;
  float sum = 0.0F;
  for (int corner = 0; corner < 4; ++corner) {
    const int i = std::min(x / kSpacing + (corner & 1), nodes_.width() - 1);
    const int j = std::min(y / kSpacing + (corner >> 1), nodes_.height() - 1);
    const Node& node = nodes_.at(i, j);
    if (node.openness < 0.0F) continue;
    const float across = 1.0F - std::abs(static_cast<float>(x - i * kSpacing)) / kSpacing;
    const float down = 1.0F - std::abs(static_cast<float>(y - j * kSpacing)) / kSpacing;
    const float same_way = std::max(0.0F, node.point.normal.dot(point.normal));
    const float off_plane = point.normal.dot(node.point.position_m - point.position_m) / 0.02F;
    const float apart_m = (node.point.position_m - point.position_m).norm();
    const float alike = std::pow(same_way, 8.0F) / (1.0F + off_plane * off_plane + 10.0F * apart_m);
    const float weight = (std::max(0.0F, across * down) + 0.01F) * alike;
    weights += weight;
    sum += weight * node.openness;
  }
  return weights > kEnough ? sum / weights : openness_at(scene_, point);
}

}  // namespace roomcast::sim
