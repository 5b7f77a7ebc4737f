// SPDX-License-Identifier: Apache-2.0
#include "roomcast/scene_flow/window_fit.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::scene_flow {
namespace {

constexpr int kStride = 24, kFitRows = 16;

using Cells = std::vector<std::int16_t>;

/// Computes the same as fit(), one cell after the other.
template <int kReach>
WindowFit plain_fit(const std::int16_t* here, const std::int16_t* there) {
  int both = 0, any = 0, sum = 0;
  for (int i = 0; i < Window<kReach>::kRows * Window<kReach>::kRows; ++i) {
    const int at = i / Window<kReach>::kRows * kStride + i % Window<kReach>::kRows;
    any += here[at] > 0 || there[at] > 0;
    if (here[at] == 0 || there[at] == 0) continue;
    ++both;
    sum += std::clamp(there[at] - here[at], -150, 150);
  }
  if (both == 0) return {};
  const float mean = static_cast<float>(sum) / static_cast<float>(both);
  float cost = static_cast<float>(any - both);
  for (int i = 0; i < Window<kReach>::kRows * Window<kReach>::kRows; ++i) {
    const int at = i / Window<kReach>::kRows * kStride + i % Window<kReach>::kRows;
    if (here[at] == 0 || there[at] == 0) continue;
    cost +=
        static_cast<float>(std::min(std::abs(there[at] - here[at] - static_cast<int>(mean)), 60)) /
        60;
  }
  return {cost / static_cast<float>(any), mean};
}

Cells random_cells(std::mt19937& random) {
  Cells cells(kStride * kFitRows);
  const int depth_mm = std::uniform_int_distribution(500, 31'000)(random);
  for (std::int16_t& cell : cells) {
    const int kind = std::uniform_int_distribution(0, 3)(random);
    const int apart = kind == 1 ? 900 : 40;
    if (kind > 0)
      cell = static_cast<std::int16_t>(
          depth_mm + std::uniform_int_distribution(-apart / 2, apart / 2)(random));
  }
  return cells;
}

template <int kReach>
void expect_as_plain() {
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    const Cells here = random_cells(random), there = random_cells(random);
    const Cells& other = i % 2 == 0 ? there : here;
    const std::int16_t* const from = here.data() + i % 8;
    const std::int16_t* const to = other.data() + kStride + i % 5;
    const WindowFit fits = fit(window_at<kReach>(from, kStride), to, kStride);
    const WindowFit plain = plain_fit<kReach>(from, to);
    EXPECT_FLOAT_EQ(fits.cost, plain.cost) << i;
    EXPECT_FLOAT_EQ(fits.farther_mm, plain.farther_mm) << i;
  }
}

TEST(WindowFit, is_what_the_cells_say_one_by_one) {
  expect_as_plain<2>();
  expect_as_plain<3>();
}

TEST(WindowFit, the_same_place_fits_perfectly) {
  std::mt19937 random(3);
  const Cells cells = random_cells(random);
  const WindowFit fits = fit(window_at<3>(cells.data(), kStride), cells.data(), kStride);
  EXPECT_EQ(fits.cost, 0);
  EXPECT_EQ(fits.farther_mm, 0);
}

TEST(WindowFit, places_without_anything_in_common_do_not_fit) {
  const Cells none(kStride * kFitRows, 0), all(kStride * kFitRows, 2000);
  EXPECT_EQ(fit(window_at<3>(all.data(), kStride), none.data(), kStride).cost, 1);
  EXPECT_EQ(fit(window_at<3>(none.data(), kStride), none.data(), kStride).cost, 1);
}

}  // namespace
}  // namespace roomcast::scene_flow
