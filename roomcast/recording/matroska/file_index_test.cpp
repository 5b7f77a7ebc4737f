// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/matroska/file_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/matroska/element.h"
#include "roomcast/recording/matroska/matroska_fixture.h"

namespace roomcast::recording::matroska {
namespace {

FixtureBytes tracks() {
  FixtureBytes sound = video_track(2, "IMU", "none", 8, 8);
  const FixtureBytes video_type = number(0x83, 1), other_type = number(0x83, 17);
  const auto at = std::search(sound.begin(), sound.end(), video_type.begin(), video_type.end());
  std::copy(other_type.begin(), other_type.end(), at);
  return element(0x1654AE6B, joined({video_track(1, "DEPTH", "b16g", 4, 2), sound}));
}

std::vector<FixtureBytes> small_parts() {
  return {info(1'000'000'000),
          tracks(),
          element(0x1941A469, attachment("calibration.json", "{}")),
          element(0x1254C367, joined({tag("A", "1"), tag("B", "two"), tag("A", "3")})),
          element(0xEC, FixtureBytes(100)),
          cluster(1000, {simple_block(1, -5, FixtureBytes(16, 1)), simple_block(2, 0, {9})}),
          cluster(34000, {block_group(1, 7, FixtureBytes(16, 2))})};
}

FileIndex read(const FixtureBytes& bytes) {
  const auto index = read_file_index(*bytes_in_memory(bytes));
  EXPECT_TRUE(index.ok()) << (index.ok() ? "" : index.error().message);
  return index.ok() ? *index : FileIndex{};
}

TEST(MatroskaFile, is_indexed_with_tracks_tags_attachments_and_blocks) {
  const FixtureBytes bytes = file_of(small_parts());
  const FileIndex index = read(bytes);
  EXPECT_FALSE(index.damage) << *index.damage;
  EXPECT_EQ(index.writing_program, "k4arecord-test");
  EXPECT_EQ(index.began_utc, nanoseconds(978'307'201'000'000'000));
  ASSERT_EQ(index.tracks.size(), 2U);
  EXPECT_EQ(index.tracks[0].name, "DEPTH");
  EXPECT_EQ(index.tracks[0].width, 4U);
  EXPECT_EQ(index.tracks[0].height, 2U);
  EXPECT_EQ(index.tracks[0].codec, "V_MS/VFW/FOURCC");
  EXPECT_TRUE(index.tracks[0].is_video);
  EXPECT_FALSE(index.tracks[1].is_video);
  EXPECT_THAT(index.tags, testing::ElementsAre(testing::Pair("A", "1"), testing::Pair("B", "two")));
  ASSERT_EQ(index.attachments.size(), 1U);
  EXPECT_EQ(index.attachments[0].bytes.size(), 2U);
  ASSERT_EQ(index.blocks.size(), 2U);
  EXPECT_EQ(index.blocks[0].time, std::chrono::microseconds(995));
  EXPECT_EQ(index.blocks[1].time, std::chrono::microseconds(34007));
  EXPECT_EQ(index.blocks[1].size, 16U);
  EXPECT_EQ(bytes[index.blocks[1].offset], 2);
}

TEST(MatroskaFile, sizes_that_the_writer_did_not_know_end_where_the_next_part_begins) {
  auto parts = small_parts();
  for (std::size_t i = 1; i <= 8; ++i) parts[5][3 + i] = i == 1 ? 0x01 : 0xFF;
  FixtureBytes bytes = file_of(parts);
  const std::size_t segment = head().size();
  for (std::size_t i = 1; i <= 8; ++i) bytes[segment + 3 + i] = i == 1 ? 0x01 : 0xFF;
  const FileIndex index = read(bytes);
  EXPECT_EQ(index.blocks.size(), 2U);
  EXPECT_FALSE(index.damage);
}

TEST(MatroskaFile, cut_anywhere_it_is_refused_or_read_up_to_there) {
  const FixtureBytes whole = file_of(small_parts());
  std::size_t indexed = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto index = read_file_index(
        *bytes_in_memory({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}));
    if (!index) {
      EXPECT_FALSE(index.error().message.empty());
      continue;
    }
    ++indexed;
    EXPECT_TRUE(index->damage) << size;
    for (const Block& block : index->blocks) EXPECT_LE(block.offset + block.size, size);
  }
  EXPECT_GT(indexed, 0U);
}

TEST(MatroskaFile, what_is_no_matroska_file_is_refused) {
  for (const FixtureBytes& bytes :
       {FixtureBytes{}, FixtureBytes(1000, 0xFF), FixtureBytes(1000, 0), text(0x1A45DFA3, "x")}) {
    const auto index = read_file_index(*bytes_in_memory(bytes));
    ASSERT_FALSE(index.ok());
    EXPECT_EQ(index.error().code, ErrorCode::kMalformed);
  }
}

TEST(MatroskaFile, sizes_beyond_the_limits_are_refused_before_anything_is_allocated) {
  auto parts = small_parts();
  FixtureBytes huge = element(0x465C, {});
  huge[2] = 0x01, huge[3] = 0x7F;  // 2^55 bytes
  parts[2] = element(0x1941A469, element(0x61A7, huge));
  EXPECT_FALSE(read_file_index(*bytes_in_memory(file_of(parts))).ok());
  std::vector<FixtureBytes> many = {info(1)};
  FixtureBytes all;
  for (std::uint64_t i = 0; i <= kMaxTracks; ++i)
    all = joined({all, video_track(i + 1, "x", "b16g", 1, 1)});
  many.push_back(element(0x1654AE6B, all));
  EXPECT_EQ(read_file_index(*bytes_in_memory(file_of(many))).error().code, ErrorCode::kTooLarge);
}

TEST(MatroskaFile, variable_integers_have_one_to_eight_bytes) {
  using Bytes = FixtureBytes;
  EXPECT_EQ(read_variable_integer(Bytes{0x81})->value, 1U);
  EXPECT_EQ(read_variable_integer(Bytes{0x40, 0x02})->value, 2U);
  EXPECT_TRUE(read_variable_integer(Bytes{0xFF})->is_unknown);
  EXPECT_EQ(read_variable_integer(Bytes{0x01, 0, 0, 0, 0, 0, 0, 3})->value, 3U);
  EXPECT_FALSE(read_variable_integer(Bytes{0x01, 0}));
  EXPECT_FALSE(read_variable_integer(Bytes{0}));
  EXPECT_FALSE(read_variable_integer(Bytes{}));
}

}  // namespace
}  // namespace roomcast::recording::matroska
