// SPDX-License-Identifier: Apache-2.0
// ColorResponse: the response of a colour camera to light: gain per channel (exposure and white
// balance), and noise whose variance is a constant plus a share of the signal (read and shot noise:
// EMVA Standard 1288, the photon transfer model). The amounts are ours, about one grey level. A
// function of (key, pixel). Const calls are thread-safe.
#pragma once

#include <array>
#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/simulator/random/gaussian_table.h"

namespace roomcast::simulator {

class ColorResponse {
 public:
  /// `gain`: per channel of linear light, red first.
  ColorResponse(const std::array<float, 3>& gain, bool noise);

  /// `light`: picture at gain 1, without noise -> `out`, of the same size.
  void expose(ColorView light, std::uint32_t key, const GaussianTable& gaussians,
              ImageView<Rgb8> out) const;

  /// Standard deviation of the noise at an output level, in grey levels.
  [[nodiscard]] static float sigma_at_level(float level);

 private:
  struct Level {  // output level, in 1/256 grey levels
    std::int32_t mean, sigma;
  };
  std::array<std::array<Level, 256>, 3> levels_;
};

/// Mean linear light of a picture, weighted 0.2126, 0.7152, 0.0722.
[[nodiscard]] float mean_brightness(ColorView picture);

}  // namespace roomcast::simulator
