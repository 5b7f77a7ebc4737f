// SPDX-License-Identifier: Apache-2.0
#include "bench/live_align/filmed_sensor.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

TEST(FilmedSensor, gives_a_bundle_and_pictures_of_any_instant) {
  const auto room = simulator::SimulatedRoom::build("bare", 1).value();
  auto sensor = FilmedSensor::open(room, {}).value();
  const auto bundle = sensor.bundle(2);
  ASSERT_TRUE(bundle.ok()) << bundle.error().message;
  EXPECT_TRUE(same_size(sensor.depth_mm(std::chrono::seconds(9)).view(), bundle->depth_mm.view()));
  EXPECT_TRUE(same_size(sensor.color().view(), bundle->color.view()));
}

}  // namespace
}  // namespace roomcast::bench
