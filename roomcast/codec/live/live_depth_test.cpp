// SPDX-License-Identifier: Apache-2.0
// The live depth encoder and decoder together.
#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/codec/live/live_depth_decoder.h"
#include "roomcast/codec/live/live_depth_encoder.h"
#include "roomcast/codec/payload/layer_schedule.h"
#include "roomcast/codec/testing/synthetic_motion.h"

namespace roomcast::codec {
namespace {

struct CodedFrame {
  FrameRole role;
  std::vector<std::uint8_t> bytes;
  DepthImage shown;  // as the encoder expects decoders to show it
};

DepthImage copy_of(DepthView view) {
  DepthImage image(view.width, view.height);
  for (int y = 0; y < view.height; ++y) std::copy_n(view.row(y), view.width, image.view().row(y));
  return image;
}

std::vector<CodedFrame> coded(const SyntheticMotion& scene, int frames, int layers,
                              int key_interval = 1000) {
  LiveDepthEncoder encoder({scene.width, scene.height});
  LayerSchedule schedule(layers, key_interval);
  std::vector<CodedFrame> stream;
  for (int i = 0; i < frames; ++i) {
    CodedFrame& frame = stream.emplace_back();
    frame.role = schedule.next(false);
    encoder.encode(scene.reading(i), frame.role, frame.bytes);
    frame.shown = copy_of(encoder.shown_mm());
  }
  return stream;
}

bool same_state(const LiveState& a, const LiveState& b) {
  return a.picture == b.picture && a.picture_mm == b.picture_mm && a.background == b.background &&
         a.static_age == b.static_age && a.hash == b.hash;
}

class LiveLayers : public testing::TestWithParam<int> {};

TEST_P(LiveLayers, decoder_and_encoder_agree_after_every_frame) {
  const SyntheticMotion scene;
  LiveDepthEncoder encoder({scene.width, scene.height});
  LiveDepthDecoder decoder;
  LayerSchedule schedule(GetParam(), 17);
  DepthImage out(scene.width, scene.height);
  for (int i = 0; i < 40; ++i) {
    std::vector<std::uint8_t> bytes;
    encoder.encode(scene.reading(i), schedule.next(i == 23), bytes);
    ASSERT_TRUE(decoder.decode(bytes, out.view()).ok()) << i;
    ASSERT_EQ(out, copy_of(encoder.shown_mm())) << i;
    ASSERT_TRUE(same_state(encoder.state(), decoder.state())) << i;
  }
}

TEST_P(LiveLayers, upper_layers_can_be_left_out_in_any_pattern) {
  const auto stream = coded({}, 24, GetParam());
  std::mt19937 random(11);
  for (int trial = 0; trial < 6; ++trial) {
    LiveDepthDecoder decoder;
    DepthImage out(128, 96);
    for (const CodedFrame& frame : stream) {
      if (frame.role.layer > 0 && random() % 2) continue;
      ASSERT_TRUE(decoder.decode(frame.bytes, out.view()).ok());
      ASSERT_EQ(out, frame.shown);
    }
  }
}

TEST_P(LiveLayers, a_lost_frame_is_never_shown_wrong_and_a_key_frame_mends_it) {
  const auto stream = coded({}, 30, GetParam(), 12);
  for (std::size_t lost = 0; lost < stream.size(); ++lost) {
    LiveDepthDecoder decoder;
    DepthImage out(128, 96);
    bool expect_refusal = false;
    for (std::size_t i = 0; i < stream.size(); ++i) {
      if (stream[i].role.key) expect_refusal = false;
      if (i == lost) {
        expect_refusal = expect_refusal || stream[i].role.layer == 0;
        continue;
      }
      const bool ok = decoder.decode(stream[i].bytes, out.view()).ok();
      ASSERT_EQ(ok, !expect_refusal) << "frame " << i << " without frame " << lost;
      if (ok) {
        ASSERT_EQ(out, stream[i].shown);
      }
    }
  }
}

TEST_P(LiveLayers, a_late_viewer_sees_nothing_before_a_key_frame_and_all_after_it) {
  const auto stream = coded({}, 30, GetParam(), 12);
  for (std::size_t join = 1; join < 24; ++join) {
    LiveDepthDecoder decoder;
    DepthImage out(128, 96);
    bool joined = false;
    for (std::size_t i = join; i < stream.size(); ++i) {
      joined |= stream[i].role.key;
      ASSERT_EQ(decoder.decode(stream[i].bytes, out.view()).ok(), joined);
      if (joined) {
        ASSERT_EQ(out, stream[i].shown);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Layers, LiveLayers, testing::Values(1, 2, 3));

TEST(LiveDepth, sizes_that_are_no_multiple_of_a_block_work) {
  for (const auto& [width, height] : {std::pair{16, 16}, std::pair{33, 18}, std::pair{47, 95}}) {
    SyntheticMotion scene;
    scene.width = width;
    scene.height = height;
    LiveDepthDecoder decoder;
    DepthImage out(width, height);
    for (const CodedFrame& frame : coded(scene, 12, 2)) {
      ASSERT_TRUE(decoder.decode(frame.bytes, out.view()).ok());
      ASSERT_EQ(out, frame.shown);
    }
  }
}

TEST(LiveDepth, damaged_frames_are_refused_or_harmless_and_a_key_frame_recovers) {
  const auto stream = coded({}, 4, 2);
  std::mt19937 random(3);
  LiveDepthDecoder decoder;
  DepthImage out(128, 96);
  int refused = 0, trials = 0;
  for (int trial = 0; trial < 40; ++trial) {
    for (const CodedFrame& good : stream) {
      std::vector<std::uint8_t> bytes = good.bytes;
      bytes.resize(random() % 3 ? bytes.size() : random() % bytes.size());
      if (!bytes.empty())
        bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1 << random() % 8);
      refused += !decoder.decode(bytes, out.view()).ok();
      ++trials;
    }
    ASSERT_TRUE(decoder.decode(stream[0].bytes, out.view()).ok());
    ASSERT_EQ(out, stream[0].shown);
  }
  EXPECT_GT(refused, trials * 3 / 4);
}

}  // namespace
}  // namespace roomcast::codec
