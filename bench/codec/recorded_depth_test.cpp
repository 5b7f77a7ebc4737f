// SPDX-License-Identifier: Apache-2.0
// Depth coding of recordings, where they are available (ROOMCAST_DATA): lossless is bit exact and
// smaller than RVL on each; near-lossless is within its bound at every pixel.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "bench/codec/measure/depth_error.h"
#include "bench/codec/peers/rvl.h"
#include "roomcast/codec/lossless/lossless_depth_decoder.h"
#include "roomcast/codec/lossless/lossless_depth_encoder.h"
#include "roomcast/core/crc32.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::bench {
namespace {

constexpr int kMaxFrames = 4;  // per recording; keeps the test to about a second

std::filesystem::path data_folder() {
  const char* named = std::getenv("ROOMCAST_DATA");
  return named ? named : std::filesystem::path(ROOMCAST_SOURCE_DIR) / "../shared/data";
}

std::uint32_t crc_of(const DepthImage& image) {
  return crc32(std::as_bytes(std::span(image.data(), image.view().pixel_count())));
}

struct Sizes {
  std::size_t ours = 0, rvl = 0;
};

void encode_both(const DepthImage& depth, Sizes& sizes) {
  codec::LosslessDepthEncoder encoder;
  std::vector<std::uint8_t> section, rvl;
  encoder.encode(depth, section);
  DepthImage decoded(depth.width(), depth.height());
  const Status status = codec::LosslessDepthDecoder().decode(section, decoded.view());
  ASSERT_TRUE(status.ok()) << status.error().message;
  EXPECT_EQ(crc_of(decoded), crc_of(depth));
  encode_rvl(std::span<const std::uint16_t>(depth.data(), depth.view().pixel_count()), rvl);
  sizes.ours += section.size();
  sizes.rvl += rvl.size();
}

void expect_within_bound(const DepthImage& depth, int bound_mm) {
  std::vector<std::uint8_t> section;
  codec::LosslessDepthEncoder().encode_near_lossless(depth, bound_mm, section);
  DepthImage decoded(depth.width(), depth.height());
  const Status status = codec::LosslessDepthDecoder().decode_near_lossless(section, decoded.view());
  ASSERT_TRUE(status.ok()) << status.error().message;
  DepthError error;
  error.add(decoded, depth, {});
  EXPECT_LE(error.max_input_mm(), bound_mm);
  EXPECT_EQ(error.lost(), 0);
  EXPECT_EQ(error.extra(), 0);
}

class RecordedDepth : public testing::TestWithParam<const char*> {};

TEST_P(RecordedDepth, is_bit_exact_and_smaller_than_rvl_and_within_every_bound) {
  if (!std::filesystem::exists(data_folder() / "README.md")) {
    GTEST_SKIP() << "no recordings at " << data_folder() << "; set ROOMCAST_DATA to test with them";
  }
  std::string spec = GetParam();
  spec.replace(spec.find('@'), 1, data_folder().string());
  auto source = sensor::open_source(spec, {.pace = source::Pace::kAsFastAsPossible, .loop = false});
  ASSERT_TRUE(source.ok()) << source.error().message;
  source::CapturedFrame frame;
  Sizes sizes;
  for (int i = 0; i < kMaxFrames; ++i) {
    const auto more = (*source)->next(frame, {});
    ASSERT_TRUE(more.ok()) << more.error().message;
    if (!*more) break;
    encode_both(frame.depth_mm, sizes);
    for (const int bound_mm : {1, 2, 5}) expect_within_bound(frame.depth_mm, bound_mm);
  }
  EXPECT_GT(sizes.ours, 0u);
  EXPECT_LT(sizes.ours, sizes.rvl);
}

INSTANTIATE_TEST_SUITE_P(Folders, RecordedDepth,
                         testing::Values("rig:@/house3#s0", "rig:@/house3#s1", "rig:@/house3#s2",
                                         "tum:@/redkitchen_moving", "tum:@/kinect1_oni_fixed",
                                         "tum:@/pcl_laptop_static", "tum:@/pcl_office",
                                         "tum:@/realsense_d435_bag", "tum:@/slambook_home",
                                         "tum:@/azurekinect_room", "tum:@/azurekinect_ceiling"));

}  // namespace
}  // namespace roomcast::bench
