// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/expected_error.h"

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

RigidTransform sensor_at(double x) {
  RigidTransform pose;
  pose.translation_m.x() = x;
  return pose;
}

TEST(ExpectedError, what_error_explains_is_no_other_place) {
  EXPECT_TRUE(is_same_place(sensor_at(0), sensor_at(0.012), 3));
  EXPECT_FALSE(is_same_place(sensor_at(0), sensor_at(0.014), 3))
      << "three deviations of two poses: 12.7 mm";
}

TEST(ExpectedError, a_few_millimetres_are_none_whatever_is_expected) {
  EXPECT_TRUE(is_same_place(sensor_at(0), sensor_at(0.004), 0));
}

TEST(ExpectedError, who_expects_anything_does_not_take_every_place_for_the_same) {
  EXPECT_FALSE(is_same_place(sensor_at(0), sensor_at(0.06), 1000));
}

}  // namespace
}  // namespace roomcast::alignment
