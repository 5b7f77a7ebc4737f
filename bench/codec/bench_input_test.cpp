// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/bench_input.h"

#include <gtest/gtest.h>

#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/simulator/rig/simulate_rig.h"

namespace roomcast::bench {
namespace {

/// A three-frame rig of one simulated sensor with ground truth.
class SimulatedRig : public testing::Test {
 protected:
  void SetUp() override {
    simulator::SimulateRigOptions options;
    options.sensor_count = 1;
    options.seconds = 0.1;
    ASSERT_TRUE(simulator::simulate_rig(folder_ / "rig", options).ok());
  }
  [[nodiscard]] std::string rig() const { return (folder_ / "rig").string(); }

  TemporaryFolder folder_;
};

TEST_F(SimulatedRig, gives_depth_with_its_truth_and_colour_with_a_denoised_reference) {
  for (const std::string& name : {rig(), "rig:" + rig(), "rig:" + rig() + "#s0"}) {
    auto input = open_bench_input(name);
    ASSERT_TRUE(input.ok()) << input.error().message;
    EXPECT_EQ((*input)->fps(), 30);
    EXPECT_EQ((*input)->color_reference(), ColorReference::kDenoised);
    BenchFrame frame;
    BenchTruth truth;
    int frames = 0;
    while ((*input)->next(frame, truth).value()) {
      ++frames;
      ASSERT_EQ(truth.depth_mm.width(), frame.depth_mm.width());
      EXPECT_NE(truth.depth_mm, frame.depth_mm) << "without noise";
      ASSERT_EQ(truth.color.width(), frame.depth_mm.width());
    }
    EXPECT_EQ(frames, 3);
  }
}

TEST_F(SimulatedRig, has_no_truth_without_a_truth_folder) {
  std::filesystem::remove_all(folder_ / "rig/truth");
  auto input = open_bench_input(rig());
  ASSERT_TRUE(input.ok());
  BenchFrame frame;
  BenchTruth truth;
  ASSERT_TRUE((*input)->next(frame, truth).value());
  EXPECT_TRUE(truth.depth_mm.empty());
}

TEST(BenchInput, takes_clean_colour_from_the_truth_if_there_is_one) {
  TemporaryFolder folder;
  simulator::SimulateRigOptions options;
  options.sensor_count = 1;
  options.seconds = 0.04;
  options.truth_color = true;
  ASSERT_TRUE(simulator::simulate_rig(folder / "rig", options).ok());
  auto input = open_bench_input((folder / "rig").string());
  ASSERT_TRUE(input.ok());
  EXPECT_EQ((*input)->color_reference(), ColorReference::kClean);
  BenchFrame frame;
  BenchTruth truth;
  ASSERT_TRUE((*input)->next(frame, truth).value());
  EXPECT_NE(truth.color, frame.color);
  EXPECT_EQ(truth.color.width(), frame.color.width());
}

TEST(BenchInput, the_simulator_gives_clean_depth_and_colour) {
  auto input = open_bench_input("sim#1");
  ASSERT_TRUE(input.ok()) << input.error().message;
  EXPECT_EQ((*input)->color_reference(), ColorReference::kClean);
  BenchFrame frame;
  BenchTruth truth;
  ASSERT_TRUE((*input)->next(frame, truth).value());
  EXPECT_NE(truth.depth_mm, frame.depth_mm);
  EXPECT_NE(truth.color, frame.color);
  EXPECT_EQ(truth.color.width(), frame.color.width());
}

TEST(BenchInput, refuses_unknown_inputs) {
  for (const char* input : {"simulator", "sim#x", "sim:no such scene", "sim#99", "nowhere:else",
                            "rig:/no/such/folder", "rig:/no/such/folder#s0", "tum:/no/such"}) {
    EXPECT_FALSE(open_bench_input(input).ok()) << input;
  }
}

}  // namespace
}  // namespace roomcast::bench
