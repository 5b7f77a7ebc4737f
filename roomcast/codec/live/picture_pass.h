// SPDX-License-Identifier: Apache-2.0
// One pass over the blocks of a live depth picture: codes each block and applies it. One template
// is both writer and reader, so that encoder and decoder cannot disagree. docs/spec/codec.md
// §2.4.2.
//
// Background after long-term reference pictures (H.264 Annex; Wiegand 1999), here per block.
#pragma once

#include <cstring>
#include <vector>

#include "roomcast/codec/live/block_code.h"
#include "roomcast/codec/live/label_coding.h"
#include "roomcast/codec/live/live_state.h"
#include "roomcast/codec/live/state_hash.h"
#include "roomcast/codec/live/surface_coding.h"

namespace roomcast::codec {

inline constexpr int kStaticFrames =
    20;  // after so many unchanged frames a block becomes background
inline constexpr int kRefinementStep = 6;  // levels
inline constexpr int kReadingStep = 2;     // levels

/// Memory that a pass needs, kept from frame to frame.
struct PassScratch {
  std::vector<BlockTrace> trace;        // of the blocks of this frame
  LabelPlane labels;                    // of this frame's pixels
  std::vector<std::uint16_t> shown_mm;  // the decoded frame if it is no reference

  void resize(const LiveState& state) {
    trace.resize(state.grid.block_count());
    labels.resize(state.grid);
  }
};

template <class Coder>
class PicturePass {
 public:
  /// `step` is the quantiser's, in levels. A pass over a `reference` frame changes the state; any
  /// other pass changes only `shown_mm`, which must contain the reference picture.
  PicturePass(LiveState& state, PassScratch& scratch, LiveContexts& contexts, Coder& coder,
              int step, bool reference, std::uint16_t* shown_mm)
      : state_(state),
        scratch_(scratch),
        contexts_(contexts),
        coder_(coder),
        step_(step),
        reference_(reference),
        shown_mm_(shown_mm),
        hash_(state.hash) {
    scratch.labels.clear();
  }

  /// Codes one block; call in raster order, once for each. A reader fills in `code`.
  void block(const BlockView& here, BlockCode& code) {
    here_ = here;
    if (!code_activity(code)) return skip();
    BlockTrace& trace = scratch_.trace[here_.index()];
    trace = {};
    trace.activity = BlockActivity::kMixed;
    if (code.mode == BlockMode::kRefine) {
      code_refinement(code);
    } else if (code.mode == BlockMode::kRaw) {
      code_readings(code);
    } else {
      code_surfaces(code, trace);
      code_labels(code, trace);
    }
    if (reference_ && code.mode != BlockMode::kRefine) state_.static_age[here_.index()] = 0;
    store();
  }

  /// Call after the last block.
  void finish() {
    if (reference_) {
      std::swap(state_.trace, scratch_.trace);
      state_.hash = hash_.value();
    }
  }
  [[nodiscard]] std::uint32_t hash() const { return hash_.value(); }
  /// What may predict surface `which` (0, 1) of a block that is not coded yet.
  [[nodiscard]] SurfaceCandidates candidates(const BlockView& here, std::size_t which) const {
    return surface_candidates(state_, scratch_.trace, here, which, last_[which]);
  }

 private:
  bool code_activity(BlockCode& code) {
    if (!coder_.bit(contexts_.active[activity_context()], code.mode != BlockMode::kSkip)) {
      code.mode = BlockMode::kSkip;
      return false;
    }
    if (coder_.bit(contexts_.labelled, code.mode == BlockMode::kLabels)) {
      code.mode = BlockMode::kLabels;
    } else if (coder_.bit(contexts_.raw, code.mode == BlockMode::kRaw)) {
      code.mode = BlockMode::kRaw;
    } else {
      code.mode = BlockMode::kRefine;
    }
    return true;
  }
  [[nodiscard]] std::size_t activity_context() const {
    const auto activity = [](const BlockTrace& t) { return static_cast<std::size_t>(t.activity); };
    const auto &before = state_.trace, &now = scratch_.trace;
    std::size_t context = 18 * activity(before[here_.index()]);
    if (here_.has_left()) context += 2 * activity(now[here_.left()]);
    if (here_.has_above()) context += 6 * activity(now[here_.above()]);
    const bool right = here_.has_right() && activity(before[here_.right()]) != 0;
    const bool below = here_.has_below() && activity(before[here_.below()]) != 0;
    return context + (right || below);
  }

