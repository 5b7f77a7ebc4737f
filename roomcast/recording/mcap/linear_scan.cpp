// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mcap/linear_scan.h"

#include <array>
#include <optional>
#include <utility>

#include "roomcast/recording/mcap/chunk_contents.h"
#include "roomcast/recording/mcap/fields.h"
#include "roomcast/recording/mcap/summary_section.h"

namespace roomcast::recording::mcap {
namespace {

struct Place {
  Opcode opcode{};
  std::uint64_t offset = 0, length = 0;  // of the whole record
};

/// The record at `offset`, if the file contains all of it.
std::optional<Place> record_at(const ByteSource& source, std::uint64_t offset) {
  std::array<std::uint8_t, kRecordHeaderBytes> start{};
  if (!source.read(offset, start)) return std::nullopt;
  FieldReader fields(start);
  const Opcode opcode{fields.u8()};
  const std::uint64_t content = fields.u64();
  if (content > source.size() - offset - kRecordHeaderBytes) return std::nullopt;
  return Place{opcode, offset, content + kRecordHeaderBytes};
}

std::optional<Bytes> content_of(const ByteSource& source, const Place& place, std::size_t limit) {
  if (place.length - kRecordHeaderBytes > limit) return std::nullopt;
  Bytes content(static_cast<std::size_t>(place.length - kRecordHeaderBytes));
  if (!source.read(place.offset + kRecordHeaderBytes, content)) return std::nullopt;
  return content;
}

bool take_chunk(const ByteSource& source, const Place& place, Summary& summary) {
  auto record = content_of(source, place, kMaxChunkBytes);
  if (!record) return false;
  const auto stored = read_chunk(*record);
  if (!stored) return false;
  ChunkIndex index;
  index.start_time = stored->start_time;
  index.end_time = stored->end_time;
  index.offset = place.offset;
  index.length = place.length;
  index.compression = stored->compression;
  index.compressed_size = stored->records.size();
  index.uncompressed_size = stored->uncompressed_size;
  auto contents = open_chunk(std::move(*record));
  if (!contents) return false;
  for (Schema& schema : contents->schemas) summary.schemas[schema.id] = std::move(schema);
  for (Channel& channel : contents->channels) summary.channels[channel.id] = std::move(channel);
  std::map<ChannelId, MessageOffsets> offsets;
  for (const Message& message : contents->messages)
    offsets[message.channel].emplace_back(message.log_time, 0);
  for (const auto& [channel, unused] : offsets) index.message_index_offsets[channel] = 0;
  add_to_summary(summary, std::move(index), offsets);
  return true;
}

bool take_metadata(const ByteSource& source, const Place& place, Summary& summary) {
  const auto content = content_of(source, place, kMaxMetadataBytes);
  const auto metadata = content ? read_metadata(*content) : std::nullopt;
  if (metadata) summary.metadata.push_back({place.offset, place.length, metadata->name});
  return metadata.has_value();
}

bool take(const ByteSource& source, const Place& place, Summary& summary) {
  if (place.opcode == Opcode::kChunk) return take_chunk(source, place, summary);
  if (place.opcode == Opcode::kMetadata) return take_metadata(source, place, summary);
  return true;
}

}  // namespace

LinearScan scan_from_start(const ByteSource& source) {
  LinearScan scan;
  scan.sound_bytes = kMagic.size();
  for (;;) {
    const auto place = record_at(source, scan.sound_bytes);
    if (!place || place->opcode == Opcode::kDataEnd) return scan;
    if (!take(source, *place, scan.summary)) return scan;
    scan.sound_bytes += place->length;
  }
}

}  // namespace roomcast::recording::mcap
