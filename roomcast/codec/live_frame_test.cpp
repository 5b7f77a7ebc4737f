// SPDX-License-Identifier: Apache-2.0
// Whole frames with live depth: depth and colour share one temporal layer and are dropped or lost
// together.
#include <random>

#include <gtest/gtest.h>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/codec/payload/payload_sections.h"
#include "roomcast/codec/testing/synthetic_color.h"
#include "roomcast/codec/testing/synthetic_motion.h"

namespace roomcast::codec {
namespace {

constexpr int kLiveWidth = 96, kLiveHeight = 80;

struct Sent {
  EncodedFrameInfo info;
  std::vector<std::uint8_t> payload;
  DepthImage shown;
};

DepthImage depth_copy(DepthView view) {
  DepthImage image(view.width, view.height);
  for (int y = 0; y < view.height; ++y) std::copy_n(view.row(y), view.width, image.view().row(y));
  return image;
}

SyntheticMotion scene() {
  SyntheticMotion scene;
  scene.width = kLiveWidth;
  scene.height = kLiveHeight;
  return scene;
}

class LiveStream {
 public:
  explicit LiveStream(int layers, const FrameTarget& target = {}) {
    FrameEncoderOptions options;
    options.width = kLiveWidth;
    options.height = kLiveHeight;
    options.temporal_layers = layers;
    options.fps = 4;  // a key frame every 16 frames
    encoder_ = std::move(FrameEncoder::create(options)).value();
    encoder_->set_target(target);
  }
  Sent next(bool with_color = true, bool want_key = false) {
    return next_of(scene().reading(count_), with_color, want_key);
  }
  Sent next_of(DepthImage depth_mm, bool with_color = true, bool want_key = false) {
    SyntheticFrame frame = synthetic_frame(kLiveWidth, kLiveHeight, count_++);
    frame.depth_mm = std::move(depth_mm);
    Sent sent;
    sent.info = encoder_
                    ->encode(frame.depth_mm, with_color ? ColorView(frame.color) : ColorView{},
                             with_color ? MaskView(frame.seen) : MaskView{}, want_key, sent.payload)
                    .value();
    sent.shown = depth_copy(encoder_->decoded_depth());
    return sent;
  }

