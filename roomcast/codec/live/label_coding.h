// SPDX-License-Identifier: Apache-2.0
// Writes or reads the labels of a block's pixels, which say where each value comes from.
// docs/spec/codec.md §2.4.4 steps 5 to 7.
//
// Labels are coded by context like the masks of JBIG2 (ITU-T T.88).
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "roomcast/codec/live/block_code.h"
#include "roomcast/codec/live/live_state.h"

namespace roomcast::codec {

inline constexpr int kNear = 3 * kLevelsPerSigma;  // a level at most this far is on the surface

/// The labels of a picture's pixels, with a margin above, left and right: all of a pixel's
/// neighbours that are coded before it exist.
class LabelPlane {
 public:
  void resize(const BlockGrid& grid) {
    stride_ = grid.width + 2;
    labels_.resize(BlockGrid(stride_, grid.height + 1).pixel_count());
  }
  void clear() { std::fill(labels_.begin(), labels_.end(), PixelLabel::kUnchanged); }
  /// The neighbours are at [-1] and, `stride()` before, at [-1], [0] and [1].
  [[nodiscard]] PixelLabel* at(const BlockPixel& pixel) {
    return &labels_[static_cast<std::size_t>((pixel.y + 1) * stride_ + pixel.x + 1)];
  }
  [[nodiscard]] std::ptrdiff_t stride() const { return stride_; }

 private:
  int stride_ = 0;
  std::vector<PixelLabel> labels_;
};

/// The values of a block's at most two surfaces, levels.
using BlockSurfaces = std::array<BlockValues, 2>;

[[nodiscard]] inline std::uint16_t limited_level(std::int64_t level) {
  return static_cast<std::uint16_t>(std::clamp<std::int64_t>(level, 1, kMaxLevel));
}

/// The level of a pixel with this label; k is its index in the block.
[[nodiscard]] inline std::uint16_t labelled_level(PixelLabel label, std::uint16_t old,
                                                  std::uint16_t background,
                                                  const BlockSurfaces& surfaces, std::size_t k) {
  switch (label) {
    case PixelLabel::kBackground:
      return background;
    case PixelLabel::kVanished:
      return 0;
    case PixelLabel::kFirst:
      return limited_level(surfaces[0][k]);
    case PixelLabel::kSecond:
      return limited_level(surfaces[1][k]);
    default:
      return old;
  }
}

/// Codes the labels of one block.
template <class Coder>
class LabelCoder {
 public:
  LabelCoder(const LiveState& state, const BlockView& here, const BlockSurfaces& surfaces,
             LabelPlane& labels, LiveContexts& contexts, Coder& coder)
      : state_(state),
        here_(here),
        surfaces_(surfaces),
        labels_(labels),
        contexts_(contexts),
        coder_(coder) {}

  /// Returns whether the whole block is on its only surface. `context`: how many of the blocks to
  /// the left and above are.
  bool code_uniform(BlockCode& code, std::size_t context) {
    if (code.surface_count != 1) return false;
    bool uniform = true;
    if constexpr (Coder::kWrites) {
      here_.for_each_pixel(
          [&](const BlockPixel& p) { uniform &= code.labels[p.k] == PixelLabel::kFirst; });
    }
    if (!coder_.bit(contexts_.uniform[context], uniform)) return false;
    here_.for_each_pixel(
        [&](const BlockPixel& p) { *labels_.at(p) = code.labels[p.k] = PixelLabel::kFirst; });
    return true;
  }

  void code_each(BlockCode& code) {
    here_.for_each_pixel([&](const BlockPixel& p) {
      PixelLabel* const label = labels_.at(p);
      const PixelLabel* const above = label - labels_.stride();
      *label = code.labels[p.k] = code_label(code, p, {label[-1], above[-1], above[0], above[1]});
    });
  }

 private:
  struct Neighbours {
    PixelLabel w, nw, n, ne;
  };

