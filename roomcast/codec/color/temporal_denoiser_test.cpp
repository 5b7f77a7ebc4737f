// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/temporal_denoiser.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

constexpr int kDenoisedWidth = 64, kDenoisedHeight = 48;

I420Image grey(int level) {
  I420Image image;
  image.resize(kDenoisedWidth, kDenoisedHeight);
  image.y.resize(kDenoisedWidth, kDenoisedHeight, static_cast<std::uint8_t>(level));
  return image;
}

/// A grey picture seen by a camera with noise.
class NoisyCamera {
 public:
  explicit NoisyCamera(double sigma) : noise_(0, sigma) {}
  I420Image picture(const I420Image& clean) {
    I420Image noisy = clean;
    for (std::size_t i = 0; i < noisy.y.view().pixel_count(); ++i) {
      noisy.y.data()[i] =
          static_cast<std::uint8_t>(std::lround(noisy.y.data()[i] + noise_(random_)));
    }
    return noisy;
  }

 private:
  std::mt19937 random_{4};
  std::normal_distribution<double> noise_;
};

double rms(const I420Image& a, const I420Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.y.view().pixel_count(); ++i) {
    sum += std::pow(a.y.data()[i] - b.y.data()[i], 2);
  }
  return std::sqrt(sum / static_cast<double>(a.y.view().pixel_count()));
}

TEST(TemporalDenoiser, a_still_scene_comes_to_rest_nearer_to_the_truth_than_the_camera) {
  NoisyCamera camera(3);
  TemporalDenoiser hold;
  const I420Image clean = grey(120);
  I420Image before;
  int changed = 0;
  for (int i = 0; i < 60; ++i) {
    const I420Image& shown = hold.apply(camera.picture(clean), true);
    if (i > 30) {
      for (std::size_t p = 0; p < shown.y.view().pixel_count(); ++p) {
        changed += shown.y.data()[p] != before.y.data()[p];
      }
    }
    before = shown;
  }
  EXPECT_LT(changed, 29 * kDenoisedWidth * kDenoisedHeight / 100) << "nearly every pixel stays";
  EXPECT_LT(rms(before, clean), 1.5);
  EXPECT_NEAR(hold.noise_sigma(), 3, 0.6);
}

TEST(TemporalDenoiser, a_still_scene_does_not_change_in_frames_that_leave_no_trace) {
  NoisyCamera camera(3);
  TemporalDenoiser hold;
  const I420Image clean = grey(120);
  for (int i = 0; i < 30; ++i) (void)hold.apply(camera.picture(clean), true);
  const I420Image settled = hold.apply(camera.picture(clean), true);
  for (int i = 0; i < 30; ++i) EXPECT_EQ(hold.apply(camera.picture(clean), false).y, settled.y);
}

TEST(TemporalDenoiser, differences_from_the_newest_reference_count_as_changes) {
  NoisyCamera camera(2);
  TemporalDenoiser hold;
  for (int i = 0; i < 30; ++i) (void)hold.apply(camera.picture(grey(120)), true);
  I420Image scene = grey(120);
  for (int y = 16; y < 24; ++y) {
    for (int x = 16; x < 24; ++x) scene.y.at(x, y) = 160;
  }
  const auto changed = [&hold] { return hold.changed().at(2, 2) != 0; };
  (void)hold.apply(camera.picture(scene), false);
  EXPECT_TRUE(changed());
  (void)hold.apply(camera.picture(scene), true);
  EXPECT_TRUE(changed()) << "the reference does not have it yet";
  for (int i = 0; i < 12; ++i) (void)hold.apply(camera.picture(scene), true);
  EXPECT_FALSE(changed());
}

TEST(TemporalDenoiser, changes_pass_at_once) {
  NoisyCamera camera(2);
  TemporalDenoiser hold;
  for (int i = 0; i < 30; ++i) (void)hold.apply(camera.picture(grey(120)), true);
  I420Image scene = grey(120);
  for (int y = 16; y < 32; ++y) {
    for (int x = 16; x < 32; ++x) scene.y.at(x, y) = 160;
  }
  const I420Image input = camera.picture(scene);
  const I420Image& shown = hold.apply(input, true);
  for (int y = 16; y < 32; ++y) {
    for (int x = 16; x < 32; ++x) ASSERT_EQ(shown.y.at(x, y), input.y.at(x, y));
  }
}

TEST(TemporalDenoiser, light_that_fades_slowly_is_followed) {
  NoisyCamera camera(2);
  TemporalDenoiser hold;
  I420Image shown;
  for (int i = 0; i < 100; ++i) shown = hold.apply(camera.picture(grey(150 - i / 4)), true);
  EXPECT_LT(rms(shown, grey(150 - 99 / 4)), 3);
}

TEST(TemporalDenoiser, the_first_picture_passes_as_it_is) {
  TemporalDenoiser hold;
  const I420Image first = NoisyCamera(5).picture(grey(90));
  EXPECT_EQ(hold.apply(first, true).y, first.y);
}

TEST(TemporalDenoiser, what_is_left_out_stays_until_it_is_coded_again) {
  TemporalDenoiser hold;
  for (int i = 0; i < 30; ++i) (void)hold.apply(grey(120), true);
  MaskImage left_out(4, 3, 0);
  left_out.at(1, 1) = 1;
  for (int i = 0; i < 4; ++i) {
    const I420Image& shown = hold.apply(grey(180), true, left_out);
    EXPECT_EQ(shown.y.at(20, 20), 120);
    EXPECT_EQ(shown.y.at(40, 20), 180);
    EXPECT_EQ(hold.changed().at(2, 2), 0);
  }
  EXPECT_EQ(hold.apply(grey(180), true).y.at(20, 20), 180);
  EXPECT_NE(hold.changed().at(2, 2), 0);
}

}  // namespace
}  // namespace roomcast::codec