 private:
  std::unique_ptr<FrameEncoder> encoder_;
  int count_ = 0;
};

std::unique_ptr<FrameDecoder> new_decoder() {
  return std::move(FrameDecoder::create(kLiveWidth, kLiveHeight)).value();
}

TEST(LiveFramesTest, frames_follow_a_target_size) {
  constexpr int kFrames = 120, kSettled = 60;
  double sizes[2] = {};
  for (const double target : {250.0, 500.0}) {
    LiveStream stream(2, {.bytes = target, .key_bytes = 4 * target});
    double& mean = sizes[target > 300];
    for (int i = 0; i < kFrames; ++i) {
      const Sent sent = stream.next();
      if (i < kSettled) continue;
      EXPECT_GE(sent.info.quantizer, FrameQuality::kMinQuantizer);
      mean += static_cast<double>(sent.payload.size()) / (kFrames - kSettled);
    }
    EXPECT_NEAR(mean / target, 1, 0.35) << target;
  }
  EXPECT_LT(sizes[0], sizes[1]);
}

class LiveFrames : public testing::TestWithParam<int> {};

TEST_P(LiveFrames, upper_layers_can_be_left_out_with_their_colour) {
  LiveStream stream(GetParam());
  auto all = new_decoder(), lowest = new_decoder();
  std::mt19937 random(1);
  DecodedFrame from_all, from_lowest;
  for (int i = 0; i < 20; ++i) {
    const Sent sent = stream.next();
    EXPECT_EQ(sent.info.key, i % 16 == 0);
    ASSERT_TRUE(all->decode(sent.payload, from_all).ok()) << i;
    ASSERT_EQ(from_all.depth_mm, sent.shown);
    if (sent.info.layer > 0 && random() % 2) continue;
    ASSERT_TRUE(lowest->decode(sent.payload, from_lowest).ok()) << i;
    EXPECT_EQ(from_lowest.depth_mm, from_all.depth_mm);
    EXPECT_EQ(from_lowest.color, from_all.color);
    EXPECT_EQ(from_lowest.color_seen, from_all.color_seen);
  }
}

INSTANTIATE_TEST_SUITE_P(Layers, LiveFrames, testing::Values(1, 2, 3));

TEST(LiveFrame, a_late_viewer_needs_a_key_frame_and_has_all_from_there) {
  LiveStream stream(2);
  auto early = new_decoder(), late = new_decoder();
  DecodedFrame from_early, from_late;
  for (int i = 0; i < 12; ++i) {
    const Sent sent = stream.next(true, i == 7);
    ASSERT_TRUE(early->decode(sent.payload, from_early).ok());
    if (i < 3) continue;
    const bool ok = late->decode(sent.payload, from_late).ok();
    ASSERT_EQ(ok, i >= 7) << i;
    if (!ok) continue;
    EXPECT_EQ(from_late.depth_mm, from_early.depth_mm);
    EXPECT_EQ(from_late.color, from_early.color);
  }
}

TEST(LiveFrame, depth_alone_builds_on_earlier_frames_too) {
  LiveStream stream(2);
  auto decoder = new_decoder();
  DecodedFrame out;
  for (int i = 0; i < 5; ++i) {
    const Sent sent = stream.next(false);
    EXPECT_EQ(sent.info.key, i == 0);
    EXPECT_EQ(sent.info.layer, i % 2);
    ASSERT_TRUE(decoder->decode(sent.payload, out).ok());
    EXPECT_EQ(out.depth_mm, sent.shown);
    EXPECT_TRUE(out.color.empty());
  }
}

TEST(LiveFrame, colour_that_begins_later_begins_with_a_key_frame) {
  LiveStream stream(2);
  auto decoder = new_decoder();
  DecodedFrame out;
  for (int i = 0; i < 4; ++i) (void)stream.next(false);
  const Sent sent = stream.next();
  EXPECT_TRUE(sent.info.key);
  ASSERT_TRUE(decoder->decode(sent.payload, out).ok());
  EXPECT_FALSE(out.color.empty());
}

TEST(LiveFrame, a_colour_mask_belongs_to_the_depth_that_is_shown) {
  LiveStream stream(2);
  auto decoder = new_decoder();
  DecodedFrame out;
  for (int i = 0; i < 8; ++i) {
    ASSERT_TRUE(decoder->decode(stream.next().payload, out).ok());
    for (std::size_t k = 0; k < out.depth_mm.view().pixel_count(); ++k) {
      if (out.depth_mm.data()[k] == 0) {
        ASSERT_EQ(out.color_seen.data()[k], 0);
      }
    }
  }
}

/// A room seen by a sensor that moves towards it.
DepthImage wall_nearer_by(int frames) {
  return scene().reading_from_nearer(10 * frames);
}

int largest_difference_mm(const DepthImage& a, const DepthImage& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.view().pixel_count(); ++i) {
    if ((a.data()[i] == 0) != (b.data()[i] == 0)) return 65535;
    largest = std::max(largest, std::abs(a.data()[i] - b.data()[i]));
  }
  return largest;
}

TEST(LiveFrame, readings_of_a_carried_sensor_are_kept_within_5_mm) {
  LiveStream stream(2);
  auto decoder = new_decoder();
  DecodedFrame out;
  for (int i = 0; i < 24; ++i) {
    const DepthImage reading = wall_nearer_by(i);
    const Sent sent = stream.next_of(reading);
    ASSERT_TRUE(decoder->decode(sent.payload, out).ok()) << i;
    EXPECT_EQ(out.depth_mm, sent.shown);
    if (i >= 8) {
      EXPECT_LE(largest_difference_mm(out.depth_mm, reading), 5) << i;
    }
  }
}

TEST(LiveFrame, live_depth_restarts_with_a_key_frame_when_a_sensor_stops_moving) {
  constexpr int kStandsAgain = 13, kSetInterval = 4;
  LiveStream stream(2);
  auto decoder = new_decoder();
  DecodedFrame out;
  for (int i = 0; i < 12; ++i) {
    ASSERT_TRUE(decoder->decode(stream.next_of(wall_nearer_by(i)).payload, out).ok());
  }
  for (int i = 0; i < 28; ++i) {
    const Sent sent = stream.next_of(wall_nearer_by(11));
    ASSERT_TRUE(decoder->decode(sent.payload, out).ok()) << i;
    EXPECT_EQ(out.depth_mm, sent.shown);
    EXPECT_EQ(sent.info.key, i == kStandsAgain || i == kSetInterval) << i;
    const auto sections = parse_sections(sent.payload, kLiveWidth, kLiveHeight);
    EXPECT_EQ(sections->depth_codec, i < kStandsAgain ? kNearLosslessDepth : kLiveDepth) << i;
  }
}

}  // namespace
}  // namespace roomcast::codec
