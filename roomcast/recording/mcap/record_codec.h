// SPDX-License-Identifier: Apache-2.0
// Encodes and decodes MCAP records, one pair of functions per kind. `append_*` writes a whole
// record. `read_*` takes a record's content (without opcode and length) and returns nothing if it
// is damaged. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/recording/mcap/records.h"

namespace roomcast::recording::mcap {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

void append_header(Bytes& out, std::string_view profile, std::string_view library);
void append_schema(Bytes& out, const Schema& schema);
void append_channel(Bytes& out, const Channel& channel);
void append_message(Bytes& out, const Message& message);
/// (log time, offset in the uncompressed chunk) of each message of a channel.
using MessageOffsets = std::vector<std::pair<nanoseconds, std::uint64_t>>;
void append_message_index(Bytes& out, ChannelId channel, const MessageOffsets& offsets);
void append_chunk_index(Bytes& out, const ChunkIndex& index);
void append_metadata(Bytes& out, std::string_view name, const StringMap& metadata);
void append_metadata_index(Bytes& out, const MetadataIndex& index);
void append_statistics(Bytes& out, const Summary& summary);
void append_data_end(Bytes& out);

/// Appends opcode, length and fields of an uncompressed chunk record, up to its `records`.
void append_chunk_start(Bytes& out, nanoseconds start_time, nanoseconds end_time, ByteView records);

[[nodiscard]] std::optional<Schema> read_schema(ByteView content);
[[nodiscard]] std::optional<Channel> read_channel(ByteView content);
[[nodiscard]] std::optional<Message> read_message(ByteView content);
[[nodiscard]] std::optional<ChunkIndex> read_chunk_index(ByteView content);
[[nodiscard]] std::optional<MetadataIndex> read_metadata_index(ByteView content);
[[nodiscard]] std::optional<Statistics> read_statistics(ByteView content);
struct NamedMetadata {
  std::string name;
  StringMap values;
};
[[nodiscard]] std::optional<NamedMetadata> read_metadata(ByteView content);

struct StoredChunk {
  nanoseconds start_time{}, end_time{};
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;  // 0: not available
  std::string compression;
  ByteView records;  // compressed
};
[[nodiscard]] std::optional<StoredChunk> read_chunk(ByteView content);

struct Record {
  Opcode opcode{};
  ByteView content;
};
/// Removes the next record from the front of `bytes`. Returns nothing and leaves `bytes` unchanged
/// if the record is incomplete.
[[nodiscard]] std::optional<Record> take_record(ByteView& bytes);

}  // namespace roomcast::recording::mcap