  void skip() {
    scratch_.trace[here_.index()] = {};
    if (!reference_) return;
    std::uint8_t& static_age = state_.static_age[here_.index()];
    if (static_age == kStaticFrames || ++static_age != kStaticFrames) return;
    here_.for_each_pixel(
        [&](const BlockPixel& p) { state_.background[p.at] = state_.picture[p.at]; });
  }

  void code_refinement(BlockCode& code) {
    if constexpr (!Coder::kWrites) code.refinement.fill(0);
    code_coefficients(coder_, contexts_.coefficients[2], 0, code.refinement);
    BlockCoefficients coefficients;
    const int rows = surface_coefficients(code.refinement, kRefinementStep, {}, coefficients);
    inverse_transform(coefficients, rows, surfaces_[0]);
    here_.for_each_pixel([&](const BlockPixel& p) {
      const int old = state_.picture[p.at];
      levels_[p.k] =
          old == 0 ? std::uint16_t{0} : limited_level(std::int64_t{old} + surfaces_[0][p.k]);
      if (reference_ && state_.background[p.at] == old) state_.background[p.at] = levels_[p.k];
    });
  }

  void code_readings(BlockCode& code) {
    std::int32_t prediction = 0;
    bool left = true;
    here_.for_each_pixel([&](const BlockPixel& p) {
      const bool upper = p.k < kBlockSide || levels_[p.k - kBlockSide] != 0;
      left = coder_.bit(contexts_.raw_reading[left + 2u * upper], code.readings[p.k] != 0);
      levels_[p.k] = 0;
      if (!left) return;
      if (prediction == 0) prediction = std::max<std::int32_t>(1, state_.picture[p.at]);
      const int steps = (code.readings[p.k] - prediction) / kReadingStep;
      const std::int32_t coded = code_signed(coder_, contexts_.raw_difference, steps);
      levels_[p.k] = limited_level(std::int64_t{prediction} + std::int64_t{coded} * kReadingStep);
      prediction = levels_[p.k];
    });
  }

  void code_surfaces(BlockCode& code, BlockTrace& trace) {
    code.surface_count =
        code_up_to_two(coder_, contexts_.any_surface, contexts_.two_surfaces, code.surface_count);
    for (std::size_t which = 0; which < code.surface_count; ++which) {
      const SurfaceCandidates candidates = this->candidates(here_, which);
      SurfaceCode& surface = code.surfaces[which];
      code_surface(coder_, contexts_, candidates, which, surface);
      BlockCoefficients coefficients;
      const int rows = surface_coefficients(surface.steps, step_ >> surface.finer,
                                            candidates[surface.candidate], coefficients);
      inverse_transform(coefficients, rows, surfaces_[which]);
      trace.surfaces[which] = {coefficients[0], coefficients[1], coefficients[8], true};
      last_[which] = trace.surfaces[which];
    }
  }

  void code_labels(BlockCode& code, BlockTrace& trace) {
    const auto uniform = [&](std::size_t block) {
      return scratch_.trace[block].activity == BlockActivity::kUniform;
    };
    const std::size_t uniform_neighbours = std::size_t{here_.has_left() && uniform(here_.left())} +
                                           std::size_t{here_.has_above() && uniform(here_.above())};
    LabelCoder labels(state_, here_, surfaces_, scratch_.labels, contexts_, coder_);
    if (labels.code_uniform(code, uniform_neighbours)) {
      trace.activity = BlockActivity::kUniform;
    } else {
      labels.code_each(code);
    }
    here_.for_each_pixel([&](const BlockPixel& p) {
      levels_[p.k] = labelled_level(code.labels[p.k], state_.picture[p.at], state_.background[p.at],
                                    surfaces_, p.k);
    });
  }

  void store() {
    hash_.add(here_.index());
    if (here_.is_whole()) {
      hash_.add(levels_);
    } else {
      here_.for_each_pixel([&](const BlockPixel& p) { hash_.add(levels_[p.k]); });
    }
    std::uint16_t* const mm = reference_ ? state_.picture_mm.data() : shown_mm_;
    here_.for_each_pixel([&](const BlockPixel& p) {
      if (reference_) state_.picture[p.at] = levels_[p.k];
      mm[p.at] = state_.domain.mm_of(levels_[p.k]);
    });
  }

  LiveState& state_;
  PassScratch& scratch_;
  LiveContexts& contexts_;
  Coder& coder_;
  const int step_;
  const bool reference_;
  std::uint16_t* const shown_mm_;
  StateHash hash_;
  std::array<SurfaceParameters, 2> last_;

  // The current block.
  BlockView here_;
  BlockSurfaces surfaces_;
  std::array<std::uint16_t, kBlockPixels> levels_{};
};

}  // namespace roomcast::codec
