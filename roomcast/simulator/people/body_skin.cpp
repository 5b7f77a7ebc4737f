// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/body_skin.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "roomcast/simulator/people/surface_net.h"
#include "roomcast/simulator/scene/angles.h"

namespace roomcast::simulator {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

/// Bones that share one cloth and are collinear in the cutting pose, such as a leg or an arm.
struct ClothCylinder {
  Bone first;      // the cloth uses its frame
  float radius_m;  // radius of the cylinder that the cloth is wrapped around
};

ClothCylinder cylinder_of(Bone bone) {
  switch (bone) {
    case Bone::kPelvis:
    case Bone::kChest:
      return {Bone::kPelvis, 0.155F};
    case Bone::kHead:
      return {Bone::kHead, 0.085F};
    case Bone::kLeftUpperArm:
    case Bone::kLeftForearm:
      return {Bone::kLeftUpperArm, 0.05F};
    case Bone::kRightUpperArm:
    case Bone::kRightForearm:
      return {Bone::kRightUpperArm, 0.05F};
    case Bone::kLeftThigh:
    case Bone::kLeftShin:
      return {Bone::kLeftThigh, 0.075F};
    case Bone::kRightThigh:
    case Bone::kRightShin:
      return {Bone::kRightThigh, 0.075F};
    case Bone::kLeftHand:
    case Bone::kRightHand:
    case Bone::kLeftFoot:
    case Bone::kRightFoot:
      return {bone, 0.045F};
  }
  return {bone, 0.05F};
}

float length_of(Bone bone, const Measures& m) {
  switch (bone) {
    case Bone::kPelvis:
      return -m.waist;
    case Bone::kChest:
      return -m.shoulder;
    case Bone::kHead:
      return -0.18F * m.scale;
    case Bone::kLeftUpperArm:
    case Bone::kRightUpperArm:
      return m.upper_arm;
    case Bone::kLeftForearm:
    case Bone::kRightForearm:
      return m.forearm;
    case Bone::kLeftThigh:
    case Bone::kRightThigh:
      return m.thigh;
    case Bone::kLeftShin:
    case Bone::kRightShin:
      return m.shin;
    case Bone::kLeftHand:
    case Bone::kRightHand:
      return 0.18F * m.scale;
    case Bone::kLeftFoot:
    case Bone::kRightFoot:
      return 0.05F * m.scale;
  }
  return 0.1F;
}

float distance_to_bone(const Vector3f& at, Bone bone, const Pose& cutting, const Measures& m) {
  const Vector3f local = cutting.of(bone).inverse() * at;
  const float end = -length_of(bone, m);
  const float along = std::clamp(local.y(), std::min(0.0F, end), std::max(0.0F, end));
  return (local - Vector3f(0, along, 0)).norm();
}

/// Relative thickness of a bone: a trunk bone is farther from its skin than an arm bone.
float thickness(Bone bone) {
  return bone == Bone::kPelvis || bone == Bone::kChest ? 2.0F : 1.0F;
}

/// Share of the surroundings that the body itself does not hide from a point: growth of the
/// distance to the body along the normal (Evans 2006).
float openness_at(const std::vector<BodyPiece>& pieces, const Vector3f& at,
                  const Vector3f& normal) {
  float hidden = 0.0F, weight = 1.0F;
  for (const float step_m : {0.03F, 0.07F, 0.14F}) {
    float nearest = step_m;
    for (const BodyPiece& piece : pieces)
      nearest = std::min(nearest, piece.solid.distance(at + step_m * normal));
    hidden += weight * std::max(0.0F, step_m - nearest) / step_m;
    weight *= 0.6F;
  }
  return std::clamp(1.0F - 0.5F * hidden, 0.25F, 1.0F);
}

}  // namespace

BodySkin::BodySkin(const Build& build, const Outfit& outfit, const Measures& measures) {
  const Pose cutting = cutting_pose(measures);
  for (std::size_t i = 0; i < kBoneCount; ++i)
    bone_from_cutting_[i] = cutting.world_from_bone[i].inverse();
  const auto pieces = body_pieces(build, outfit, cutting, measures);
  for (const BodyPiece& piece : pieces) add_piece(piece, pieces, cutting, measures);
}

