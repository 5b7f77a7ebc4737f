// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/unit_noise.h"

#include <array>
#include <cmath>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

constexpr int kWindow = 4;  // pixels between the nodes of correlated noise

void fill_independent(std::uint32_t key, const GaussianTable& gaussians, ImageView<float> out) {
  for (int y = 0; y < out.height; ++y) {
    const std::uint32_t row_key = hash_of(key, static_cast<std::uint32_t>(y));
    float* row = out.row(y);
    for (int x = 0; x < out.width; ++x) {
      row[x] = gaussians.of_hash(mix_bits(row_key + 0x9e3779b9U * static_cast<std::uint32_t>(x)));
    }
  }
}

/// Weights of two neighbouring nodes whose weighted sum has standard deviation 1.
struct Blend {
  float first, second;
};

std::array<Blend, kWindow> blends() {
  std::array<Blend, kWindow> all{};
  for (int i = 0; i < kWindow; ++i) {
    const float share = static_cast<float>(i) / kWindow;
    const float length = std::sqrt(share * share + (1.0F - share) * (1.0F - share));
    all[static_cast<std::size_t>(i)] = {(1.0F - share) / length, share / length};
  }
  return all;
}

void fill_correlated(std::uint32_t key, const GaussianTable& gaussians, ImageView<float> out) {
  static const std::array<Blend, kWindow> kBlends = blends();
  const auto node = [&](int i, int j) {
    const auto hash = hash_of(key, static_cast<std::uint32_t>(j));
    return gaussians.of_hash(hash_of(hash, static_cast<std::uint32_t>(i)));
  };
  for (int y = 0; y < out.height; ++y) {
    const Blend down = kBlends[static_cast<std::size_t>(y % kWindow)];
    const auto column = [&](int i) {
      return down.first * node(i, y / kWindow) + down.second * node(i, y / kWindow + 1);
    };
    float left = column(0), right = column(1);
    for (int x = 0; x < out.width; ++x) {
      if (x > 0 && x % kWindow == 0) {
        left = right;
        right = column(x / kWindow + 1);
      }
      const Blend across = kBlends[static_cast<std::size_t>(x % kWindow)];
      out.at(x, y) = across.first * left + across.second * right;
    }
  }
}

}  // namespace

void fill_unit_noise(DepthPrinciple principle, std::uint32_t key, const GaussianTable& gaussians,
                     ImageView<float> out) {
  if (measures_disparity(principle)) return fill_correlated(key, gaussians, out);
  fill_independent(key, gaussians, out);
}

}  // namespace roomcast::simulator
