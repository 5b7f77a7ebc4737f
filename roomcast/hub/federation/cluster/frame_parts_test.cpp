// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/frame_parts.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub::federation {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes frame_of(std::size_t size, std::uint8_t first) {
  Bytes frame(size);
  std::iota(frame.begin(), frame.end(), first);
  return frame;
}

std::vector<Bytes> unpacked(FrameUnpacker& unpacker, const std::vector<Bytes>& messages) {
  std::vector<Bytes> frames;
  for (const Bytes& message : messages) {
    unpacker.take(message, [&](net::MessageBuffer frame) {
      frames.emplace_back(frame.payload().begin(), frame.payload().end());
    });
  }
  return frames;
}

TEST(FrameParts, frames_that_fit_share_a_message) {
  FramePacker packer(1000);
  const std::vector<Bytes> frames{frame_of(100, 1), frame_of(0, 0), frame_of(300, 2)};
  for (const Bytes& frame : frames) packer.add(frame);
  EXPECT_EQ(packer.frame_count(), 3u);
  const auto messages = packer.take();
  EXPECT_EQ(messages.size(), 1u);
  EXPECT_EQ(packer.frame_count(), 0u);
  EXPECT_TRUE(packer.take().empty());
  FrameUnpacker unpacker;
  EXPECT_EQ(unpacked(unpacker, messages), frames);
}

TEST(FrameParts, marks_the_last_frame_of_a_closed_set) {
  FramePacker packer(1000);
  packer.close_set();
  Bytes frame(wire::kFrameHeaderBytes);
  wire::write_frame_header({}, std::span(frame).first<wire::kFrameHeaderBytes>());
  packer.add(frame);
  packer.add(frame);
  packer.close_set();
  FrameUnpacker unpacker;
  const auto frames = unpacked(unpacker, packer.take());
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_FALSE(wire::parse_frame(frames[0])->last);
  EXPECT_TRUE(wire::parse_frame(frames[1])->last);
}

TEST(FrameParts, a_frame_longer_than_a_message_is_split) {
  FramePacker packer(1000);
  FrameUnpacker unpacker;
  for (const std::size_t size : {988u, 989u, 5000u, 1984u}) {
    const std::vector<Bytes> frames{frame_of(10, 3), frame_of(size, 1)};
    for (const Bytes& frame : frames) packer.add(frame);
    const auto messages = packer.take();
    EXPECT_TRUE(std::ranges::all_of(messages, [](const Bytes& m) { return m.size() <= 1000; }));
    EXPECT_EQ(unpacked(unpacker, messages), frames) << size;
  }
}

TEST(FrameParts, drops_a_frame_with_a_missing_part_and_keeps_the_next) {
  for (std::size_t lost = 0; lost < 3; ++lost) {
    FramePacker packer(1000);
    FrameUnpacker unpacker;
    packer.add(frame_of(2500, 1));
    auto messages = packer.take();
    ASSERT_EQ(messages.size(), 3u);
    messages.erase(messages.begin() + static_cast<std::ptrdiff_t>(lost));
    EXPECT_TRUE(unpacked(unpacker, messages).empty());
    packer.add(frame_of(50, 9));
    EXPECT_EQ(unpacked(unpacker, packer.take()), std::vector<Bytes>{frame_of(50, 9)});
  }
}

TEST(FrameParts, ignores_other_messages) {
  FrameUnpacker unpacker;
  const Bytes too_short(7), empty(8), long_length{0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 1};
  Bytes continues_nothing(20);
  continues_nothing[4] = 1;
  EXPECT_TRUE(unpacked(unpacker, {too_short, empty, long_length, continues_nothing}).empty());
}

TEST(FrameParts, endless_parts_use_the_memory_of_two_frames_at_most) {
  FrameUnpacker unpacker;
  Bytes part(1 << 20);
  std::size_t frames = 0;
  for (std::uint32_t number = 0; number < 16; ++number) {
    part[0] = static_cast<std::uint8_t>(number);
    part[4] = number == 0 ? 2 : 3;  // is continued, and continues
    unpacker.take(part, [&](const net::MessageBuffer&) { ++frames; });
    EXPECT_LE(unpacker.partial_bytes(), 2 * wire::kMaxFrameBytes);
  }
  EXPECT_EQ(frames, 0u);
}

}  // namespace
}  // namespace roomcast::hub::federation
