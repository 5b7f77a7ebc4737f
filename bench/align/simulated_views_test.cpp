// SPDX-License-Identifier: Apache-2.0
#include "bench/align/simulated_views.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

TEST(SimulatedViews, are_the_views_of_a_rooms_sensors) {
  SimulatedViewsOptions options;
  options.scene = "bare";
  options.sensors = 1;
  options.frames = 1;
  options.sensing = options.sensing.clean();
  const auto views = simulate_views(options);
  ASSERT_TRUE(views.ok());
  ASSERT_EQ(views->size(), 1u);
  const SimulatedView& seen = views->front();
  ASSERT_NE(seen.view, nullptr);
  ASSERT_TRUE(seen.view->floor.has_value());
  EXPECT_NEAR(double(seen.view->floor->offset_m), seen.world_from_depth.translation_m.y(), 0.02)
      << "its height above the floor is the true one";
}

TEST(SimulatedViews, of_an_unknown_scene_are_refused) {
  SimulatedViewsOptions options;
  options.scene = "cellar";
  EXPECT_FALSE(simulate_views(options).ok());
}

}  // namespace
}  // namespace roomcast::bench
