// SPDX-License-Identifier: Apache-2.0
// Features of one sensor's colour picture, each with its point in space. Descriptors are RootSIFT
// (Arandjelovic & Zisserman 2012) in 16-bit integers, so that their dot products are exact and
// fast. Metres in the depth camera's frame, pixels of the ColorPicture. Plain data.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace roomcast::alignment {

inline constexpr std::size_t kDescriptorSize = 128;
/// Length of every descriptor; the largest dot product is its square.
inline constexpr int kDescriptorLength = 512;

using Descriptor = std::array<std::int16_t, kDescriptorSize>;

/// Largest descriptor distance; it means that there is no look-alike.
inline constexpr float kNoSimilarFeature = 2;

struct Feature {
  Eigen::Vector3f point_m;
  Eigen::Vector2f pixel;
  float size_m = 0;  // metric size, known for plane-rectified features; else 0
  float nearest_similar_distance = kNoSimilarFeature;  // descriptor distance to the most similar
                                                       // feature elsewhere; small = repeats
};

struct FeatureSet {
  std::vector<Feature> features;
  std::vector<Descriptor> descriptors;  // one per feature

  [[nodiscard]] std::size_t size() const { return features.size(); }
};

/// Converts a SIFT histogram to RootSIFT: its Hellinger kernel becomes a dot product.
[[nodiscard]] Descriptor root_descriptor(std::span<const float, kDescriptorSize> histogram);

/// Euclidean distance, 0..2, of two descriptors with this dot product, scaled to length 1.
[[nodiscard]] float descriptor_distance(std::int32_t dot);

}  // namespace roomcast::alignment
