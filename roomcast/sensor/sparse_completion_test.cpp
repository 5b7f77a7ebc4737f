// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sparse_completion.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace roomcast::sensor {
namespace {

constexpr int kAcross = 160, kDown = 120;
constexpr int kWall_mm = 4000;
constexpr int kLeft = 40, kRight = 120, kTop = 30, kBottom = 90;  // of the screen

bool is_screen(int x, int y, int margin = 0) {
  return x >= kLeft + margin && x < kRight - margin && y >= kTop + margin && y < kBottom - margin;
}

/// A screen that is turned by a good deal, before a wall.
float screen_mm(int x) {
  return 1 / (1 / 2000.0F - 5e-7F * static_cast<float>(x - kLeft));
}

DepthImage wall_mm(int depth_mm = kWall_mm) {
  return {kAcross, kDown, static_cast<std::uint16_t>(depth_mm)};
}

/// The screen gives a reading, with noise, in `share` of its pixels.
DepthImage sparse_screen_mm(double share) {
  DepthImage depth_mm = wall_mm();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> luck;
  std::normal_distribution<float> noise_mm(0, 4);
  for (int y = kTop; y < kBottom; ++y) {
    for (int x = kLeft; x < kRight; ++x) {
      const float read_mm = screen_mm(x) + noise_mm(random);
      depth_mm.at(x, y) =
          luck(random) < share ? static_cast<std::uint16_t>(std::lround(read_mm)) : 0;
    }
  }
  return depth_mm;
}

int holes_in(const DepthImage& depth_mm) {
  int count = 0;
  for (int y = 0; y < kDown; ++y) {
    for (int x = 0; x < kAcross; ++x) count += depth_mm.at(x, y) == 0 ? 1 : 0;
  }
  return count;
}

TEST(SparseCompletion, fills_a_screen_that_comes_as_specks) {
  DepthImage depth_mm = sparse_screen_mm(0.25);
  const int before = holes_in(depth_mm);
  ASSERT_GT(before, 3000);
  SparseCompletion completion(kAcross, kDown);
  completion.complete(depth_mm);
  EXPECT_LT(holes_in(depth_mm), before / 10);
  EXPECT_EQ(completion.filled(), before - holes_in(depth_mm));
  double sum_mm = 0, count = 0;
  for (int y = 0; y < kDown; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      if (!is_screen(x, y, 4) || depth_mm.at(x, y) == 0) continue;
      ASSERT_NEAR(depth_mm.at(x, y), screen_mm(x), 20) << x << ", " << y;
      sum_mm += std::abs(static_cast<float>(depth_mm.at(x, y)) - screen_mm(x));
      ++count;
    }
  }
  EXPECT_LT(sum_mm / count, 4);  // less than the readings' own noise
}

bool has_depth_of_screen(const DepthImage& depth_mm, int x, int y) {
  return std::abs(static_cast<float>(depth_mm.at(x, y)) - screen_mm(x)) < 30;
}

/// Of the pixels of the screen at most two from its border, the share with its depth.
double filled_rim(const DepthImage& depth_mm) {
  double filled = 0, all = 0;
  for (int y = kTop; y < kBottom; ++y) {
    for (int x = kLeft; x < kRight; ++x) {
      if (is_screen(x, y, 2)) continue;
      filled += has_depth_of_screen(depth_mm, x, y) ? 1 : 0;
      ++all;
    }
  }
  return filled / all;
}

TEST(SparseCompletion, fills_a_screen_up_to_its_rim_if_what_is_behind_reads_well) {
  DepthImage depth_mm = sparse_screen_mm(0.25);
  ASSERT_LT(filled_rim(depth_mm), 0.3);
  SparseCompletion completion(kAcross, kDown);
  completion.complete(depth_mm);
  EXPECT_GT(filled_rim(depth_mm), 0.9);
}

/// Without readings behind the screen, nothing tells where its rim is.
TEST(SparseCompletion, fills_nothing_beyond_a_screen_before_what_gives_no_readings) {
  DepthImage depth_mm = sparse_screen_mm(0.25);
  for (int y = 0; y < kDown; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      if (!is_screen(x, y)) depth_mm.at(x, y) = 0;
    }
  }
  SparseCompletion completion(kAcross, kDown);
  completion.complete(depth_mm);
  for (int y = 0; y < kDown; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      if (!is_screen(x, y)) {
        ASSERT_EQ(depth_mm.at(x, y), 0) << x << ", " << y;
      }
    }
  }
}

