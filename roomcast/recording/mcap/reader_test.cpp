// SPDX-License-Identifier: Apache-2.0
// Round trips through Writer and Reader; tests/cli checks the files with a third-party reader.
#include "roomcast/recording/mcap/reader.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <zstd.h>

#include "roomcast/core/crc32.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/mcap/fields.h"
#include "roomcast/recording/mcap/writer.h"

namespace roomcast::recording::mcap {
namespace {

Bytes file_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Bytes payload(std::size_t size, std::uint8_t seed) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(seed + 31 * i);
  return bytes;
}

/// Two channels with a message each every 10 ms, in chunks of about 4 messages.
class WrittenFile {
 public:
  explicit WrittenFile(bool finish, int messages = 20) {
    auto writer = Writer::create(path(), {.profile = "", .library = "test", .chunk_bytes = 4000});
    EXPECT_TRUE(writer.ok());
    const SchemaId schema = writer->add_schema("roomcast.Test", "", {});
    const ChannelId a = writer->add_channel(schema, "/a", "x-test", {{"sensor", "s0"}});
    const ChannelId b = writer->add_channel({}, "/b", "json");
    EXPECT_TRUE(writer->add_metadata("about", {{"room", "lab"}}).ok());
    for (int i = 0; i < messages; ++i) {
      const Bytes data = payload(1000, static_cast<std::uint8_t>(i));
      EXPECT_TRUE(writer
                      ->add_message({.channel = i % 2 ? b : a,
                                     .sequence = static_cast<std::uint32_t>(i / 2),
                                     .log_time = std::chrono::milliseconds(10 * i),
                                     .publish_time = std::chrono::milliseconds(10 * i - 3),
                                     .data = data})
                      .ok());
    }
    if (finish) {
      EXPECT_TRUE(writer->finish().ok());
    }
  }
  [[nodiscard]] std::filesystem::path path() const { return folder_ / "a.mcap"; }

 private:
  TemporaryFolder folder_;
};

std::size_t expect_messages_in_order(const Reader& reader) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < reader.summary().chunks.size(); ++i) {
    const auto chunk = reader.chunk(i);
    EXPECT_TRUE(chunk.ok());
    for (const Message& message : chunk->messages) {
      EXPECT_EQ(message.log_time, std::chrono::milliseconds(10 * count));
      EXPECT_EQ(message.publish_time, message.log_time - std::chrono::milliseconds(3));
      EXPECT_EQ(message.sequence, count / 2);
      EXPECT_EQ(message.channel.value, count % 2);
      EXPECT_EQ(Bytes(message.data.begin(), message.data.end()),
                payload(1000, static_cast<std::uint8_t>(count)));
      ++count;
    }
  }
  return count;
}

TEST(McapReader, reads_files_of_the_writer) {
  const WrittenFile file(true);
  const auto reader = Reader::open(file.path());
  ASSERT_TRUE(reader.ok()) << reader.error().message;
  EXPECT_FALSE(reader->damage().has_value());
  EXPECT_EQ(expect_messages_in_order(*reader), 20u);
  EXPECT_EQ(reader->summary().statistics.message_count, 20u);
  EXPECT_EQ(reader->summary().statistics.end_time, std::chrono::milliseconds(190));
  EXPECT_EQ(reader->summary().statistics.channel_message_counts.at(ChannelId{0}), 10u);
  EXPECT_EQ(reader->summary().channels.at(ChannelId{0}).topic, "/a");
  EXPECT_EQ(reader->summary().channels.at(ChannelId{0}).metadata.at("sensor"), "s0");
  EXPECT_EQ(reader->summary().schemas.at(SchemaId{1}).name, "roomcast.Test");
  EXPECT_EQ(reader->metadata("about")->at("room"), "lab");
  EXPECT_EQ(reader->metadata("other").error().code, ErrorCode::kNotFound);
}

TEST(McapReader, a_file_without_an_end_is_read_up_to_its_last_chunk) {
  const WrittenFile file(false);
  const auto reader = Reader::open(file.path());
  ASSERT_TRUE(reader.ok());
  ASSERT_TRUE(reader->damage().has_value());
  EXPECT_NE(reader->damage()->find("its end is missing"), std::string::npos);
  EXPECT_EQ(expect_messages_in_order(*reader), 20u);
  EXPECT_EQ(reader->summary().statistics.message_count, 20u);
  EXPECT_EQ(reader->sound_bytes(), std::filesystem::file_size(file.path()));
  EXPECT_EQ(reader->metadata("about")->at("room"), "lab");
}

