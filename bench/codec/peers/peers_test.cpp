// SPDX-License-Identifier: Apache-2.0
// Round trip of every peer: the decoded frame has the promised quality.
#include "bench/codec/peers/peers.h"

#include <cstdlib>
#include <functional>

#include <gtest/gtest.h>

#include "bench/codec/measure/luma_error.h"
#include "roomcast/codec/testing/synthetic_color.h"

namespace roomcast::bench {
namespace {

constexpr BenchPicture kPicture{96, 64, 30, 900};
constexpr int kFrames = 4;

BenchFrame frame_of(int i) {
  codec::SyntheticFrame made = codec::synthetic_frame(kPicture.width, kPicture.height, i);
  return {std::move(made.depth_mm), std::move(made.color), std::move(made.seen)};
}

struct Session {
  std::vector<BenchFrame> in, out;
  std::vector<FrameCost> cost;
};

using Make = std::function<PeerResult(const BenchPicture&)>;

Session run(const Make& make) {
  auto peer = make(kPicture);
  EXPECT_TRUE(peer.ok()) << peer.error().message;
  Session run;
  for (int i = 0; i < kFrames; ++i) {
    run.in.push_back(frame_of(i));
    run.out.emplace_back();
    const auto cost = (*peer)->run(run.in.back(), i == 0, run.out.back());
    EXPECT_TRUE(cost.ok()) << cost.error().message;
    run.cost.push_back(*cost);
  }
  return run;
}

void expect_exact_depth(const Make& make) {
  const Session all = run(make);
  for (int i = 0; i < kFrames; ++i) {
    EXPECT_EQ(all.out[i].depth_mm, all.in[i].depth_mm);
    EXPECT_GT(all.cost[i].depth_bytes, 0u);
  }
}

TEST(Peers, those_without_loss_give_back_every_depth) {
  expect_exact_depth(make_raw);
  expect_exact_depth(make_gzip);
  expect_exact_depth(make_zstd);
  expect_exact_depth(make_png16);
  expect_exact_depth(make_rvl);
}

TEST(Peers, raw_and_gzip_give_back_every_colour) {
  for (const auto make : {make_raw, make_gzip}) {
    const Session all = run(make);
    for (int i = 0; i < kFrames; ++i) EXPECT_EQ(all.out[i].color, all.in[i].color);
    EXPECT_GT(all.cost[0].color_bytes, 0u);
  }
}

TEST(Peers, temporal_rvl_is_off_by_ten_millimetres_at_most) {
  const Session all =
      run([](const BenchPicture& picture) { return make_temporal_rvl(picture, 10); });
  for (int i = 0; i < kFrames; ++i) {
    for (std::size_t p = 0; p < all.in[i].depth_mm.view().pixel_count(); ++p) {
      const int in = all.in[i].depth_mm.data()[p], out = all.out[i].depth_mm.data()[p];
      ASSERT_TRUE(in == 0 || out == 0 || std::abs(in - out) <= 10);
    }
  }
}

TEST(Peers, av1_keeps_holes_and_stays_near_on_surfaces) {
  const Session all = run([](const BenchPicture& picture) { return make_av1_depth(picture, 10); });
  int near = 0, readings = 0;
  for (std::size_t p = 0; p < all.in[3].depth_mm.view().pixel_count(); ++p) {
    const int in = all.in[3].depth_mm.data()[p], out = all.out[3].depth_mm.data()[p];
    EXPECT_EQ(in == 0, out == 0);
    readings += in != 0;
    near += in != 0 && std::abs(in - out) <= 30;
  }
  EXPECT_GT(near, readings * 3 / 4);
  EXPECT_LT(all.cost[1].depth_bytes, all.cost[0].depth_bytes);
}

TEST(Peers, draco_is_off_by_half_a_step_at_most) {
  for (const int step_mm : {1, 8}) {
    const Session all =
        run([&](const BenchPicture& picture) { return make_draco_depth(picture, step_mm); });
    for (std::size_t p = 0; p < all.in[1].depth_mm.view().pixel_count(); ++p) {
      const int in = all.in[1].depth_mm.data()[p], out = all.out[1].depth_mm.data()[p];
      ASSERT_LE(std::abs(in - out), step_mm / 2);
    }
    EXPECT_GT(all.cost[1].depth_bytes, 0u);
  }
}

TEST(Peers, draco_sends_a_picture_without_a_reading) {
  const auto peer = make_draco_depth(kPicture, 1);
  BenchFrame decoded;
  const auto cost = (*peer)->run({DepthImage(96, 64), {}, {}}, true, decoded);
  ASSERT_TRUE(cost.ok()) << cost.error().message;
  EXPECT_EQ(decoded.depth_mm, DepthImage(96, 64));
}

TEST(Peers, colour_codecs_stay_near_where_colour_is_seen) {
  const Make jpeg = [](const BenchPicture& picture) { return make_jpeg(picture, 85); };
  for (const Make& make : {jpeg, Make(make_h264_color)}) {
    const Session all = run(make);
    LumaError error;
    for (int i = 0; i < kFrames; ++i) error.add(all.out[i].color, all.in[i].color, all.in[i].seen);
    EXPECT_GT(error.psnr_db().value(), 28);
    EXPECT_GT(all.cost[0].color_bytes, 0u);
    EXPECT_EQ(all.cost[0].depth_bytes, 0u);
    EXPECT_TRUE(all.out[0].depth_mm.empty());
  }
}

TEST(Peers, h264_refuses_odd_sides) {
  const auto peer = make_h264_color({97, 64, 30, 900});
  ASSERT_FALSE(peer.ok());
  EXPECT_EQ(peer.error().code, ErrorCode::kUnsupported);
}

}  // namespace
}  // namespace roomcast::bench
