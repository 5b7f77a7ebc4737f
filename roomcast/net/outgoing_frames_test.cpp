// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/outgoing_frames.h"

#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

/// A frame of `size` bytes on the wire.
FramedMessagePtr frame_of(std::size_t size) {
  return frame_message(MessageBuffer(std::vector<std::uint8_t>(size - 2)));
}

TEST(OutgoingFrames, gathers_all_frames_of_one_write) {
  OutgoingFrames frames;
  frames.push(frame_of(10));
  frames.push(frame_of(20));
  EXPECT_EQ(boost::asio::buffer_size(frames.gather()), 30U);
  EXPECT_EQ(frames.unwritten_bytes(), 30U);
}

TEST(OutgoingFrames, gathers_no_more_than_the_limit) {
  OutgoingFrames frames;
  for (int i = 0; i < 20; ++i) frames.push(frame_of(10));
  EXPECT_EQ(frames.gather().size(), OutgoingFrames::kMaxGather);
}

TEST(OutgoingFrames, goes_on_where_a_partial_write_ended) {
  OutgoingFrames frames;
  const auto first = frame_of(10);
  const auto second = frame_of(20);
  frames.push(first);
  frames.push(second);
  frames.wrote(4);
  EXPECT_EQ(frames.gather().front().data(), first->wire_bytes().data() + 4);
  EXPECT_EQ(frames.unwritten_bytes(), 26U);
  frames.wrote(6 + 5);
  EXPECT_EQ(frames.count(), 1U);
  EXPECT_EQ(frames.gather().front().data(), second->wire_bytes().data() + 5);
  EXPECT_EQ(frames.gather().front().size(), 15U);
  frames.wrote(15);
  EXPECT_TRUE(frames.empty());
  EXPECT_EQ(frames.unwritten_bytes(), 0U);
}

TEST(OutgoingFrames, releases_a_frame_as_soon_as_it_is_written) {
  OutgoingFrames frames;
  auto frame = frame_of(10);
  const std::weak_ptr<const FramedMessage> watched = frame;
  frames.push(std::move(frame));
  EXPECT_FALSE(watched.expired());
  frames.wrote(10);
  EXPECT_TRUE(watched.expired());
}

TEST(OutgoingFrames, clear_forgets_everything) {
  OutgoingFrames frames;
  frames.push(frame_of(10));
  frames.wrote(3);
  frames.clear();
  EXPECT_TRUE(frames.empty());
  frames.push(frame_of(7));
  EXPECT_EQ(boost::asio::buffer_size(frames.gather()), 7U);
}

}  // namespace
}  // namespace roomcast::net
