// SPDX-License-Identifier: Apache-2.0
// One pass over the blocks of a live depth picture: codes each block and applies it. One template
// is both writer and reader, so that encoder and decoder cannot disagree. docs/spec/codec.md
// §2.4.2.
//
// Background after long-term reference pictures (H.264 Annex; Wiegand 1999), here per block; labels
// are coded by context like the masks of JBIG2 (ITU-T T.88).
#pragma once

#include <cstdlib>
#include <cstring>

#include "roomcast/codec/live/block_code.h"
#include "roomcast/codec/live/coefficient_coding.h"
#include "roomcast/codec/live/pass_scratch.h"
#include "roomcast/codec/live/state_hash.h"
#include "roomcast/codec/live/surface_prediction.h"

namespace roomcast::codec {

inline constexpr int kStaticFrames =
    20;  // after so many unchanged frames a block becomes background
inline constexpr int kRefinementStep = 6;  // levels
inline constexpr int kReadingStep = 2;     // levels
inline constexpr int kNear = 3 * kLevelsPerSigma;

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
    std::fill(scratch.labels.begin(), scratch.labels.end(), PixelLabel::kUnchanged);
  }

  /// Codes one block; call in raster order, once for each. A reader fills in `code`.
  void block(int bx, int by, BlockCode& code) {
    place(bx, by);
    if (!code_activity(code)) return skip();
    BlockTrace& trace = scratch_.trace[block_];
    trace = {};
    trace.activity = BlockActivity::kMixed;
    if (code.mode == BlockMode::kRefine) {
      code_refinement(code);
    } else if (code.mode == BlockMode::kRaw) {
      code_readings(code);
    } else {
      code_surfaces(code, trace);
      if (code_uniform(code))
        trace.activity = BlockActivity::kUniform;
      else
        code_labels(code);
      resolve_labels(code);
    }
    if (reference_ && code.mode != BlockMode::kRefine) state_.static_age[block_] = 0;
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
  [[nodiscard]] const SurfaceParameters& last_surface(std::size_t which) const {
    return last_[which];
  }

 private:
  void place(int bx, int by) {
    bx_ = bx;
    by_ = by;
    block_ = static_cast<std::size_t>(by) * static_cast<std::size_t>(state_.blocks_wide) +
             static_cast<std::size_t>(bx);
    columns_ = std::min(kBlockSide, state_.width - bx * kBlockSide);
    rows_ = std::min(kBlockSide, state_.height - by * kBlockSide);
    first_pixel_ =
        static_cast<std::size_t>(by * kBlockSide) * static_cast<std::size_t>(state_.width) +
        static_cast<std::size_t>(bx * kBlockSide);
  }
  [[nodiscard]] std::size_t pixel(int x, int y) const {
    return first_pixel_ + static_cast<std::size_t>(y) * static_cast<std::size_t>(state_.width) +
           static_cast<std::size_t>(x);
  }
  /// Calls `what` for each pixel of the block inside the picture, with its index in the block and
  /// in the picture.
  template <class Do>
  void for_each_pixel(Do&& what) {
    for (int y = 0; y < rows_; ++y) {
      for (int x = 0; x < columns_; ++x) {
        what(static_cast<std::size_t>(y * kBlockSide + x), pixel(x, y));
      }
    }
  }

  bool code_activity(BlockCode& code) {
    const auto activity = [](const BlockTrace& t) { return static_cast<std::size_t>(t.activity); };
    const auto wide = static_cast<std::size_t>(state_.blocks_wide);
    const auto& before = state_.trace;
    std::size_t context = 18 * activity(before[block_]);
    if (bx_ > 0) context += 2 * activity(scratch_.trace[block_ - 1]);
    if (by_ > 0) context += 6 * activity(scratch_.trace[block_ - wide]);
    const bool right = bx_ + 1 < state_.blocks_wide && activity(before[block_ + 1]) != 0;
    const bool below = by_ + 1 < state_.blocks_high && activity(before[block_ + wide]) != 0;
    context += right || below;
    if (!coder_.bit(contexts_.active[context], code.mode != BlockMode::kSkip)) {
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

  void skip() {
    scratch_.trace[block_] = {};
    if (!reference_) return;
    std::uint8_t& static_age = state_.static_age[block_];
    if (static_age == kStaticFrames || ++static_age != kStaticFrames) return;
    const std::size_t bytes = static_cast<std::size_t>(columns_) * sizeof(std::uint16_t);
    for (int y = 0; y < rows_; ++y) {
      std::memcpy(&state_.background[pixel(0, y)], &state_.picture[pixel(0, y)], bytes);
    }
  }

  void code_refinement(BlockCode& code) {
    if constexpr (!Coder::kWrites) code.refinement.fill(0);
    code_coefficients(coder_, contexts_.coefficients[2], 0, code.refinement);
    BlockCoefficients coefficients;
    const int rows = surface_coefficients(code.refinement, kRefinementStep, {}, coefficients);
    inverse_transform(coefficients, rows, surfaces_[0]);
    for_each_pixel([&](std::size_t k, std::size_t at) {
      const int old = state_.picture[at];
      levels_[k] = old == 0 ? std::uint16_t{0} : level(std::int64_t{old} + surfaces_[0][k]);
      if (reference_ && state_.background[at] == old) state_.background[at] = levels_[k];
    });
  }

  void code_readings(BlockCode& code) {
    std::int32_t prediction = 0;
    bool left = true;
    for_each_pixel([&](std::size_t k, std::size_t at) {
      const bool upper = k < kBlockSide || levels_[k - kBlockSide] != 0;
      const bool reading = coder_.bit(
          contexts_.raw_reading[static_cast<std::size_t>(left + 2 * upper)], code.readings[k] != 0);
      left = reading;
      levels_[k] = 0;
      if (!reading) return;
      if (prediction == 0) prediction = std::max<std::int32_t>(1, state_.picture[at]);
      const int difference = code.readings[k] - prediction;
      const int steps = difference / kReadingStep;
      const std::int32_t coded =
          unfold_sign(code_number(coder_, contexts_.raw_difference, fold_sign(steps)));
      levels_[k] = level(std::int64_t{prediction} + std::int64_t{coded} * kReadingStep);
      prediction = levels_[k];
    });
  }

  void code_surfaces(BlockCode& code, BlockTrace& trace) {
    std::uint8_t& count = code.surface_count;
    count = coder_.bit(contexts_.any_surface, count > 0)
                ? static_cast<std::uint8_t>(1 + coder_.bit(contexts_.two_surfaces, count == 2))
                : std::uint8_t{0};
    for (std::size_t which = 0; which < count; ++which) {
      const SurfaceCandidates candidates =
          surface_candidates(state_, scratch_.trace, bx_, by_, which, last_[which]);
      SurfaceCode& surface = code.surfaces[which];
      code_candidate(candidates, which, surface);
      code_steps(which, surface);
      BlockCoefficients coefficients;
      const int rows = surface_coefficients(surface.steps, step_ >> surface.finer,
                                            candidates[surface.candidate], coefficients);
      inverse_transform(coefficients, rows, surfaces_[which]);
      trace.surfaces[which] = {coefficients[0], coefficients[1], coefficients[8], true};
      last_[which] = trace.surfaces[which];
    }
  }

  // One bit for each known candidate but the last.
  void code_candidate(const SurfaceCandidates& candidates, std::size_t which,
                      SurfaceCode& surface) {
    auto& models = contexts_.candidate[which * 2 + candidates[2].known];
    std::size_t last_known = 0;
    for (std::size_t i = 0; i < kSurfaceCandidates; ++i) {
      if (candidates[i].known) last_known = i;
    }
    for (std::size_t i = 0; i < last_known; ++i) {
      if (candidates[i].known && coder_.bit(models[i], surface.candidate == i)) {
        surface.candidate = static_cast<std::uint8_t>(i);
        return;
      }
    }
    surface.candidate = static_cast<std::uint8_t>(last_known);
  }

  void code_steps(std::size_t which, SurfaceCode& surface) {
    BlockCoefficients& steps = surface.steps;
    if constexpr (!Coder::kWrites) steps.fill(0);
    surface.finer =
        coder_.bit(contexts_.finer[0], surface.finer > 0)
            ? static_cast<std::uint8_t>(1 + coder_.bit(contexts_.finer[1], surface.finer > 1))
            : std::uint8_t{0};
    const auto code_signed = [&](auto& model, std::int32_t value) {
      return unfold_sign(code_number(coder_, model, fold_sign(value)));
    };
    steps[0] = code_signed(contexts_.mean[which], steps[0]);
    steps[1] = code_signed(contexts_.slope[which][0], steps[1]);
    steps[8] = code_signed(contexts_.slope[which][1], steps[8]);
    code_coefficients(coder_, contexts_.coefficients[surface.finer > 0], 3, steps);
  }

  /// Returns whether the whole block is on its first surface.
  bool code_uniform(BlockCode& code) {
    if (code.surface_count != 1) return false;
    bool uniform = true;
    if constexpr (Coder::kWrites) {
      for_each_pixel(
          [&](std::size_t k, std::size_t) { uniform &= code.labels[k] == PixelLabel::kFirst; });
    }
    const auto wide = static_cast<std::size_t>(state_.blocks_wide);
    std::size_t context = 0;
    if (bx_ > 0) context += scratch_.trace[block_ - 1].activity == BlockActivity::kUniform;
    if (by_ > 0) context += scratch_.trace[block_ - wide].activity == BlockActivity::kUniform;
    uniform = coder_.bit(contexts_.uniform[context], uniform);
    if (!uniform) return false;
    for_each_pixel([&](std::size_t k, std::size_t at) {
      code.labels[k] = PixelLabel::kFirst;
      *label_at(k) = PixelLabel::kFirst;
      (void)at;
    });
    return true;
  }

  [[nodiscard]] PixelLabel* label_at(std::size_t k) {
    const std::size_t x = static_cast<std::size_t>(bx_ * kBlockSide) + k % kBlockSide + 1;
    const std::size_t y = static_cast<std::size_t>(by_ * kBlockSide) + k / kBlockSide + 1;
    return &scratch_.labels[y * static_cast<std::size_t>(state_.width + 2) + x];
  }

  void code_labels(BlockCode& code) {
    const std::ptrdiff_t stride = state_.width + 2;
    for (int y = 0; y < rows_; ++y) {
      PixelLabel* here = label_at(static_cast<std::size_t>(y * kBlockSide));
      for (int x = 0; x < columns_; ++x, ++here) {
        const auto k = static_cast<std::size_t>(y * kBlockSide + x);
        *here = code.labels[k] = code_label(code, k, x, y, here, here - stride);
      }
    }
  }

  PixelLabel code_label(const BlockCode& code, std::size_t k, int x, int y, const PixelLabel* here,
                        const PixelLabel* above) {
    const PixelLabel wanted = code.labels[k];
    const PixelLabel w = here[-1], nw = above[-1], n = above[0], ne = above[1];
    if (code.surface_count > 0) {
      const std::size_t context =
          static_cast<std::size_t>(on_surface(w) + 2 * on_surface(n) + 4 * on_surface(nw) +
                                   8 * on_surface(ne)) +
          16 * relation(code, k, x, y);
      if (coder_.bit(contexts_.on_surface[context], on_surface(wanted))) {
        if (code.surface_count == 1) return PixelLabel::kFirst;
        const auto side = [](PixelLabel l) {
          return static_cast<std::size_t>(on_surface(l) ? 1 + (l == PixelLabel::kSecond) : 0);
        };
        return coder_.bit(contexts_.which_surface[side(w) + 3 * side(n) + 9 * side(ne)],
                          wanted == PixelLabel::kSecond)
                   ? PixelLabel::kSecond
                   : PixelLabel::kFirst;
      }
    }
    const std::size_t at = pixel(x, y);
    const std::uint16_t old = state_.picture[at], background = state_.background[at];
    if (background != 0 && background != old) {
      const std::size_t context = static_cast<std::size_t>(
          (w == PixelLabel::kBackground) + 2 * (n == PixelLabel::kBackground) + 4 * (old != 0));
      if (coder_.bit(contexts_.background[context], wanted == PixelLabel::kBackground)) {
        return PixelLabel::kBackground;
      }
    }
    if (old == 0) return PixelLabel::kUnchanged;
    const std::size_t context =
        static_cast<std::size_t>((w == PixelLabel::kVanished) + 2 * (n == PixelLabel::kVanished));
    return coder_.bit(contexts_.vanished[context], wanted == PixelLabel::kVanished)
               ? PixelLabel::kVanished
               : PixelLabel::kUnchanged;
  }

  /// Context 0..63: relation of the reference to the surfaces at this pixel and at its right and
  /// lower neighbours, which are not coded yet; and whether the reference covers the background
  /// here.
  [[nodiscard]] std::size_t relation(const BlockCode& code, std::size_t k, int x, int y) const {
    const std::size_t at = pixel(x, y);
    const int old = state_.picture[at], background = state_.background[at];
    const int here = relation_to(nearest_surface(code, k, old), old);
    const bool covers =
        background != 0 && old != 0 && std::abs(background - old) > 4 * kLevelsPerSigma;
    const bool has_right = bx_ * kBlockSide + x + 1 < state_.width;
    const bool has_below = by_ * kBlockSide + y + 1 < state_.height;
    const int right = has_right ? state_.picture[at + 1] : 0;
    const int below = has_below ? state_.picture[at + static_cast<std::size_t>(state_.width)] : 0;
    const bool right_near = relation_to(nearest_surface(code, k, right), right) == 1;
    const bool below_near = relation_to(nearest_surface(code, k, below), below) == 1;
    return static_cast<std::size_t>(here + 4 * covers + 8 * right_near + 16 * below_near);
  }
  [[nodiscard]] int nearest_surface(const BlockCode& code, std::size_t k, int value) const {
    if (code.surface_count == 1) return surfaces_[0][k];
    const std::int64_t first = surfaces_[0][k], second = surfaces_[1][k];
    return static_cast<int>(std::abs(first - value) <= std::abs(second - value) ? first : second);
  }
  /// 0 no reading, 1 near, 2 behind the surface, 3 in front of it.
  [[nodiscard]] static int relation_to(std::int64_t surface, int old) {
    if (old == 0) return 0;
    if (std::abs(surface - old) < kNear) return 1;
    return old > surface ? 2 : 3;
  }

  void resolve_labels(const BlockCode& code) {
    for_each_pixel([&](std::size_t k, std::size_t at) {
      switch (code.labels[k]) {
        case PixelLabel::kUnchanged:
          levels_[k] = state_.picture[at];
          break;
        case PixelLabel::kBackground:
          levels_[k] = state_.background[at];
          break;
        case PixelLabel::kVanished:
          levels_[k] = 0;
          break;
        case PixelLabel::kFirst:
          levels_[k] = level(surfaces_[0][k]);
          break;
        case PixelLabel::kSecond:
          levels_[k] = level(surfaces_[1][k]);
          break;
      }
    });
  }
  [[nodiscard]] static std::uint16_t level(std::int64_t value) {
    return static_cast<std::uint16_t>(std::clamp<std::int64_t>(value, 1, kMaxLevel));
  }

  void store() {
    hash_.add(block_);
    if (columns_ < kBlockSide || rows_ < kBlockSide) {
      for_each_pixel([&](std::size_t k, std::size_t) { hash_.add(levels_[k]); });
    } else {
      hash_.add(levels_);
    }
    std::uint16_t* const mm = reference_ ? state_.picture_mm.data() : shown_mm_;
    for_each_pixel([&](std::size_t k, std::size_t at) {
      if (reference_) state_.picture[at] = levels_[k];
      mm[at] = state_.domain.mm_of(levels_[k]);
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
  int bx_ = 0, by_ = 0, columns_ = 0, rows_ = 0;
  std::size_t block_ = 0, first_pixel_ = 0;
  std::array<BlockValues, 2> surfaces_;
  std::array<std::uint16_t, kBlockPixels> levels_{};
};

}  // namespace roomcast::codec
