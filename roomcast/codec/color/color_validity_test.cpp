// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/color_validity.h"

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

/// Whether seen colour at one pixel is valid.
bool counts(std::uint16_t measured_mm, std::uint16_t shown_mm) {
  ColorValidity surface;
  surface.update(DepthImage(1, 1, measured_mm), DepthImage(1, 1, shown_mm), MaskImage(1, 1, 255));
  EXPECT_EQ(surface.depth_mm().at(0, 0), surface.seen().at(0, 0) ? measured_mm : 0);
  return surface.seen().at(0, 0) != 0;
}

TEST(ColorValidity, a_reading_on_the_coloured_surface_counts) {
  EXPECT_TRUE(counts(2000, 2000));
  EXPECT_TRUE(counts(2070, 2000)) << "noise";
  EXPECT_TRUE(counts(1930, 2000));
}

TEST(ColorValidity, a_reading_of_another_surface_does_not_count) {
  EXPECT_FALSE(counts(2080, 2000));
  EXPECT_FALSE(counts(1200, 2000));
  EXPECT_FALSE(counts(0, 2000));
  EXPECT_FALSE(counts(2000, 0));
}

TEST(ColorValidity, an_unseen_pixel_stays_unseen) {
  ColorValidity surface;
  surface.update(DepthImage(1, 1, 900), DepthImage(1, 1, 900), MaskImage(1, 1, 0));
  EXPECT_EQ(surface.seen().at(0, 0), 0);
  EXPECT_EQ(surface.depth_mm().at(0, 0), 900);
}

TEST(ColorValidity, a_color_without_a_reading_is_sent_but_does_not_count) {
  ColorValidity surface;
  const MaskImage known(1, 1, 255);
  surface.update(DepthImage(1, 1), DepthImage(1, 1), known);
  EXPECT_EQ(surface.seen().at(0, 0), 0);
  EXPECT_EQ(surface.colored().at(0, 0), 255);
  surface.update(DepthImage(1, 1), DepthImage(1, 1, 900), known);
  EXPECT_EQ(surface.colored().at(0, 0), 0) << "a reading that vanished for a moment is kept";
}

}  // namespace
}  // namespace roomcast::codec
