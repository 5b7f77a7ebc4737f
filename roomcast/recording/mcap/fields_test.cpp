// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mcap/fields.h"

#include <gtest/gtest.h>

namespace roomcast::recording::mcap {
namespace {

TEST(Fields, come_back_as_they_were_written) {
  std::vector<std::uint8_t> bytes;
  FieldWriter writer(bytes);
  writer.u8(7);
  writer.u16(0x1234);
  writer.u32(0x89ABCDEF);
  writer.u64(0x0123456789ABCDEF);
  writer.time(nanoseconds(-5));
  writer.string("roomcast");
  writer.string_map({{"a", "1"}, {"b", ""}});
  writer.channel_map({{ChannelId{3}, 9}});
  FieldReader reader(bytes);
  EXPECT_EQ(reader.u8(), 7);
  EXPECT_EQ(reader.u16(), 0x1234);
  EXPECT_EQ(reader.u32(), 0x89ABCDEF);
  EXPECT_EQ(reader.u64(), 0x0123456789ABCDEFU);
  EXPECT_EQ(reader.time(), nanoseconds(-5));
  EXPECT_EQ(reader.string(), "roomcast");
  EXPECT_EQ(reader.string_map(), (StringMap{{"a", "1"}, {"b", ""}}));
  EXPECT_EQ(reader.channel_map(), (std::map<ChannelId, std::uint64_t>{{ChannelId{3}, 9}}));
  EXPECT_TRUE(reader.ok());
  EXPECT_TRUE(reader.rest().empty());
}

TEST(Fields, integers_are_little_endian) {
  std::vector<std::uint8_t> bytes;
  FieldWriter(bytes).u32(0x04030201);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{1, 2, 3, 4}));
}

TEST(Fields, a_string_longer_than_the_bytes_is_refused) {
  const std::vector<std::uint8_t> bytes = {255, 255, 255, 255, 'a'};
  FieldReader reader(bytes);
  EXPECT_EQ(reader.string(), "");
  EXPECT_FALSE(reader.ok());
  EXPECT_EQ(reader.u8(), 0);
}

TEST(Fields, a_map_with_a_truncated_last_entry_is_refused) {
  std::vector<std::uint8_t> bytes;
  FieldWriter writer(bytes);
  writer.u32(6);
  writer.string("ab");
  FieldReader reader(bytes);
  reader.string_map();
  EXPECT_FALSE(reader.ok());
}

TEST(Fields, a_record_starts_with_its_length) {
  std::vector<std::uint8_t> bytes;
  append_record(bytes, Opcode::kDataEnd, [](FieldWriter& fields) { fields.u32(0); });
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0x0F, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace roomcast::recording::mcap
