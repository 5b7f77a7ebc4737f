// SPDX-License-Identifier: Apache-2.0
// BodySkin: the surface mesh of a person: modelled once in the cutting pose, then deformed with the
// bones. Every vertex follows up to three bones (linear blend skinning: Magnenat-Thalmann et al.
// 1988). Pieces are runs of vertices and triangles of one mesh. Metres.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "roomcast/simulator/people/body_solids.h"
#include "roomcast/simulator/people/moving_things.h"

namespace roomcast::simulator {

class BodySkin {
 public:
  BodySkin(const Build& build, const Outfit& outfit, const Measures& measures);

  /// The mesh in the cutting pose.
  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<float>& openness() const { return openness_; }
  [[nodiscard]] const std::vector<MovingPart>& pieces() const { return pieces_; }

  /// Writes the positions and normals of a pose to `out`, starting at vertex `first`.
  void bend(const Pose& pose, TriangleMesh& out, std::size_t first) const;

 private:
  static constexpr std::size_t kMaxBones = 3;
  struct Hold {
    std::array<std::uint8_t, kMaxBones> bone;
    std::array<float, kMaxBones> share;
  };
  void add_piece(const BodyPiece& piece, const std::vector<BodyPiece>& all, const Pose& cutting,
                 const Measures& measures);
  [[nodiscard]] static Hold hold_of(const Eigen::Vector3f& at, const std::vector<Bone>& bones,
                                    const Pose& cutting, const Measures& measures);

  TriangleMesh mesh_;
  std::vector<float> openness_;
  std::vector<Hold> holds_;
  std::vector<MovingPart> pieces_;
  std::array<Eigen::Isometry3f, kBoneCount> bone_from_cutting_;
};

}  // namespace roomcast::simulator
