// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/rosbag/bag.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/rosbag/bag_fixture.h"

namespace roomcast::recording::rosbag {
namespace {

using std::chrono::seconds;

BagBytes three_messages(const std::string& compression) {
  BagWriter writer(compression);
  writer.message("/a", "std_msgs/String", seconds(5) + nanoseconds(7), "one");
  writer.message("/b", "std_msgs/UInt32", seconds(6), std::string(3000, 'x'));
  writer.end_chunk();
  writer.message("/a", "std_msgs/String", seconds(7), "three");
  return writer.finished();
}

std::string text_of(ByteView bytes) {
  return {bytes.begin(), bytes.end()};
}

TEST(Bag, messages_are_read_from_chunks_of_every_compression) {
  for (const char* compression : {"none", "bz2", "lz4"}) {
    auto bag = Bag::read(bytes_in_memory(three_messages(compression)));
    ASSERT_TRUE(bag.ok()) << compression << bag.error().message;
    EXPECT_FALSE(bag->damage());
    ASSERT_EQ(bag->messages().size(), 3U);
    const MessagePlace last = bag->messages()[2];
    EXPECT_EQ(bag->messages()[0].time, seconds(5) + nanoseconds(7));
    EXPECT_EQ(bag->connections().at(last.connection).topic, "/a");
    EXPECT_EQ(bag->connections().at(bag->messages()[1].connection).type, "std_msgs/UInt32");
    EXPECT_EQ(text_of(*bag->data(last)), "three");
    EXPECT_EQ(text_of(*bag->data(bag->messages()[0])), "one");  // another chunk again
    EXPECT_EQ(bag->data(bag->messages()[1])->size(), 3000U);
  }
}

TEST(Bag, cut_anywhere_it_is_refused_or_read_up_to_there) {
  const BagBytes whole = three_messages("none");
  bool read_first_chunk_alone = false;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    auto bag = Bag::read(
        bytes_in_memory({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}));
    if (!bag) {
      EXPECT_FALSE(bag.error().message.empty());
      continue;
    }
    for (const MessagePlace& place : bag->messages()) EXPECT_TRUE(bag->data(place).ok()) << size;
    read_first_chunk_alone |= bag->messages().size() == 2;
  }
  EXPECT_TRUE(read_first_chunk_alone);
}

TEST(Bag, every_damaged_byte_is_refused_or_survived) {
  const BagBytes whole = three_messages("lz4");
  for (std::size_t at = 0; at < whole.size(); ++at) {
    BagBytes bytes = whole;
    bytes[at] ^= 0xFF;
    auto bag = Bag::read(bytes_in_memory(bytes));
    if (!bag) continue;
    for (const MessagePlace& place : bag->messages()) (void)bag->data(place);
  }
}

TEST(Bag, what_is_no_bag_is_refused) {
  const auto refused = [](const std::string& text) {
    const auto bag = Bag::read(bytes_in_memory({text.begin(), text.end()}));
    EXPECT_FALSE(bag.ok());
    return bag.ok() ? ErrorCode::kClosed : bag.error().code;
  };
  EXPECT_EQ(refused(""), ErrorCode::kMalformed);
  EXPECT_EQ(refused(std::string(500, 'x')), ErrorCode::kMalformed);
  EXPECT_EQ(refused("#ROSBAG V1.2\nxxxxxxxxxx"), ErrorCode::kUnsupported);
  EXPECT_EQ(refused("#ROSBAG V2.0\n"), ErrorCode::kMalformed);
}

TEST(Bag, a_chunk_that_claims_gigabytes_is_refused_before_memory_is_asked_for) {
  std::vector<std::uint8_t> plain;
  const BagBytes few(10);
  EXPECT_EQ(decompress_chunk("lz4", few, 0xFFFFFFFF, plain).error().code, ErrorCode::kTooLarge);
  EXPECT_EQ(decompress_chunk("lz4", few, kMaxChunkBytes, plain).error().code,
            ErrorCode::kMalformed);
  EXPECT_EQ(decompress_chunk("bz2", few, 100, plain).error().code, ErrorCode::kMalformed);
  EXPECT_EQ(decompress_chunk("zip", few, 10, plain).error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(decompress_chunk("none", few, 9, plain).error().code, ErrorCode::kMalformed);
}

}  // namespace
}  // namespace roomcast::recording::rosbag
