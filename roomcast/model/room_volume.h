// SPDX-License-Identifier: Apache-2.0
// RoomVolume: the signed distances from the fused surfaces (TSDF; Curless & Levoy 1996), positive
// in front of them, in blocks of 8x8x8 cells wherever a surface passes and nowhere else. The blocks
// are a function of the views alone: a view that changes, moves or is withdrawn changes the blocks
// that it sees and leaves no trace in them. Metres, world frame. Plain data.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>

#include <Eigen/Core>

#include "roomcast/core/parallel_rows.h"
#include "roomcast/core/result.h"
#include "roomcast/model/model_options.h"
#include "roomcast/model/view_surface.h"

namespace roomcast::model {

inline constexpr int kBlockCells = 8, kBlockCorners = kBlockCells + 1;  // on an edge

/// Position of a block, in blocks; of a corner of cells, in voxels.
struct GridPlace {
  std::int32_t x = 0, y = 0, z = 0;
  friend auto operator<=>(const GridPlace&, const GridPlace&) = default;
};

/// Distances at the corners of a block's cells, those of its far sides included, so that each block
/// can be meshed by itself.
struct VolumeBlock {
  GridPlace place;
  std::array<std::int16_t, kBlockCorners * kBlockCorners * kBlockCorners> distances;

  static constexpr std::int16_t kUnknown = INT16_MIN;
  /// Hidden behind a surface: inside, but how far is not known.
  static constexpr std::int16_t kHidden = INT16_MIN + 1;
  static constexpr float kUnitsPerVoxel = 2048;
  static constexpr std::size_t index(int x, int y, int z) {
    return static_cast<std::size_t>((z * kBlockCorners + y) * kBlockCorners + x);
  }
  [[nodiscard]] std::int16_t at(int x, int y, int z) const { return distances[index(x, y, z)]; }
};

struct RoomVolume {
  float voxel_m = 0.01F;
  std::deque<VolumeBlock> blocks;  // by place

  [[nodiscard]] std::size_t bytes() const { return blocks.size() * sizeof(VolumeBlock); }
};

/// Fuses views. `progress` (may be empty) gets done and total blocks, on the calling thread's or a
/// worker's turn, one call at a time. kTooLarge, with the remedy, if the blocks need more than
/// options.max_bytes; kClosed if a stop was requested; kInvalidArgument as ModelOptions::check.
[[nodiscard]] Result<RoomVolume> fuse_views(
    std::span<const ViewSurface> views, const ModelOptions& options, const Workers& workers = {},
    const std::function<void(std::size_t done, std::size_t total)>& progress = {});

/// Whether no surface is between two neighbouring corners although one is inside: beyond the
/// outline of a thing, free space is beside what is hidden behind the thing. The outline itself,
/// where the inner corner is just behind the surface or the outer one just before it, belongs to
/// it.
[[nodiscard]] constexpr bool is_step(std::int16_t a, std::int16_t b) {
  constexpr int kVoxel = static_cast<int>(VolumeBlock::kUnitsPerVoxel);
  const int inner = a < b ? a : b, outer = a < b ? b : a;
  if (outer < 0) return false;
  if (inner == VolumeBlock::kHidden) return outer >= kVoxel;
  return inner < -kVoxel && 2 * outer > 5 * kVoxel;
}

/// How far the surface is from the first of two neighbouring corners on its two sides, as a share
/// of the way to the second.
[[nodiscard]] float crossing(std::int16_t from, std::int16_t to);

/// Bit i says whether corner i of a cell is inside; 0 for a cell that the surface does not pass
/// through, or that is not known well enough.
[[nodiscard]] int cube_of_cell(const VolumeBlock& block, int x, int y, int z);

}  // namespace roomcast::model
