// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/simulated_spec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

TEST(SimulatedSpec, alone_it_names_a_scene) {
  EXPECT_EQ(parse_simulated_spec("")->scene, "");
  const SimulatedSpec spec = parse_simulated_spec("lab").value();
  EXPECT_EQ(spec.scene, "lab");
  EXPECT_EQ(spec.speed, 1.0);
  EXPECT_EQ(spec.sensing.camera, simulator::CameraModel::kKinect2);
  EXPECT_TRUE(spec.sensing.half_color);
  EXPECT_TRUE(spec.sensing.noise);
}

TEST(SimulatedSpec, options_follow_in_any_order) {
  const auto spec =
      parse_simulated_spec("lab,speed=0.05,camera=d435,color=full,interference=6").value();
  EXPECT_EQ(spec.speed, 0.05);
  EXPECT_EQ(spec.sensing.camera, simulator::CameraModel::kD435);
  EXPECT_FALSE(spec.sensing.half_color);
  EXPECT_EQ(spec.sensing.interference_per_minute, 6.0);
  const auto clean = parse_simulated_spec(",clean").value();
  EXPECT_EQ(clean.scene, "");
  EXPECT_FALSE(clean.sensing.noise || clean.sensing.calibration_error ||
               clean.sensing.auto_exposure);
}

TEST(SimulatedSpec, a_bump_has_its_time_and_size) {
  EXPECT_FALSE(parse_simulated_spec("lab")->bump_at_s);
  EXPECT_FALSE(parse_simulated_spec("lab")->board);
  EXPECT_TRUE(parse_simulated_spec("lab,board")->board);
  const auto spec = parse_simulated_spec("lab,bump_at=20.5,bump_cm=2,bump_deg=0").value();
  EXPECT_EQ(spec.bump_at_s, 20.5);
  const RigidTransform bump = spec.bump.mount_from_depth();
  EXPECT_NEAR(bump.translation_m.norm(), 0.02, 1e-12);
  EXPECT_TRUE(bump.rotation.isIdentity());
}

TEST(SimulatedSpec, harsh_sensors_are_mixed_or_of_a_kind) {
  EXPECT_EQ(parse_simulated_spec("lab")->sensing.harsh, Harshness::kNone);
  EXPECT_FALSE(parse_simulated_spec("lab")->sensing.mutual_interference);
  EXPECT_TRUE(parse_simulated_spec("lab,mutual")->sensing.mutual_interference);
  EXPECT_TRUE(parse_simulated_spec("lab,harsh=tof")->sensing.mutual_interference);
  EXPECT_FALSE(parse_simulated_spec("lab,harsh,mutual=no")->sensing.mutual_interference);
  EXPECT_EQ(parse_simulated_spec("shelf-rows,harsh")->sensing.harsh, Harshness::kMixed);
  EXPECT_EQ(parse_simulated_spec("lab,harsh=tof")->sensing.harsh, Harshness::kTimeOfFlight);
  EXPECT_EQ(parse_simulated_spec("lab,harsh=structured")->sensing.harsh,
            Harshness::kStructuredLight);
}

TEST(SimulatedSpec, an_unknown_option_is_named) {
  for (const char* text :
       {"lab,", "lab,fast", "lab,camera=leica", "lab,speed=", "lab,speed=-1", "lab,speed=11",
        "lab,speed=1x", "lab,color=grey", "lab,clean=yes", "lab,interference=nan", "lab,bump_at=-1",
        "lab,bump_cm=101", "lab,bump_deg=x", "lab,harsh=", "lab,harsh=very"}) {
    const auto spec = parse_simulated_spec(text);
    ASSERT_FALSE(spec) << text;
    EXPECT_EQ(spec.error().code, ErrorCode::kInvalidArgument);
    const std::string option(std::string_view(text).substr(4));
    EXPECT_THAT(spec.error().message, testing::HasSubstr("\"" + option + "\""));
  }
}

}  // namespace
}  // namespace roomcast::simulator
