// SPDX-License-Identifier: Apache-2.0
// MutualInterference: what the light of the other sensors of a room does to one sensor's depth.
// - Structured light: where the dot patterns of two projectors overlap, windows of the pattern are
//   not recognised any more, or less exactly: holes in patches that come and go, and noise (Butler
//   et al., "Shake'n'Sense", CHI 2012; Maimone and Fuchs, "Reducing interference between multiple
//   structured light depth sensors using motion", IEEE VR 2012; Schroeder et al., "Multiple Kinect
//   studies", TU Braunschweig 2011). The pattern stands still, so the same patches are affected
//   most; near the limit they flicker.
// - Time of flight: while the pulses of two cameras meet (pulse_overlap.h), the foreign light
// spoils
//   the measured phase: noise, and no reading where the exposures of a frame contradict each other
//   (Buettgen and Seitz, "Robust optical time-of-flight range imaging based on smart pixel
//   structures", IEEE TCAS-I 55(6), 2008; Brogli 2016).
// Time of flight and structured light do not disturb each other: their wavelengths differ. Stereo
// matches a foreign pattern like any texture. The amounts are ours; those of structured light were
// compared with the real rig kinects3. On what moves, the foreign light is taken to be that on the
// surface behind. A function of (key, frame, scene time). Const calls are thread-safe.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/simulator/random/gaussian_table.h"
#include "roomcast/simulator/sensing/frame_clock.h"
#include "roomcast/simulator/sensing/sensor_profile.h"

namespace roomcast::simulator {

/// Whether light of one kind of sensor disturbs the other.
[[nodiscard]] bool disturbs(DepthPrinciple emitting, DepthPrinciple sensing);

class MutualInterference {
 public:
  struct Other {
    Image<float> light;  // trace_foreign_light: a multiple of this sensor's own
    FrameClock clock;
  };

  MutualInterference() = default;
  /// `others`: those that disturb a sensor of this profile.
  MutualInterference(const SensorProfile& profile, std::uint32_t unit_key,
                     std::vector<Other> others);

  /// Disturbs a frame's depth. `frame_key`: of this frame's random numbers.
  void disturb(std::uint32_t frame_key, nanoseconds scene_time, const GaussianTable& gaussians,
               ImageView<std::uint16_t> depth_mm) const;

 private:
  struct Active {
    const Image<float>* light;
    float share;  // of the exposure
  };
  [[nodiscard]] std::vector<Active> active_at(nanoseconds scene_time) const;
  [[nodiscard]] float lost_share(float light, float x, float y, std::uint32_t frame_key) const;

  SensorProfile profile_;
  std::uint32_t key_ = 0;
  std::vector<Other> others_;
};

}  // namespace roomcast::simulator
