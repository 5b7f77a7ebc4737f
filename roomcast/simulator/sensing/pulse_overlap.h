// SPDX-License-Identifier: Apache-2.0
// PulseOverlap: when the light of one time-of-flight camera falls into the exposures of another.
// A frame is nine pulses of 125 us, 1450 us apart (Microsoft, "Azure Kinect DK depth camera", raw
// timing of the narrow modes; the Kinect v2 is taken to be alike). Two cameras without a sync cable
// have clocks that differ by some millionths, so their pulses slide past each other: they meet for
// seconds, and again after minutes. The rate at which they do is the difference of the two frame
// clocks. Pure functions; seconds.
#pragma once

namespace roomcast::simulator {

inline constexpr int kPulsesPerFrame = 9;
inline constexpr double kPulse_s = 125e-6, kPulseSpacing_s = 1575e-6;  // from start to start

/// The share, 0 to 1, of a frame's exposure in which the other camera emits. `lag_s`: from the
/// beginning of any frame of the other camera to that of this frame. `other_period_s`: between
/// frames of the other camera.
[[nodiscard]] double pulse_overlap(double lag_s, double other_period_s);

}  // namespace roomcast::simulator
