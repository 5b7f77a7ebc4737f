// SPDX-License-Identifier: Apache-2.0
// Prediction and context of a pixel from its neighbours. Lossless depth encoder and decoder share
// this code, so that they cannot disagree. docs/spec/codec.md §2.2.
//
// Sources: median predictor and coding by context of local gradients, LOCO-I (Weinberger, Seroussi,
// Sapiro 2000); linear prediction with coefficients fitted to the picture, as in lossless audio and
// TMW (Meyer, Tischer 1997).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace roomcast::codec {

inline constexpr int kClassCount = 13;        // the last one is always predicted by the median
inline constexpr int kLinearClassCount = 12;  // may have weights
inline constexpr int kWeightCount = 6;        // W NW NE WW NN NWW, relative to N
inline constexpr int kWeightShift = 6;
inline constexpr int kMixedContextCount = 15;  // some neighbour is a hole
inline constexpr int kContextCount = 35;
inline constexpr int kActivityLimit = 1023;
inline constexpr int kLargestMagnitude = 255;

/// Identity for v below 4, then two steps per octave.
[[nodiscard]] constexpr int quantise(std::uint32_t v) {
  if (v < 4) return static_cast<int>(v);
  const int n = static_cast<int>(std::bit_width(v)) - 1;
  return 2 * n + static_cast<int>((v >> (n - 1)) & 1);
}

[[nodiscard]] constexpr std::array<std::uint8_t, kActivityLimit + 1> quantise_table() {
  std::array<std::uint8_t, kActivityLimit + 1> table{};
  for (std::uint32_t v = 0; v <= kActivityLimit; ++v) {
    table[v] = static_cast<std::uint8_t>(quantise(v));
  }
  return table;
}
inline constexpr auto kQuantised = quantise_table();
static_assert(kMixedContextCount + quantise(kActivityLimit) == kContextCount - 1);

struct Predictor {
  bool linear = false;
  std::array<std::int8_t, kWeightCount> weights{};
  friend bool operator==(const Predictor&, const Predictor&) = default;
};
/// One for each class; the last must stay a median.
using Predictors = std::array<Predictor, kClassCount>;

/// Properties of a decoded pixel that predict later ones.
struct Cell {
  std::uint16_t value = 0;     // for a hole: that of the pixel above
  std::uint8_t magnitude = 0;  // of the prediction's error; for a hole: that of the pixel above
  std::uint8_t reading = 0;    // 1, or 0 for a hole
};

/// Values around a pixel that predict it.
struct Neighbours {
  int w = 0, nw = 0, n = 0, ne = 0, ww = 0, nn = 0, nww = 0;
};

[[nodiscard]] inline int class_of(const Neighbours& at) {
  const int change = std::abs(at.ww - at.nww) + std::abs(at.n - at.nw) + std::abs(at.n - at.ne) +
                     std::abs(at.nn - at.n);
  return std::min<int>(kQuantised[std::min(change, kActivityLimit)], kClassCount - 1);
}

[[nodiscard]] inline int median_prediction(const Neighbours& at) {
  const int low = std::min(at.w, at.n), high = std::max(at.w, at.n);
  return std::clamp(at.w + at.n - at.nw, low, high);
}

[[nodiscard]] inline int linear_prediction(const Neighbours& at,
                                           const std::array<std::int8_t, kWeightCount>& a) {
  const int sum = a[0] * (at.w - at.n) + a[1] * (at.nw - at.n) + a[2] * (at.ne - at.n) +
                  a[3] * (at.ww - at.n) + a[4] * (at.nn - at.n) + a[5] * (at.nww - at.n);
  return at.n + ((sum + (1 << (kWeightShift - 1))) >> kWeightShift);
}

/// The three newest rows of a slice, with margins for the virtual pixels to the left and right.
class CellRows {
 public:
  /// Keeps its memory when the width is the same.
  void restart(int width) {
    stride_ = static_cast<std::size_t>(width + kLeftMargin + kRightMargin);
    cells_.assign(3 * stride_, Cell{});
    newest_ = 0;
  }
  void advance() { newest_ = (newest_ + 1) % 3; }
  /// The cell of x = 0, `back` rows above the newest.
  [[nodiscard]] Cell* row(int back) {
    return cells_.data() + static_cast<std::size_t>((newest_ + 3 - back) % 3) * stride_ +
           kLeftMargin;
  }

 private:
  // A RowWalk reads one cell beyond the right neighbour of the last pixel, without using it.
  static constexpr int kLeftMargin = 2, kRightMargin = 2;
  std::vector<Cell> cells_;
  std::size_t stride_ = 0;
  int newest_ = 0;
};

/// Iterates over the newest row: for each pixel call `prediction` and `context`, then `take`; after
/// the last pixel `end`.
class RowWalk {
 public:
  explicit RowWalk(CellRows& rows) : cell_(rows.row(0)), above_(rows.row(1)), above2_(rows.row(2)) {
    cell_[-2] = cell_[-1] = above_[0];
    at_.w = at_.ww = at_.n = above_[0].value;
    at_.nw = above_[-1].value;
    at_.nww = above_[-2].value;
    w_magnitude_ = n_magnitude_ = above_[0].magnitude;
    readings_ = above_[-1].reading | above_[0].reading << 1 | above_[0].reading << 2;
    look_right();
  }

  [[nodiscard]] int prediction(const Predictors& predictors) const {
    const Predictor& predictor = predictors[static_cast<std::size_t>(class_of(at_))];
    const int linear = linear_prediction(at_, predictor.weights);
    const int median = median_prediction(at_);
    return predictor.linear ? linear : median;
  }

  [[nodiscard]] int context() const {
    const int activity = 2 * w_magnitude_ + n_magnitude_ + ne_.magnitude +
                         std::abs(at_.w - at_.nw) + std::abs(at_.n - at_.nw) +
                         std::abs(at_.n - at_.ne);
    const int calm = kMixedContextCount + kQuantised[std::min(activity, kActivityLimit)];
    return readings_ == kMixedContextCount ? calm : readings_;
  }

  /// The cell to take for a hole.
  [[nodiscard]] Cell hole() const {
    return {static_cast<std::uint16_t>(at_.n), static_cast<std::uint8_t>(n_magnitude_), 0};
  }
  void take(Cell cell) {
    *cell_++ = cell;
    ++above_;
    ++above2_;
    at_.nww = at_.nw;
    at_.nw = at_.n;
    at_.n = ne_.value;
    at_.ww = at_.w;
    at_.w = cell.value;
    w_magnitude_ = cell.magnitude;
    n_magnitude_ = ne_.magnitude;
    readings_ = (readings_ & 2) >> 1 | (readings_ & 8) >> 2 | cell.reading << 2;
    look_right();
  }
  void end() { *cell_ = cell_[-1]; }

 private:
  // Reads one cell past the right margin after a row's last pixel; rows have that much room.
  void look_right() {
    ne_ = above_[1];
    at_.ne = ne_.value;
    at_.nn = above2_[0].value;
    readings_ |= ne_.reading << 3;
  }

  Cell* cell_;
  const Cell* above_;
  const Cell* above2_;
  Neighbours at_;
  Cell ne_;
  int w_magnitude_ = 0, n_magnitude_ = 0;
  int readings_ = 0;  // bit 0 NW, 1 N, 2 W, 3 NE
};

}  // namespace roomcast::codec
