// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/curves/curve_choices.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "roomcast/codec/testing/synthetic_color.h"

namespace roomcast::bench {
namespace {

TEST(CurveChoices, every_point_is_on_a_curve_and_there_once) {
  std::set<std::string> names, curves;
  const std::vector<CodecChoice> choices = curve_choices();
  for (const CodecChoice& choice : choices) {
    EXPECT_FALSE(choice.curve.empty()) << choice.codec << " " << choice.mode;
    names.insert(choice.codec + " " + choice.mode);
    curves.insert(choice.curve);
  }
  EXPECT_EQ(names.size(), choices.size());
  EXPECT_GE(curves.size(), 8u);
}

/// The bytes of five frames, of what each choice of a curve makes.
std::vector<std::size_t> bytes_of_curve(const std::string& curve) {
  std::vector<std::size_t> bytes;
  for (const CodecChoice& choice : curve_choices()) {
    if (choice.curve != curve) continue;
    const auto codec = choice.make({128, 96, 15, 400});
    EXPECT_TRUE(codec.ok()) << choice.mode;
    bytes.push_back(0);
    for (int i = 0; i < 5; ++i) {
      codec::SyntheticFrame made = codec::synthetic_frame(128, 96, i);
      BenchFrame decoded;
      const auto cost = (*codec)->run(
          {std::move(made.depth_mm), std::move(made.color), std::move(made.seen)}, i == 0, decoded);
      EXPECT_TRUE(cost.ok()) << choice.mode;
      bytes.back() += cost->depth_bytes + cost->color_bytes;
    }
  }
  return bytes;
}

TEST(CurveChoices, coarser_qualities_take_fewer_bytes) {
  for (const char* curve : {"temporal RVL", "Draco"}) {  // finest first
    const std::vector<std::size_t> bytes = bytes_of_curve(curve);
    EXPECT_GE(bytes.size(), 3u) << curve;
    EXPECT_TRUE(std::ranges::is_sorted(bytes, std::ranges::greater())) << curve;
  }
  EXPECT_TRUE(std::ranges::is_sorted(bytes_of_curve("JPEG")));
  // Neighbouring qualities of AV1 can change places on such small pictures.
  const std::vector<std::size_t> av1 = bytes_of_curve("AV1, 12 bit");
  EXPECT_GT(av1.front(), av1.back());
}

}  // namespace
}  // namespace roomcast::bench
