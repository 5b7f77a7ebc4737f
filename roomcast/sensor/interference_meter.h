// SPDX-License-Identifier: Apache-2.0
// InterferenceMeter: how much a depth sensor is disturbed by the infrared light of others, from its
// own frames alone. A surface that stands still and is seen well keeps its reading; where foreign
// light falls on it, readings come and go (structured light), and there are moments with more noise
// than the sensor has otherwise (time of flight; the noise of quiet moments is learnt by distance).
// Both figures are measured inside still surfaces only: at outlines every sensor loses readings. On
// dark and polished things and at the limit of its range it loses them one by one; foreign dot
// patterns cost whole patches, so only these count. What moves, and a sensor that is carried, do
// not count. Single-threaded; keeps its memory from frame to frame.
#pragma once

#include <array>
#include <cstdint>

#include "roomcast/codec/live/depth_domain.h"
#include "roomcast/codec/live/sensor_noise.h"
#include "roomcast/core/image.h"

namespace roomcast::sensor {

struct InterferenceFigures {
  /// Share of the readings of still surfaces that are missing at the moment: mean of the last two
  /// seconds at 30 frames/s.
  double flickering = 0;
  /// Largest noise of a frame in the last ten seconds, in the sensor's own noise; 1: none extra.
  double noise_ratio = 1;
  bool is_known = false;  // enough still surface was seen for long enough
};

class InterferenceMeter {
 public:
  /// What a pixel shows, compared with the still surface known there.
  enum class Shown : std::uint8_t { kUnknown, kStill, kMissing, kNearer, kFarther };

  /// `fps`: of the frames, above 0. A surface without a reading for a second is gone.
  explicit InterferenceMeter(double fps);

  /// Takes the next frame. Another size begins anew.
  void add(DepthView depth_mm);

  [[nodiscard]] InterferenceFigures figures() const;

  // Of the newest frame, by pixel; for the filter.
  [[nodiscard]] ImageView<const Shown> shown() const { return shown_.view(); }
  /// The still surface, 1/16 mm; valid where `shown` is not kUnknown.
  [[nodiscard]] std::uint32_t still_16th_mm(int x, int y) const { return pixels_.at(x, y).still; }
  /// Readings of one surface differ from its still one by less.
  [[nodiscard]] float same_mm(std::uint16_t depth_mm) const;
  /// Noise of the newest frame, in the sensor's own; at least 1.
  [[nodiscard]] float noise_ratio_now() const { return ratio_now_; }

 private:
  struct Pixel {
    std::uint32_t still = 0;   // 1/16 mm
    std::uint8_t steady = 0;   // readings of the still surface so far, up to a limit
    std::uint8_t missing = 0;  // consecutive frames without a reading
    std::uint8_t odd = 0;      // consecutive readings of another surface
  };
  using ByDistance = std::array<float, codec::kSigmaKnotCount>;

  void begin(DepthView depth_mm);
  void measure_noise(DepthView depth_mm);
  void learn_quiet_noise(const ByDistance& deviation_mm, const ByDistance& count);
  [[nodiscard]] Shown see(std::uint16_t reading_mm, Pixel& pixel) const;
  void count_flicker();
  void find_weak_blocks();
  [[nodiscard]] int missing_neighbours(int x, int y) const;
  [[nodiscard]] bool is_inside(int x, int y) const;

  int max_missing_;  // frames
  Image<Pixel> pixels_;
  Image<Shown> shown_;
  Image<int> alone_;  // by block of 16 x 16 pixels: readings that are missing one by one
  codec::SensorNoise noise_;
  ByDistance law_mm_{};    // standard deviation by noise_, which also knows the steps of depth
  ByDistance quiet_mm_{};  // mean deviation from still surfaces in quiet moments; 0: unknown
  float ratio_now_ = 1, ratio_peak_ = 1;
  double flickering_ = 0;
  int frames_ = 0, known_frames_ = 0;
};

}  // namespace roomcast::sensor
