// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mcap/record_codec.h"

#include "roomcast/core/crc32.h"
#include "roomcast/recording/mcap/fields.h"

namespace roomcast::recording::mcap {
namespace {

template <class T>
std::optional<T> if_whole(const FieldReader& fields, T value) {
  if (!fields.ok()) return std::nullopt;
  return value;
}

}  // namespace

void append_header(Bytes& out, std::string_view profile, std::string_view library) {
  append_record(out, Opcode::kHeader, [&](FieldWriter& fields) {
    fields.string(profile);
    fields.string(library);
  });
}

void append_schema(Bytes& out, const Schema& schema) {
  append_record(out, Opcode::kSchema, [&](FieldWriter& fields) {
    fields.u16(schema.id.value);
    fields.string(schema.name);
    fields.string(schema.encoding);
    fields.u32(static_cast<std::uint32_t>(schema.data.size()));
    fields.bytes(schema.data);
  });
}

void append_channel(Bytes& out, const Channel& channel) {
  append_record(out, Opcode::kChannel, [&](FieldWriter& fields) {
    fields.u16(channel.id.value);
    fields.u16(channel.schema.value);
    fields.string(channel.topic);
    fields.string(channel.message_encoding);
    fields.string_map(channel.metadata);
  });
}

void append_message(Bytes& out, const Message& message) {
  append_record(out, Opcode::kMessage, [&](FieldWriter& fields) {
    fields.u16(message.channel.value);
    fields.u32(message.sequence);
    fields.time(message.log_time);
    fields.time(message.publish_time);
    fields.bytes(message.data);
  });
}

void append_message_index(Bytes& out, ChannelId channel, const MessageOffsets& offsets) {
  append_record(out, Opcode::kMessageIndex, [&](FieldWriter& fields) {
    fields.u16(channel.value);
    fields.u32(static_cast<std::uint32_t>(16 * offsets.size()));
    for (const auto& [time, offset] : offsets) {
      fields.time(time);
      fields.u64(offset);
    }
  });
}

void append_chunk_index(Bytes& out, const ChunkIndex& index) {
  append_record(out, Opcode::kChunkIndex, [&](FieldWriter& fields) {
    fields.time(index.start_time);
    fields.time(index.end_time);
    fields.u64(index.offset);
    fields.u64(index.length);
    fields.channel_map(index.message_index_offsets);
    fields.u64(index.message_index_length);
    fields.string(index.compression);
    fields.u64(index.compressed_size);
    fields.u64(index.uncompressed_size);
  });
}

void append_metadata(Bytes& out, std::string_view name, const StringMap& metadata) {
  append_record(out, Opcode::kMetadata, [&](FieldWriter& fields) {
    fields.string(name);
    fields.string_map(metadata);
  });
}

void append_metadata_index(Bytes& out, const MetadataIndex& index) {
  append_record(out, Opcode::kMetadataIndex, [&](FieldWriter& fields) {
    fields.u64(index.offset);
    fields.u64(index.length);
    fields.string(index.name);
  });
}

void append_statistics(Bytes& out, const Summary& summary) {
  append_record(out, Opcode::kStatistics, [&](FieldWriter& fields) {
    fields.u64(summary.statistics.message_count);
    fields.u16(static_cast<std::uint16_t>(summary.schemas.size()));
    fields.u32(static_cast<std::uint32_t>(summary.channels.size()));
    fields.u32(0);  // attachment count
    fields.u32(static_cast<std::uint32_t>(summary.metadata.size()));
    fields.u32(static_cast<std::uint32_t>(summary.chunks.size()));
    fields.time(summary.statistics.start_time);
    fields.time(summary.statistics.end_time);
    fields.channel_map(summary.statistics.channel_message_counts);
  });
}

void append_data_end(Bytes& out) {
  append_record(out, Opcode::kDataEnd, [](FieldWriter& fields) {
    fields.u32(0);  // no CRC of the data section: each chunk has its own
  });
}

void append_chunk_start(Bytes& out, nanoseconds start_time, nanoseconds end_time,
                        ByteView records) {
  constexpr std::uint64_t kFieldBytes = 8 + 8 + 8 + 4 + 4 + 8;
  FieldWriter fields(out);
  fields.u8(static_cast<std::uint8_t>(Opcode::kChunk));
  fields.u64(kFieldBytes + records.size());
  fields.time(start_time);
  fields.time(end_time);
  fields.u64(records.size());
  fields.u32(crc32(std::as_bytes(records)));
  fields.string("");
  fields.u64(records.size());
}

std::optional<Schema> read_schema(ByteView content) {
  FieldReader fields(content);
  Schema schema;
  schema.id = SchemaId{fields.u16()};
  schema.name = fields.string();
  schema.encoding = fields.string();
  const auto data = fields.bytes(fields.u32());
  schema.data.assign(data.begin(), data.end());
  return if_whole(fields, std::move(schema));
}

std::optional<Channel> read_channel(ByteView content) {
  FieldReader fields(content);
  Channel channel;
  channel.id = ChannelId{fields.u16()};
  channel.schema = SchemaId{fields.u16()};
  channel.topic = fields.string();
  channel.message_encoding = fields.string();
  channel.metadata = fields.string_map();
  return if_whole(fields, std::move(channel));
}

std::optional<Message> read_message(ByteView content) {
  FieldReader fields(content);
  Message message;
  message.channel = ChannelId{fields.u16()};
  message.sequence = fields.u32();
  message.log_time = fields.time();
  message.publish_time = fields.time();
  message.data = fields.rest();
  return if_whole(fields, message);
}

std::optional<ChunkIndex> read_chunk_index(ByteView content) {
  FieldReader fields(content);
  ChunkIndex index;
  index.start_time = fields.time();
  index.end_time = fields.time();
  index.offset = fields.u64();
  index.length = fields.u64();
  index.message_index_offsets = fields.channel_map();
  index.message_index_length = fields.u64();
  index.compression = fields.string();
  index.compressed_size = fields.u64();
  index.uncompressed_size = fields.u64();
  return if_whole(fields, std::move(index));
}

std::optional<MetadataIndex> read_metadata_index(ByteView content) {
  FieldReader fields(content);
  MetadataIndex index;
  index.offset = fields.u64();
  index.length = fields.u64();
  index.name = fields.string();
  return if_whole(fields, std::move(index));
}

std::optional<Statistics> read_statistics(ByteView content) {
  FieldReader fields(content);
  Statistics statistics;
  statistics.message_count = fields.u64();
  fields.bytes(2 + 4 * 4);  // counts, which can be derived from the summary
  statistics.start_time = fields.time();
  statistics.end_time = fields.time();
  statistics.channel_message_counts = fields.channel_map();
  return if_whole(fields, std::move(statistics));
}

std::optional<NamedMetadata> read_metadata(ByteView content) {
  FieldReader fields(content);
  NamedMetadata metadata;
  metadata.name = fields.string();
  metadata.values = fields.string_map();
  return if_whole(fields, std::move(metadata));
}

std::optional<StoredChunk> read_chunk(ByteView content) {
  FieldReader fields(content);
  StoredChunk chunk;
  chunk.start_time = fields.time();
  chunk.end_time = fields.time();
  chunk.uncompressed_size = fields.u64();
  chunk.uncompressed_crc = fields.u32();
  chunk.compression = fields.string();
  chunk.records = fields.bytes(fields.u64());
  return if_whole(fields, std::move(chunk));
}

std::optional<Record> take_record(ByteView& bytes) {
  FieldReader fields(bytes);
  const Opcode opcode{fields.u8()};
  const ByteView content = fields.bytes(fields.u64());
  if (!fields.ok()) return std::nullopt;
  bytes = fields.rest();
  return Record{opcode, content};
}

}  // namespace roomcast::recording::mcap
