// SPDX-License-Identifier: Apache-2.0
// The live depth encoder's memory of each pixel, and the difference of the newest frame from the
// reference. All in levels. Used by the live encoder only.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "roomcast/codec/live/live_state.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Reasons to code a pixel.
enum ChangeFlag : std::uint16_t {
  kJumped = 1,       // the reading differs from the reference by more than noise
  kVanished = 2,     // no reading for kMaxMissingFrames
  kUnsupported = 4,  // no reading, and the neighbours no longer support the reference
  kBiased = 8,       // a small offset, shared by its neighbours
  kPersistent = 16,  // changed for a while: code it even if few others changed
  kOverdue = 32      // changed for too long: code it even if it is alone
};

inline constexpr unsigned kAllChanges = 63;

inline constexpr int kMaxMissingFrames = 6;  // for which a vanished reading is kept
inline constexpr int kNoiseShift = 4;        // fraction bits of PixelHistory::deviation
inline constexpr int kMaxSamples = 64;       // at this count, sum and count are halved
inline constexpr int kSampleReach =
    8 * kLevelsPerSigma;  // readings further off are not samples of the reference

struct PixelHistory {
  std::vector<std::int16_t> sum;         // of reading - reference since the pixel was coded
  std::vector<std::uint16_t> count;      // number of samples in `sum`
  std::vector<std::uint16_t> deviation;  // mean |reading - reference|, 1/16 levels
  std::vector<std::uint16_t> missing;    // consecutive frames without a reading
  std::vector<std::uint16_t>
      persistence;                      // frames with a difference, reduced in frames without one
  std::vector<std::uint16_t> patience;  // additional persistence that a flickering pixel needs

  void resize(std::size_t pixels);
  /// Adapts the sum of offsets to a reference that has changed by `shift` levels.
  void follow(std::size_t pixel, int shift) {
    sum[pixel] =
        static_cast<std::int16_t>(std::clamp(sum[pixel] - shift * count[pixel], -8000, 8000));
  }
  /// Standard deviation of the pixel's noise in levels, at least kLevelsPerSigma.
  [[nodiscard]] int sigma(std::size_t pixel) const {
    const int measured = deviation[pixel] * 5 >> (kNoiseShift + 2);
    return measured < kLevelsPerSigma ? kLevelsPerSigma : measured;
  }
};

/// One frame compared with the reference.
struct FrameChange {
  std::vector<std::uint16_t> reading;  // levels without flying pixels, 0 = none
  std::vector<std::uint16_t> flags;    // ChangeFlags
  std::vector<std::int16_t> off;     // reading - reference where they differ by noise only, else 0
  std::vector<std::uint16_t> close;  // 1 where `off` is valid

  void resize(std::size_t pixels);
};

/// Compares frames with the reference; keeps its memory from frame to frame.
class ChangeAnalysis {
 public:
  void resize(int width, int height);
  /// Fills in `change.reading`, without flying pixels.
  void take_reading(DepthView depth_mm, const DepthDomain& domain, FrameChange& change);
  /// Fills in the rest of `change`, and updates `history`.
  void compare(const LiveState& reference, PixelHistory& history, FrameChange& change);

 private:
  void drop_flying_pixels(std::uint16_t* out) const;
  void drop_unsupported_holds(const LiveState& reference, const FrameChange& change);
  [[nodiscard]] bool held_without_support(const LiveState& reference, const FrameChange& change,
                                          int x, int y) const;
  void sum_rows(const FrameChange& change);
  void settle(PixelHistory& history, FrameChange& change) const;

  int width_ = 0, height_ = 0;
  std::vector<std::uint16_t> levels_, first_flags_, row_flags_, row_close_;
  std::vector<std::int16_t> row_off_;
};

}  // namespace roomcast::codec
