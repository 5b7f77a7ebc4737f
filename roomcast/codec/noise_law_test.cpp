// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/noise_law.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

constexpr int kBlocks = 1200;

/// Means of blocks from 1 m to 5 m, over three frames after each other.
class NoisyBlocks {
 public:
  explicit NoisyBlocks(double sigma_at_1m_mm) : sigma_at_1m_mm_(sigma_at_1m_mm) {}
  /// The next frame, after the sensor came nearer by `step_mm`; of each ten blocks the first
  /// `covered` see people.
  void next(double step_mm, int covered = 0) {
    frames_.insert(frames_.begin(), std::vector<float>(kBlocks));
    if (frames_.size() > 3) frames_.pop_back();
    nearer_mm_ += step_mm;
    std::normal_distribution<double> gauss;
    for (int i = 0; i < kBlocks; ++i) {
      const double z = 1000 + 4000.0 * i / kBlocks - nearer_mm_;
      const double people = i % 10 < covered ? static_cast<double>(random_() % 400) : 0;
      const double sigma = sigma_at_1m_mm_ * z * z / 1e6;
      frames_.front()[static_cast<std::size_t>(i)] =
          static_cast<float>(z - people + sigma * gauss(random_));
    }
  }
  void teach(NoiseLaw& law) const {
    if (frames_.size() == 3) law.learn({frames_[0], frames_[1], frames_[2]});
  }

 private:
  const double sigma_at_1m_mm_;
  std::vector<std::vector<float>> frames_;
  std::mt19937 random_{7};
  double nearer_mm_ = 0;
};

NoiseLaw learnt(double sigma_at_1m_mm, int frames, double step_mm, int covered = 0) {
  NoisyBlocks blocks(sigma_at_1m_mm);
  NoiseLaw law;
  for (int i = 0; i < frames; ++i) {
    blocks.next(step_mm, covered);
    blocks.teach(law);
  }
  return law;
}

void expect_sigma(const NoiseLaw& law, double sigma_at_1m_mm, double tolerance) {
  for (const float z_m : {2.3f, 3.3f, 4.2f}) {
    const double sigma_mm = sigma_at_1m_mm * z_m * z_m;
    EXPECT_NEAR(law.sigma_mm(1000 * z_m), sigma_mm, tolerance * sigma_mm) << z_m << " m";
  }
}

TEST(NoiseLaw, finds_the_noise_of_a_good_and_of_a_poor_sensor) {
  for (const double sigma_mm : {0.15, 0.5, 1.5})
    expect_sigma(learnt(sigma_mm, 90, 0), sigma_mm, 0.3);
}

TEST(NoiseLaw, half_a_second_is_enough_for_a_start) {
  expect_sigma(learnt(0.3, 15, 0), 0.3, 0.4);
}

TEST(NoiseLaw, motion_at_constant_speed_is_no_noise) {
  constexpr double kHandCarried_mm = 5;
  expect_sigma(learnt(0.4, 60, kHandCarried_mm), 0.4, 0.4);
}

TEST(NoiseLaw, people_in_a_fifth_of_the_blocks_hardly_count) {
  expect_sigma(learnt(0.5, 90, 0, 2), 0.5, 0.6);
}

TEST(NoiseLaw, what_was_never_seen_has_generous_noise_that_grows_with_the_square) {
  const NoiseLaw law = learnt(0.2, 60, 0);
  EXPECT_GT(law.sigma_mm(8000), 20);
  EXPECT_GT(law.sigma_mm(16000), 3 * law.sigma_mm(8000));
}

TEST(NoiseLaw, is_bounded_without_noise_and_without_sense) {
  EXPECT_GT(learnt(0, 90, 0).sigma_mm(3000), 0.1);
  EXPECT_LT(learnt(100, 90, 0).sigma_mm(3000), 100);
}

}  // namespace
}  // namespace roomcast::codec
