// SPDX-License-Identifier: Apache-2.0
// WatchedBlocks: decides which blocks of a sensor's next frame its viewers need, from the cones in
// which they see (WatchedFrom in docs/spec/wire.md §3). A block is needed less only if neither what
// it shows to decoders now nor what it would show can be seen. Outside all cones its depth is sent
// about once a second, and within one, on a surface that faces away from its viewer, twice, with
// its colour every fourth time; where a surface is seen edge-on, in frames of layer 0. Where a
// surface has gone from within a cone its depth is needed, whichever way it faced: it would go on
// standing before what the viewer sees. Pure; allocates nothing after the first frame.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "roomcast/codec/payload/block_need.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/view_cone.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::sensor {

struct WatchedBlocksOptions {
  float at_hand_m = 0.3F;  // nearer surfaces are seen, wherever the viewer looks
  float edge_on_rad =
      1.2F;               // seen at a larger angle to their normal, surfaces take little of a view
  float away_rad = 1.9F;  // at a larger one they face away: a right angle, and a margin
  int jump_mm = 100;      // by more, a block shows another surface
  double references_per_s = 7.5;  // frames of layer 0
  // So often the depth of a block comes that is outside all cones, or that faces away.
  double outside_every_s = 1, away_every_s = 0.5;
};

class WatchedBlocks {
 public:
  explicit WatchedBlocks(const CameraIntrinsics& depth, WatchedBlocksOptions options = {});

  /// `watched` has passed wire::decode_control. Without cones, everything is needed.
  void watch_from(const wire::pb::WatchedFrom& watched);
  [[nodiscard]] bool watches_all() const { return views_.empty(); }

  /// What is needed of the next frame, whose depth is `now_mm`, while decoders show `shown_mm`;
  /// valid until the next call. Empty: everything. One frame in `frames_per_reference` is of layer
  /// 0. Both views have the camera's size; `shown_mm` may be empty: nothing yet.
  [[nodiscard]] codec::BlockNeedsView update(DepthView now_mm, DepthView shown_mm,
                                             int frames_per_reference);

 private:
  /// The nearest and the farthest reading of a block; 0: none.
  struct Reach {
    std::uint16_t near_mm = 0, far_mm = 0;
    [[nodiscard]] bool is_known() const { return near_mm != 0; }
  };
  enum class Sight : std::uint8_t { kOutside, kAway, kEdgeOn, kSeen };

  void measure(DepthView depth_mm, std::vector<Reach>& blocks) const;
  [[nodiscard]] bool is_known(std::size_t block) const;
  [[nodiscard]] codec::BlockNeed need_of(int column, int row) const;
  [[nodiscard]] codec::BlockNeed need_around(int column, int row) const;
  [[nodiscard]] Sight sight_of(std::size_t block, std::uint16_t z_mm,
                               const Eigen::Vector3f& normal) const;
  [[nodiscard]] Eigen::Vector3f normal_of(const std::vector<Reach>& blocks, int column,
                                          int row) const;
  [[nodiscard]] Eigen::Vector3f point(std::size_t block, std::uint16_t z_mm) const;
  [[nodiscard]] codec::BlockNeed turn_of(int row, int every) const;
  [[nodiscard]] std::size_t index(int column, int row) const;

  const WatchedBlocksOptions options_;
  const int outside_every_, away_every_;  // references
  const float edge_on_, away_;            // cosines
  int wide_ = 0, high_ = 0;
  std::vector<Eigen::Vector2f> rays_;  // of the blocks' middles, at z = 1; NaN: none
  float radius_ = 0;                   // of a block, at z = 1
  std::vector<ViewBounds> views_;
  std::vector<Reach> now_, shown_;
  codec::BlockNeeds needs_;
  unsigned frame_ = 0, reference_ = 0;
};

}  // namespace roomcast::sensor