  PixelLabel code_label(const BlockCode& code, const BlockPixel& p, const Neighbours& near) {
    const PixelLabel wanted = code.labels[p.k];
    if (code.surface_count > 0) {
      const unsigned context = on_surface(near.w) + 2u * on_surface(near.n) +
                               4u * on_surface(near.nw) + 8u * on_surface(near.ne) +
                               16 * relation(code, p);
      if (coder_.bit(contexts_.on_surface[context], on_surface(wanted))) {
        return code.surface_count == 1 ? PixelLabel::kFirst : code_which_surface(wanted, near);
      }
    }
    return code_off_surface(wanted, p, near);
  }

  PixelLabel code_which_surface(PixelLabel wanted, const Neighbours& near) {
    const auto side = [](PixelLabel l) {
      return on_surface(l) ? 1u + (l == PixelLabel::kSecond) : 0u;
    };
    const unsigned context = side(near.w) + 3 * side(near.n) + 9 * side(near.ne);
    return coder_.bit(contexts_.which_surface[context], wanted == PixelLabel::kSecond)
               ? PixelLabel::kSecond
               : PixelLabel::kFirst;
  }

  PixelLabel code_off_surface(PixelLabel wanted, const BlockPixel& p, const Neighbours& near) {
    const auto among = [&near](PixelLabel l) { return (near.w == l) + 2u * (near.n == l); };
    const std::uint16_t old = state_.picture[p.at], background = state_.background[p.at];
    if (background != 0 && background != old) {
      const unsigned context = among(PixelLabel::kBackground) + 4u * (old != 0);
      if (coder_.bit(contexts_.background[context], wanted == PixelLabel::kBackground)) {
        return PixelLabel::kBackground;
      }
    }
    if (old == 0) return PixelLabel::kUnchanged;
    return coder_.bit(contexts_.vanished[among(PixelLabel::kVanished)],
                      wanted == PixelLabel::kVanished)
               ? PixelLabel::kVanished
               : PixelLabel::kUnchanged;
  }

  /// Context 0..63: relation of the reference to the surfaces at this pixel and at its right and
  /// lower neighbours, which are not coded yet; and whether the reference covers the background
  /// here.
  [[nodiscard]] unsigned relation(const BlockCode& code, const BlockPixel& p) const {
    const BlockGrid& grid = state_.grid;
    const int old = state_.picture[p.at], background = state_.background[p.at];
    const bool covers =
        background != 0 && old != 0 && std::abs(background - old) > 4 * kLevelsPerSigma;
    const int right = p.x + 1 < grid.width ? state_.picture[p.at + 1] : 0;
    const int below = p.y + 1 < grid.height ? state_.picture[p.at + grid.pixel(0, 1)] : 0;
    const auto to_surface = [&](int level) {
      return relation_to(nearest_surface(code, p.k, level), level);
    };
    return to_surface(old) + 4u * covers + 8u * (to_surface(right) == 1) +
           16u * (to_surface(below) == 1);
  }
  [[nodiscard]] int nearest_surface(const BlockCode& code, std::size_t k, int value) const {
    if (code.surface_count == 1) return surfaces_[0][k];
    const std::int64_t first = surfaces_[0][k], second = surfaces_[1][k];
    return static_cast<int>(std::abs(first - value) <= std::abs(second - value) ? first : second);
  }
  /// 0 no reading, 1 near, 2 behind the surface, 3 in front of it.
  [[nodiscard]] static unsigned relation_to(std::int64_t surface, int old) {
    if (old == 0) return 0;
    if (std::abs(surface - old) < kNear) return 1;
    return old > surface ? 2 : 3;
  }

  const LiveState& state_;
  const BlockView& here_;
  const BlockSurfaces& surfaces_;
  LabelPlane& labels_;
  LiveContexts& contexts_;
  Coder& coder_;
};

}  // namespace roomcast::codec
