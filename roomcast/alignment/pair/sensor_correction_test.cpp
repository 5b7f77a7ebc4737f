// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/sensor_correction.h"

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

TEST(DepthUncertainty, surfaces_that_agree_leave_calibrated_sensors_as_they_are) {
  const DepthUncertainty doubt = DepthUncertainty{}.given(0.0004);
  EXPECT_LT(doubt.scale, 0.002);
  EXPECT_DOUBLE_EQ(doubt.common_scale, DepthUncertainty{}.common_scale);
}

TEST(DepthUncertainty, surfaces_that_disagree_raise_doubts_about_the_scale) {
  const DepthUncertainty doubt = DepthUncertainty{}.given(0.002);
  EXPECT_GT(doubt.scale, 0.9 * doubt.uncalibrated_scale);
  EXPECT_GT(doubt.offset_m, 0.002);
}

TEST(DepthUncertainty, grows_with_disagreement) {
  double before = 0;
  for (const double disagreement_m : {0.0, 0.0005, 0.001, 0.0015, 0.01}) {
    const double scale = DepthUncertainty{}.given(disagreement_m).scale;
    EXPECT_GT(scale, before);
    EXPECT_LT(scale, 0.041);
    before = scale;
  }
}

TEST(DepthUncertainty, what_is_said_is_doubted_more_readily_than_a_pose_is_weighed) {
  const DepthUncertainty doubt;
  for (const double disagreement_m : {0.00055, 0.0008, 0.0011})
    EXPECT_LT(doubt.weighed_given(disagreement_m).scale, doubt.given(disagreement_m).scale);
  EXPECT_NEAR(doubt.weighed_given(0.003).scale, doubt.given(0.003).scale, 0.001);
}

}  // namespace
}  // namespace roomcast::alignment