TEST(McapReader, a_file_that_is_cut_anywhere_is_read_up_to_there) {
  const WrittenFile file(true);
  const Bytes whole = file_bytes(file.path());
  std::size_t before = 0;
  for (std::size_t size = kMagic.size(); size < whole.size(); size += 97) {
    const auto reader = Reader::read(
        bytes_in_memory({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}), "cut");
    ASSERT_TRUE(reader.ok());
    EXPECT_TRUE(reader->damage().has_value());
    const std::size_t count = expect_messages_in_order(*reader);
    EXPECT_GE(count, before);
    before = count;
  }
  EXPECT_EQ(before, 20u);
}

TEST(McapReader, a_flipped_bit_in_a_chunk_is_noticed_and_others_are_read) {
  const WrittenFile file(true);
  Bytes bytes = file_bytes(file.path());
  const auto sound = Reader::open(file.path());
  bytes[sound->summary().chunks[1].offset + 500] ^= 4;
  const auto reader = Reader::read(bytes_in_memory(bytes), "flipped");
  ASSERT_TRUE(reader.ok());
  EXPECT_TRUE(reader->chunk(0).ok());
  ASSERT_FALSE(reader->chunk(1).ok());
  EXPECT_EQ(reader->chunk(1).error().message, "flipped: the checksum of a chunk is wrong");
  EXPECT_TRUE(reader->chunk(2).ok());
}

TEST(McapReader, a_summary_with_a_wrong_checksum_is_ignored) {
  const WrittenFile file(true);
  Bytes bytes = file_bytes(file.path());
  bytes[bytes.size() - 100] ^= 1;
  const auto reader = Reader::read(bytes_in_memory(bytes), "flipped");
  ASSERT_TRUE(reader.ok());
  EXPECT_NE(reader->damage()->find("checksum of its summary"), std::string::npos);
  EXPECT_EQ(expect_messages_in_order(*reader), 20u);
}

TEST(McapReader, other_files_are_refused) {
  for (const Bytes& bytes : {Bytes{}, Bytes(7, 0x89), Bytes(1000, 0), payload(1000, 1)}) {
    const auto reader = Reader::read(bytes_in_memory(bytes), "x");
    ASSERT_FALSE(reader.ok());
    EXPECT_EQ(reader.error().message, "x: it is not an MCAP file");
  }
  EXPECT_EQ(Reader::open("/no/such/file").error().code, ErrorCode::kNotFound);
  EXPECT_EQ(Reader::open("/tmp").error().code, ErrorCode::kNotFound);
}

TEST(McapReader, a_chunk_that_claims_to_be_huge_is_not_allocated) {
  Bytes record;
  FieldWriter fields(record);
  fields.time({});
  fields.time({});
  fields.u64(std::uint64_t{1} << 60U);
  fields.u32(0);
  fields.string("zstd");
  fields.u64(0);
  const auto chunk = open_chunk(record);
  ASSERT_FALSE(chunk.ok());
  EXPECT_EQ(chunk.error().code, ErrorCode::kTooLarge);
}

TEST(McapReader, reads_chunks_compressed_by_other_programs) {
  Bytes plain;
  append_channel(
      plain,
      {.id = ChannelId{4}, .schema = {}, .topic = "/z", .message_encoding = {}, .metadata = {}});
  const Bytes data = payload(5000, 9);
  append_message(
      plain,
      {.channel = ChannelId{4}, .sequence = 1, .log_time = {}, .publish_time = {}, .data = data});
  Bytes packed(ZSTD_compressBound(plain.size()));
  packed.resize(ZSTD_compress(packed.data(), packed.size(), plain.data(), plain.size(), 3));
  Bytes record;
  FieldWriter fields(record);
  fields.time({});
  fields.time({});
  fields.u64(plain.size());
  fields.u32(crc32(std::as_bytes(std::span(plain))));
  fields.string("zstd");
  fields.u64(packed.size());
  fields.bytes(packed);
  auto chunk = open_chunk(record);
  ASSERT_TRUE(chunk.ok()) << chunk.error().message;
  ASSERT_EQ(chunk->messages.size(), 1u);
  EXPECT_EQ(Bytes(chunk->messages[0].data.begin(), chunk->messages[0].data.end()), data);
  record[record.size() / 2] ^= 1;
  EXPECT_FALSE(open_chunk(record).ok());
}

TEST(McapReader, a_compression_that_it_does_not_know_is_named) {
  Bytes record;
  FieldWriter fields(record);
  fields.bytes(Bytes(28, 0));
  fields.string("lz4");
  fields.u64(0);
  const auto chunk = open_chunk(record);
  ASSERT_FALSE(chunk.ok());
  EXPECT_EQ(chunk.error().code, ErrorCode::kUnsupported);
  EXPECT_NE(chunk.error().message.find("lz4"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::recording::mcap
