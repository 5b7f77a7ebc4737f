// SPDX-License-Identifier: Apache-2.0
// What a sensor saw at single instants, coarsely: depth in blocks of 4 x 4 pixels, and which of
// them are covered by something that moves. People and what they carry occur once and are never in
// two places: seen at the same instant by two sensors they tell a pose from its half turns and from
// its repeats, where everything that stands still looks alike. Thread-safe (no state).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/core/option_fields.h"

namespace roomcast::alignment {

inline constexpr int kInstantBlock = 4;  // pixels
/// Fewer are noise; a head 3 m away covers about as many.
inline constexpr std::size_t kMinMovingBlocks = 12;

struct DepthInstant {
  double time_s = 0;    // on a clock that the sensors of a rig share
  DepthImage depth_mm;  // medians of blocks; 0 where less than half of a block has readings
  MaskImage moving;     // 255: in front of what is seen there at other instants
};

/// By hand: a person is further than that from a wall behind, and hides it in less than so many
/// instants.
struct DepthInstantOptions {
  // Nearer than the background by more: moving. A constant, and a share of the depth.
  double before_m = 0.1, before_per_depth = 0.03;
  double background_rank = 0.9;  // of a block's readings, from the nearest: its background
  int min_neighbours = 4;        // of eight that move too, so that edges do not count

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("before_m", before_m, Range{0, 10});
    visit("before_per_depth", before_per_depth, Range{0, 1});
    visit("background_rank", background_rank, Range{0, 1});
    visit("min_neighbours", min_neighbours, Range{0, 8});
  }
  [[nodiscard]] Status check() const { return check_fields("DepthInstantOptions", *this); }
};

/// Medians of the picture's blocks; 0 where less than half of a block has readings.
[[nodiscard]] DepthImage depth_in_blocks(const DepthImage& picture_mm);

/// 255 where a block is in front of the background, also alone: a first look at what moves. The
/// pictures are of one size, in blocks.
[[nodiscard]] MaskImage in_front_of(const DepthImage& blocks_mm, const DepthImage& background_mm,
                                    const DepthInstantOptions& options = {});

/// Whether at least kMinMovingBlocks of the mask are set.
[[nodiscard]] bool shows_motion(const MaskImage& mask);

/// Sets `moving` of all instants by their depth, which is of one size.
void mark_moving(std::span<DepthInstant> instants, const DepthInstantOptions& options = {});

/// One for each picture, in order. `times_s` has as many elements; the pictures are of one size.
[[nodiscard]] std::vector<DepthInstant> depth_instants(std::span<const DepthImage> pictures_mm,
                                                       std::span<const double> times_s,
                                                       const DepthInstantOptions& options = {});

}  // namespace roomcast::alignment
