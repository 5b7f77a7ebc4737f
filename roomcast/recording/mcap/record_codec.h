// SPDX-License-Identifier: Apache-2.0
// MCAP records <-> bytes, one pair of functions for each kind. `append_*` writes whole records,
// `read_*` takes a record's content (what follows opcode and length); nothing where that is
// damaged. Thread-safe (no state).
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

/// Opcode, length and fields of a chunk record in front of its `records`. Uncompressed.
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
  std::uint32_t uncompressed_crc = 0;  // 0: not given
  std::string compression;
  ByteView records;  // compressed
};
[[nodiscard]] std::optional<StoredChunk> read_chunk(ByteView content);

struct Record {
  Opcode opcode{};
  ByteView content;
};
/// Takes the next record off the front of `bytes`; nothing, and `bytes` stays, where it is not
/// whole.
[[nodiscard]] std::optional<Record> take_record(ByteView& bytes);

}  // namespace roomcast::recording::mcap
