// SPDX-License-Identifier: Apache-2.0
// What the live depth encoder remembers of each pixel, and how the newest frame
// differs from the reference. All in levels. The encoder's own affair: decoders
// know nothing of it.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <vector>

#include "roomcast/codec/live/live_state.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Why a pixel may have to be coded.
enum ChangeFlag : std::uint16_t {
  kJumped = 1,       // the reading left the noise around the reference
  kVanished = 2,     // no reading for kHoldFrames
  kUnsupported = 4,  // no reading, and no neighbour still agrees with the reference
  kBiased = 8,       // a little off, but so are its neighbours
  kPersistent = 16,  // and has been for a while: code it even if few others changed
  kOverdue = 32      // and has been for too long: code it even if it is alone
};

inline constexpr int kHoldFrames = 6;   // that a reading is kept when it vanishes
inline constexpr int kNoiseShift = 4;   // of PixelHistory::deviation
inline constexpr int kMaxSamples = 64;  // then sum and count are halved
inline constexpr int kSampleReach =
    8 * kLevelsPerSigma;  // further off is no sample of the reference

struct PixelHistory {
  std::vector<std::int16_t> sum;         // of (reading - reference) since the pixel was coded
  std::vector<std::uint16_t> count;      // of them
  std::vector<std::uint16_t> deviation;  // mean |reading - reference|, 1/16 levels
  std::vector<std::uint16_t> missing;    // frames in a row without a reading
  std::vector<std::uint16_t>
      persistence;  // frames that a difference has lasted, less those it has not
  std::vector<std::uint16_t> patience;  // more of it that a pixel that flickers needs

  void resize(std::size_t pixels);
  /// Standard deviation of the pixel's noise in levels, at least the table's.
  [[nodiscard]] int sigma(std::size_t pixel) const {
    const int measured = deviation[pixel] * 5 >> (kNoiseShift + 2);
    return measured < kLevelsPerSigma ? kLevelsPerSigma : measured;
  }
};

/// One frame against the reference.
struct FrameChange {
  std::vector<std::uint16_t> reading;  // levels without flying pixels, 0 = none
  std::vector<std::uint16_t> flags;    // ChangeFlags
  std::vector<std::int16_t> off;  // reading - reference where both are and differ by noise, else 0
  std::vector<std::uint16_t> close;  // 1 there

  void resize(std::size_t pixels);
};

/// Memory of the analysis, kept from frame to frame.
class ChangeAnalysis {
 public:
  void resize(int width, int height);
  /// Fills in `change.reading`.
  void take_reading(DepthView depth_mm, const DepthDomain& domain, FrameChange& change);
  /// Fills in the rest, and the history.
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
