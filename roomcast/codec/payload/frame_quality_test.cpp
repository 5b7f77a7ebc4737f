// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/payload/frame_quality.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

constexpr std::size_t kPixels = 512 * 424;
constexpr FrameRole kKeyRole{.key = true, .layer = 0}, kReferenceRole{.key = false, .layer = 0},
    kDroppableRole{.key = false, .layer = 1};

/// A camera whose colour frames halve in size every `halving` steps of the quantiser.
struct Camera {
  double reference_at_zero = 40'000, droppable_at_zero = 12'000, depth = 800, halving = 11;

  [[nodiscard]] double color(const FrameRole& role, int quantizer) const {
    const double at_zero = role.key          ? 12 * reference_at_zero
                           : role.layer == 0 ? reference_at_zero
                                             : droppable_at_zero;
    return at_zero * std::exp2(-quantizer / halving);
  }
};

/// Mean size of the last `counted` of `frames` frames, of both layers in turn.
double mean_bytes(FrameQuality& quality, const Camera& camera, int frames, int counted) {
  double sum = 0;
  for (int i = 0; i < frames; ++i) {
    const FrameRole role = i % 2 == 0 ? kReferenceRole : kDroppableRole;
    quality.choose(role, kPixels);
    const double color = camera.color(role, quality.quantizer());
    quality.coded(static_cast<std::size_t>(camera.depth), static_cast<std::size_t>(color));
    if (i >= frames - counted) sum += camera.depth + color;
  }
  return sum / counted;
}

TEST(FrameQuality, frames_have_the_wanted_size_on_average) {
  for (const double wanted : {1'500.0, 3'000.0, 8'000.0}) {
    FrameQuality quality;
    quality.set_target({.bytes = wanted, .key_bytes = 10 * wanted});
    EXPECT_NEAR(mean_bytes(quality, {}, 60, 20) / wanted, 1, 0.08) << wanted;
  }
}

TEST(FrameQuality, follows_a_scene_that_begins_to_move) {
  FrameQuality quality;
  quality.set_target({.bytes = 4'000, .key_bytes = 30'000});
  mean_bytes(quality, {}, 40, 10);
  const Camera busy{.reference_at_zero = 160'000, .droppable_at_zero = 50'000, .depth = 1'500};
  EXPECT_NEAR(mean_bytes(quality, busy, 16, 10), 4'000, 600);
}

TEST(FrameQuality, a_key_frame_does_not_change_the_quality_of_the_frames_after_it) {
  FrameQuality quality;
  quality.set_target({.bytes = 3'000, .key_bytes = 6'000});
  mean_bytes(quality, {}, 40, 10);
  const int before = quality.quantizer();
  quality.choose(kKeyRole, kPixels);
  EXPECT_GT(quality.quantizer(), before);
  quality.coded(3'000, 3'000);
  quality.choose(kReferenceRole, kPixels);
  EXPECT_NEAR(quality.quantizer(), before, 3);
}

TEST(FrameQuality, stays_within_its_limits_whatever_is_wanted) {
  for (const double wanted : {1.0, 1e9}) {
    FrameQuality quality;
    quality.set_target({.bytes = wanted, .key_bytes = wanted});
    mean_bytes(quality, {}, 20, 1);
    EXPECT_EQ(quality.quantizer(),
              wanted > 1e6 ? FrameQuality::kMinQuantizer : FrameQuality::kMaxQuantizer);
    EXPECT_GE(quality.depth_step(), FrameQuality::kMinDepthStep);
    EXPECT_LE(quality.depth_step(), FrameQuality::kMaxDepthStep);
  }
}

TEST(FrameQuality, without_colour_depth_alone_follows_the_target) {
  FrameQuality quality;
  quality.set_target({.bytes = 1'000, .key_bytes = 10'000});
  const double usual_step = quality.depth_step();
  for (int i = 0; i < 40; ++i) {
    quality.choose(kReferenceRole, 0);
    quality.coded(static_cast<std::size_t>(4'000 / quality.depth_step()), 0);
  }
  EXPECT_NEAR(quality.depth_step(), 4, 0.5);
  EXPECT_NE(quality.depth_step(), usual_step);
}

}  // namespace
}  // namespace roomcast::codec
