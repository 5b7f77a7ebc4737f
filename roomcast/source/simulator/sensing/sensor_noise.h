// SPDX-License-Identifier: Apache-2.0
// What a Kinect-v2-like camera does to a perfect picture. Depth, per pixel:
//  - axial noise: sigma[mm] = 1.5 - 0.5 z + 0.3 z^2 + 0.1 z^1.5 theta^2 / (pi/2 - theta)^2, z in
//    metres, theta the angle of incidence (Fankhauser et al. 2015), times
//    0.75 + 0.25 sqrt(0.05 / amplitude), amplitude = infrared * cos(theta) / distance^2. Ours are
//    the second factor (weak signals are noisier) and the use of 72 degrees beyond 72;
//  - no reading outside 0.5..8 m, at grazing angles above 83 degrees, and, flickering, where the
//    amplitude is weak;
//  - flying pixels: beside a step in depth a quarter of the readings is lost and a quarter lies
//    between the two sides.
// Colour: Gaussian read noise of about one grey level.
// Everything is a function of (key, pixel): the same key gives the same picture on any machine with
// the same libm. Const calls are thread-safe.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/source/simulator/tracing/static_plate.h"

namespace roomcast::sim {

/// One measurement before noise. `beside_m`: the neighbour across a depth step, or `z_m` where
/// there is none.
struct PerfectReading {
  float z_m = 0;
  float facing = 1;  // cosine of the angle of incidence
  float infrared = 0.5F;
  float beside_m = 0;
};

[[nodiscard]] float axial_sigma_mm(const PerfectReading& reading);
/// Probability that the sensor reports nothing, steps aside: 0..1.
[[nodiscard]] float dropout_probability(const PerfectReading& reading);
/// Whether two neighbouring depths are different surfaces.
[[nodiscard]] bool is_depth_step(float a_m, float b_m);

/// Gaussian numbers, drawn once and then only read.
class GaussianTable {
 public:
  static constexpr std::size_t kSize = 1U << 16;
  static constexpr std::size_t kLongestRun = 4096;

  explicit GaussianTable(std::uint32_t seed);
  /// At least kLongestRun numbers of mean 0 and deviation 1, from a place chosen by the hash.
  [[nodiscard]] const float* run(std::uint32_t hash) const { return &values_[hash % kSize]; }
  [[nodiscard]] float one(std::uint32_t hash) const { return values_[hash % kSize]; }

 private:
  std::vector<float> values_;
};

/// The noise of one depth camera in front of its static plate.
class DepthNoise {
 public:
  DepthNoise(const DepthPlate& plate, const GaussianTable& gaussians);

  /// The whole plate as it is read in the frame with this key; `out` has the plate's size.
  void read_plate(std::uint32_t key, ImageView<std::uint16_t> out) const;
  /// One reading at pixel number `pixel`, in millimetres, 0 for none.
  [[nodiscard]] std::uint16_t read(const PerfectReading& reading, std::uint32_t key,
                                   std::uint32_t pixel) const;

 private:
  struct Uncertain {  // a pixel of the plate that is more than Gaussian
    std::uint32_t pixel;
    float dropout;
    float beside_mm;  // across the step, relative to this pixel; 0: no step
  };
  [[nodiscard]] std::uint16_t disturbed(std::uint16_t value_mm, const Uncertain& at,
                                        std::uint32_t key) const;

  const GaussianTable& gaussians_;
  Image<float> mean_mm_;  // 0: never a reading
  Image<float> sigma_mm_;
  std::vector<Uncertain> uncertain_;
};

/// Adds read noise to every channel.
void add_color_noise(std::uint32_t key, const GaussianTable& gaussians, ImageView<Rgb8> picture);

}  // namespace roomcast::sim
