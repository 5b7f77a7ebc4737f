// SPDX-License-Identifier: Apache-2.0
// Coding depth frame after frame allocates no memory once every buffer has reached its size.
#include <atomic>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "roomcast/codec/live/live_depth_decoder.h"
#include "roomcast/codec/live/live_depth_encoder.h"
#include "roomcast/codec/lossless/lossless_depth_decoder.h"
#include "roomcast/codec/lossless/lossless_depth_encoder.h"
#include "roomcast/codec/mask/color_mask.h"
#include "roomcast/codec/payload/layer_schedule.h"
#include "roomcast/codec/payload/payload_sections.h"
#include "roomcast/codec/testing/synthetic_color.h"
#include "roomcast/codec/testing/synthetic_motion.h"

namespace {
std::atomic<int> allocation_count{0};  // of the whole test program
}

// Not inlined: GCC would see free() of memory from operator new and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocation_count;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace roomcast::codec {
namespace {

TEST(SteadyMemory, coding_depth_and_mask_allocates_nothing_after_the_first_frames) {
  const SyntheticFrame frames[] = {synthetic_frame(96, 80, 0), synthetic_frame(96, 80, 1)};
  LosslessDepthEncoder encoder;
  LosslessDepthDecoder decoder;
  ColorMaskEncoder mask_encoder;
  ColorMaskDecoder mask_decoder;
  FrameRole role{true, 0};
  std::vector<std::uint8_t> section, mask_section;
  DepthImage depth(96, 80);
  MaskImage mask(96, 80);
  const auto code = [&](const SyntheticFrame& frame) {
    section.clear();
    mask_section.clear();
    encoder.encode(frame.depth_mm, section);
    mask_encoder.encode(frame.seen, frame.depth_mm, role, mask_section);
    const bool ok = decoder.decode(section, depth.view()).ok();
    const std::uint8_t codec = std::exchange(role.key, false) ? kIntraMask : kMaskChange;
    return ok && mask_decoder.decode(codec, mask_section, depth, mask.view()).ok();
  };
  for (const SyntheticFrame& frame : frames) ASSERT_TRUE(code(frame));
  const int before = allocation_count;
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(code(frames[i % 2]));
  EXPECT_EQ(allocation_count, before);
}

TEST(SteadyMemory, coding_live_depth_allocates_nothing_between_key_frames) {
  const SyntheticMotion scene{.width = 96, .height = 80};
  std::vector<DepthImage> readings;
  for (int i = 0; i < 24; ++i) readings.push_back(scene.reading(i));
  LiveDepthEncoder encoder({scene.width, scene.height});
  LiveDepthDecoder decoder;
  LayerSchedule schedule(2, 1000);
  DepthImage depth(scene.width, scene.height);
  std::vector<std::uint8_t> section;
  section.reserve(100'000);
  int before = 0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (i == 4) before = allocation_count;
    section.clear();
    encoder.encode(readings[i], schedule.next(false), section);
    ASSERT_TRUE(decoder.decode(section, depth.view()).ok());
  }
  EXPECT_EQ(allocation_count, before);
}

}  // namespace
}  // namespace roomcast::codec
