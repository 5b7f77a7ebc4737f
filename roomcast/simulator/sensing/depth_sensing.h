// SPDX-License-Identifier: Apache-2.0
// DepthSensing: converts the true scene in front of a depth camera to the reported depth in
// millimetres:
// - random axial error: the profile's published formula (axial_noise.h), times sqrt(reference
//   reflectance / reflectance) for time of flight, whose noise is shot noise (Lange & Seitz,
//   "Solid-state time-of-flight range camera", 2001); bounded to 0.7..4;
// - systematic error: the unit's bias (depth_bias.h) and the detour of light that was reflected
//   twice (multipath, tracing/multipath.h);
// - flying pixels: a pixel that sees two surfaces reports, by time of flight, the mean of both
//   weighted by the light they return; by stereo, the one with the larger share. The shares vary
//   with the lateral noise (Fankhauser et al. 2015). A part of these readings is discarded, as by
//   the devices' edge filters (the shares are ours);
// - no reading outside the range, at grazing angles above 83 degrees, and, intermittently, where
//   little light returns: dark, oblique or distant surfaces, and polished ones, which mirror it
//   away (surface.h); nor where a polished surface mirrors the emitter at normal incidence: the
//   pixel saturates. Depth cameras of this kind give no reading in both cases (Microsoft, "Azure
//   Kinect DK depth camera", Invalidation; of the Kinect v2: "Black dot in depth image", reported
//   to libfreenect2 in 2016);
// - interference (interference.h).
// Everything is a function of (key, pixel): the same key gives the same picture on any machine with
// the same libm. Const calls are thread-safe.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/simulator/random/gaussian_table.h"
#include "roomcast/simulator/sensing/depth_bias.h"
#include "roomcast/simulator/sensing/depth_reading.h"
#include "roomcast/simulator/sensing/interference.h"
#include "roomcast/simulator/sensing/sensor_profile.h"

namespace roomcast::simulator {

/// The reflectance to which the formulas' noise applies.
inline constexpr float kReferenceReflectance = 0.5F;

/// The reading of one pixel without random effects.
struct ExpectedReading {
  float mean_mm = 0;  // 0: never a reading
  float sigma_mm = 0;
  float dropout = 0;     // probability of no reading
  OtherSurface other;    // its depth in metres
  float lateral_px = 0;  // lateral noise, pixels; used only next to another surface

  [[nodiscard]] std::uint16_t rounded_mm() const;
  [[nodiscard]] bool is_plain() const { return dropout == 0.0F && other.share == 0.0F; }
};

/// The random inputs of one frame.
struct FrameNoise {
  std::uint32_t key = 0;
  Image<float> unit;  // fill_unit_noise
  std::optional<InterferenceBurst> burst;
};

class DepthSensing {
 public:
  DepthSensing(const SensorProfile& profile, DepthBias bias)
      : profile_(profile), bias_(std::move(bias)) {}

  [[nodiscard]] ExpectedReading expect(const DepthReading& reading, int x, int y) const;
  /// The reading in millimetres, 0 for none.
  [[nodiscard]] std::uint16_t read(const ExpectedReading& expected, int x, int y,
                                   const FrameNoise& noise) const;

  [[nodiscard]] float dropout_probability(const DepthReading& reading) const;
  [[nodiscard]] const SensorProfile& profile() const { return profile_; }

 private:
  [[nodiscard]] float sigma_mm(const DepthReading& reading) const;
  /// Nothing if the reading is discarded.
  [[nodiscard]] std::optional<float> seen_at_edge(const ExpectedReading& expected,
                                                  std::uint32_t hash) const;

  SensorProfile profile_;
  DepthBias bias_;
};

/// The picture of the static scene, computed once.
class StillDepth {
 public:
  explicit StillDepth(ImageView<const ExpectedReading> expected);

  void read(const DepthSensing& sensing, const FrameNoise& noise,
            ImageView<std::uint16_t> out) const;
  /// The mean readings; 0 where there is never a reading.
  void expect(ImageView<std::uint16_t> out) const;

 private:
  struct Uncertain {
    int x, y;
    ExpectedReading expected;
  };
  Image<float> mean_mm_, sigma_mm_;
  std::vector<Uncertain> uncertain_;  // pixels with more than Gaussian noise
};

}  // namespace roomcast::simulator
