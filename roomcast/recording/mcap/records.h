// SPDX-License-Identifier: Apache-2.0
// The records of an MCAP file as plain data, after the MCAP specification, version 0
// (https://mcap.dev/spec). Times are nanoseconds since an epoch that the writing program chooses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"

namespace roomcast::recording::mcap {

inline constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

enum class Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

inline constexpr std::size_t kRecordHeaderBytes = 9;  // opcode and length
inline constexpr std::size_t kFooterBytes = kRecordHeaderBytes + 20;

// Limits of a reader, so that an untrusted file cannot make it allocate more.
inline constexpr std::size_t kMaxChunkBytes = 64U << 20U;     // as stored, and uncompressed
inline constexpr std::size_t kMaxSummaryBytes = 256U << 20U;  // a recording of many days
inline constexpr std::size_t kMaxMetadataBytes = 1U << 20U;

using SchemaId = Id<struct McapSchemaTag, std::uint16_t>;  // 0: none
using ChannelId = Id<struct McapChannelTag, std::uint16_t>;
using StringMap = std::map<std::string, std::string>;

struct Schema {
  SchemaId id{};
  std::string name;
  std::string encoding;
  std::vector<std::uint8_t> data;
};

struct Channel {
  ChannelId id{};
  SchemaId schema{};
  std::string topic;
  std::string message_encoding;
  StringMap metadata;
};

/// `data` points into the chunk that the message was read from.
struct Message {
  ChannelId channel{};
  std::uint32_t sequence = 0;
  nanoseconds log_time{};
  nanoseconds publish_time{};
  std::span<const std::uint8_t> data;
};

struct ChunkIndex {
  nanoseconds start_time{}, end_time{};  // of its messages' log times
  std::uint64_t offset = 0;              // of the chunk record, from the start of the file
  std::uint64_t length = 0;              // of the whole record
  /// Offset of the index record of each channel with messages in the chunk. Empty if the writer
  /// omitted them; offsets are 0 if the file was read from its beginning.
  std::map<ChannelId, std::uint64_t> message_index_offsets;
  std::uint64_t message_index_length = 0;
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;
};

struct MetadataIndex {
  std::uint64_t offset = 0, length = 0;
  std::string name;
};

struct Statistics {
  std::uint64_t message_count = 0;
  nanoseconds start_time{}, end_time{};
  std::map<ChannelId, std::uint64_t> channel_message_counts;
};

/// The file's index: everything a reader needs before it reads a message.
struct Summary {
  std::map<SchemaId, Schema> schemas;
  std::map<ChannelId, Channel> channels;
  std::vector<ChunkIndex> chunks;
  std::vector<MetadataIndex> metadata;
  Statistics statistics;
};

}  // namespace roomcast::recording::mcap