TEST(SparseCompletion, fills_a_screen_behind_a_bar_up_to_the_bar_and_not_the_bar_over_the_screen) {
  constexpr int kBarLeft = 70, kBarRight = 80, kBar_mm = 1500;
  DepthImage depth_mm = sparse_screen_mm(0.25);
  for (int y = 0; y < kDown; ++y) {
    for (int x = kBarLeft; x < kBarRight; ++x) depth_mm.at(x, y) = kBar_mm;
  }
  SparseCompletion completion(kAcross, kDown);
  completion.complete(depth_mm);
  double filled = 0, all = 0;
  for (int y = kTop + 4; y < kBottom - 4; ++y) {
    for (const int x : {kBarLeft - 1, kBarRight}) {
      ASSERT_NE(depth_mm.at(x, y), kBar_mm) << x << ", " << y;
      filled += has_depth_of_screen(depth_mm, x, y) ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(filled / all, 0.9);
}

TEST(SparseCompletion, keeps_readings_as_they_are) {
  const DepthImage read_mm = sparse_screen_mm(0.25);
  DepthImage depth_mm = read_mm;
  SparseCompletion completion(kAcross, kDown);
  completion.complete(depth_mm);
  for (int y = 0; y < kDown; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      if (read_mm.at(x, y) != 0) {
        ASSERT_EQ(depth_mm.at(x, y), read_mm.at(x, y));
      }
    }
  }
}

/// Bars before a wall: what is seen between them is `behind_mm`, one pixel beside each bar has no
/// reading.
DepthImage fence_mm(int gap_px, int behind_mm) {
  constexpr int kBar_px = 3, kFence_mm = 2000;
  DepthImage depth_mm = wall_mm(behind_mm);
  for (int y = 0; y < kDown; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      const int at = x % (kBar_px + gap_px);
      if (at < kBar_px) depth_mm.at(x, y) = kFence_mm;
      if (at == kBar_px || at == kBar_px + gap_px - 1) depth_mm.at(x, y) = 0;
    }
  }
  return depth_mm;
}

TEST(SparseCompletion, leaves_a_fence_open_through_which_a_wall_is_read) {
  for (const int gap_px : {5, 9, 15}) {
    DepthImage depth_mm = fence_mm(gap_px, kWall_mm);
    const int before = holes_in(depth_mm);
    SparseCompletion completion(kAcross, kDown);
    completion.complete(depth_mm);
    EXPECT_EQ(holes_in(depth_mm), before) << gap_px;
  }
}

TEST(SparseCompletion, leaves_wide_gaps_open_behind_which_nothing_is_read) {
  DepthImage depth_mm = fence_mm(9, 0);
  SparseCompletion completion(kAcross, kDown);
  completion.complete(depth_mm);
  EXPECT_EQ(completion.filled(), 0);
}

TEST(SparseCompletion, leaves_readings_at_random_depths_alone) {
  DepthImage depth_mm = wall_mm(0);
  std::mt19937 random(3);
  for (int y = 0; y < kDown; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      if (random() % 4 == 0) depth_mm.at(x, y) = static_cast<std::uint16_t>(500 + random() % 7000);
    }
  }
  SparseCompletion completion(kAcross, kDown);
  completion.complete(depth_mm);
  EXPECT_LT(completion.filled(), kAcross * kDown / 50);
}

/// Structured light loses readings in clumps, at whose borders they come and go.
TEST(SparseCompletion, leaves_holes_in_one_piece_alone) {
  DepthImage depth_mm = wall_mm();
  std::mt19937 random(5);
  for (int clump = 0; clump < 12; ++clump) {
    const int left = 10 + 12 * clump;
    for (int y = 20; y < 80; ++y) {
      const int width = 4 + static_cast<int>(random() % 3);
      for (int x = left; x < left + width; ++x) depth_mm.at(x, y) = 0;
    }
  }
  SparseCompletion completion(kAcross, kDown);
  completion.complete(depth_mm);
  EXPECT_EQ(completion.filled(), 0);
}

TEST(SparseCompletion, takes_any_picture) {
  SparseCompletion completion(kAcross, kDown);
  DepthImage other(kAcross + 1, kDown), empty(kAcross, kDown), none;
  completion.complete(other);
  completion.complete(empty);
  completion.complete(none);
  EXPECT_EQ(completion.filled(), 0);
  DepthImage farthest(kAcross, kDown), nearest(kAcross, kDown);
  for (int y = 0; y < kDown; ++y) {
    for (int x = y % 2; x < kAcross; x += 2) farthest.at(x, y) = 65535, nearest.at(x, y) = 1;
  }
  completion.complete(farthest);
  EXPECT_GT(completion.filled(), kAcross * kDown / 3);
  EXPECT_EQ(farthest.at(81, 60), 65535);
  completion.complete(nearest);
  EXPECT_EQ(nearest.at(81, 60), 1);
  SparseCompletion tiny(3, 2);
  DepthImage few(3, 2, 2000);
  few.at(1, 1) = 0;
  tiny.complete(few);
}

}  // namespace
}  // namespace roomcast::sensor
