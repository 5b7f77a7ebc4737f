// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/ros/cdr_writer.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/ros/message_reader.h"

namespace roomcast::recording::ros {
namespace {

TEST(CdrWriter, fields_are_aligned_and_texts_end_with_a_zero) {
  CdrWriter writer;
  writer.u8(7).u32(0x01020304).text("ab").u8(9).f64(1);
  const auto message = writer.done();
  const std::vector<std::uint8_t> expected = {
      0, 1, 0, 0,                        // CDR, little-endian
      7, 0, 0, 0, 4,   3,   2,    1,     // one byte, then four that are aligned
      3, 0, 0, 0, 'a', 'b', 0,    9,     // length with the zero
      0, 0, 0, 0, 0,   0,   0xF0, 0x3F,  // eight, aligned from behind the head
  };
  EXPECT_THAT(message, testing::ElementsAreArray(expected));
}

TEST(CdrWriter, what_it_writes_is_read_back) {
  const nanoseconds stamp = std::chrono::seconds(1'700'000'000) + nanoseconds(5);
  CdrWriter writer(100);
  writer.header(stamp, "optical").f64(-2.5);
  std::ranges::fill(writer.bytes(3), 42);
  const std::vector<std::uint8_t> rows = {1, 2, 3, 4};
  writer.u32(4).part(std::span(rows).first(2)).part(std::span(rows).last(2));
  const auto message = writer.u8(1).done();
  EXPECT_EQ(message.size() % 4, 0u);
  MessageReader reader(message, Serialisation::kRos2);
  const auto header = reader.header();
  EXPECT_EQ(header.stamp, stamp);
  EXPECT_EQ(header.frame_id, "optical");
  EXPECT_EQ(reader.f64(), -2.5);
  EXPECT_THAT(reader.bytes(), testing::ElementsAre(42, 42, 42));
  EXPECT_THAT(reader.bytes(), testing::ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(reader.u8(), 1);
  EXPECT_TRUE(reader.ok());
}

}  // namespace
}  // namespace roomcast::recording::ros