BodySkin::Hold BodySkin::hold_of(const Vector3f& at, const std::vector<Bone>& bones,
                                 const Pose& cutting, const Measures& measures) {
  std::vector<std::pair<float, Bone>> pulls;
  for (const Bone bone : bones) {
    const float away = distance_to_bone(at, bone, cutting, measures) / thickness(bone);
    pulls.emplace_back(std::pow(std::max(away, 0.004F), -7.0F), bone);
  }
  std::sort(pulls.begin(), pulls.end(),
            [](const auto& a, const auto& b) { return a.first > b.first; });
  if (pulls.size() > kMaxBones) pulls.resize(kMaxBones);
  float sum = 0.0F;
  for (const auto& [pull, bone] : pulls) sum += pull;
  Hold hold{};
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    hold.bone[i] = static_cast<std::uint8_t>(pulls[i].second);
    hold.share[i] = pulls[i].first / sum;
  }
  return hold;
}

void BodySkin::add_piece(const BodyPiece& piece, const std::vector<BodyPiece>& all,
                         const Pose& cutting, const Measures& measures) {
  const SurfaceNet net = surface_net(piece.solid, piece.cell_m * measures.scale);
  std::vector<Hold> holds;
  std::vector<Vector3f> normals;
  std::vector<float> open;
  for (const Vector3f& at : net.positions) {
    holds.push_back(hold_of(at, piece.bones, cutting, measures));
    normals.push_back(piece.solid.outward(at));
    open.push_back(openness_at(all, at, normals.back()));
  }
  MovingPart part;
  part.first_vertex = static_cast<std::uint32_t>(mesh_.positions.size());
  part.first_triangle = static_cast<std::uint32_t>(mesh_.triangles.size());

  // A vertex is copied for each cloth it belongs to and each side of that cloth's seam.
  std::map<std::tuple<std::uint32_t, Bone, int>, std::uint32_t> copies;
  const auto vertex = [&](std::uint32_t number, const ClothCylinder& cylinder, float middle_angle) {
    const Vector3f local = cutting.of(cylinder.first).inverse() * net.positions[number];
    const float angle = std::atan2(local.x(), local.z());
    const int wrap = static_cast<int>(std::lround((middle_angle - angle) / (2.0F * kPi)));
    const auto [copy, is_new] = copies.try_emplace(
        {number, cylinder.first, wrap}, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) {
      const float around = angle + 2.0F * kPi * static_cast<float>(wrap);
      mesh_.positions.push_back(net.positions[number]);
      mesh_.normals.push_back(normals[number]);
      mesh_.uv_m.emplace_back(cylinder.radius_m * around, local.y());
      openness_.push_back(open[number]);
      holds_.push_back(holds[number]);
    }
    return copy->second;
  };
  for (const auto& quad : net.quads) {
    const ClothCylinder cylinder = cylinder_of(static_cast<Bone>(holds[quad[0]].bone[0]));
    const Vector3f middle = 0.25F * (net.positions[quad[0]] + net.positions[quad[1]] +
                                     net.positions[quad[2]] + net.positions[quad[3]]);
    const Vector3f local = cutting.of(cylinder.first).inverse() * middle;
    const float angle = std::atan2(local.x(), local.z());
    std::array<std::uint32_t, 4> corner{};
    for (std::size_t i = 0; i < 4; ++i) corner[i] = vertex(quad[i], cylinder, angle);
    mesh_.triangles.push_back({corner[0], corner[1], corner[2]});
    mesh_.triangles.push_back({corner[0], corner[2], corner[3]});
    mesh_.surface.insert(mesh_.surface.end(), 2, piece.surface);
  }
  part.vertex_count = static_cast<std::uint32_t>(mesh_.positions.size()) - part.first_vertex;
  part.triangle_count = static_cast<std::uint32_t>(mesh_.triangles.size()) - part.first_triangle;
  pieces_.push_back(part);
}

void BodySkin::bend(const Pose& pose, TriangleMesh& out, std::size_t first) const {
  std::array<Eigen::Matrix<float, 3, 4>, kBoneCount> moves;
  for (std::size_t i = 0; i < kBoneCount; ++i)
    moves[i] = (pose.world_from_bone[i] * bone_from_cutting_[i]).matrix().topRows<3>();
  for (std::size_t i = 0; i < holds_.size(); ++i) {
    const Hold& hold = holds_[i];
    Eigen::Matrix<float, 3, 4> move = hold.share[0] * moves[hold.bone[0]];
    for (std::size_t k = 1; k < kMaxBones; ++k) {
      if (hold.share[k] > 0.0F) move += hold.share[k] * moves[hold.bone[k]];
    }
    out.positions[first + i] = move.leftCols<3>() * mesh_.positions[i] + move.col(3);
    out.normals[first + i] = (move.leftCols<3>() * mesh_.normals[i]).normalized();
  }
}

}  // namespace roomcast::simulator
