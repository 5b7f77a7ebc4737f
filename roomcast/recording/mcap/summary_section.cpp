// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mcap/summary_section.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "roomcast/core/crc32.h"
#include "roomcast/recording/mcap/fields.h"

namespace roomcast::recording::mcap {
namespace {

/// The records of one opcode within the summary.
struct Group {
  Opcode opcode;
  std::uint64_t start, length;
};

class SummaryWriter {
 public:
  SummaryWriter(Bytes& out, std::uint64_t offset) : out_(out), shift_(offset - out.size()) {}

  /// File offset of the next byte.
  [[nodiscard]] std::uint64_t position() const { return out_.size() + shift_; }

  template <class Append>
  void group(Opcode opcode, Append append) {
    const std::uint64_t start = position();
    append();
    if (position() > start) groups_.push_back({opcode, start, position() - start});
  }
  void offsets() {
    for (const Group& group : groups_) {
      append_record(out_, Opcode::kSummaryOffset, [&](FieldWriter& fields) {
        fields.u8(static_cast<std::uint8_t>(group.opcode));
        fields.u64(group.start);
        fields.u64(group.length);
      });
    }
  }

 private:
  Bytes& out_;
  std::uint64_t shift_;  // modulo 2^64
  std::vector<Group> groups_;
};

/// Adds the record to `summary` if it is of a kind that the reader uses; false if it is damaged.
bool take_summary_record(const Record& record, Summary& summary) {
  const auto put = [](auto& map, auto read) {
    if (read) map[read->id] = std::move(*read);
    return read.has_value();
  };
  const auto add = [](auto& list, auto read) {
    if (read) list.push_back(std::move(*read));
    return read.has_value();
  };
  switch (record.opcode) {
    case Opcode::kSchema:
      return put(summary.schemas, read_schema(record.content));
    case Opcode::kChannel:
      return put(summary.channels, read_channel(record.content));
    case Opcode::kChunkIndex:
      return add(summary.chunks, read_chunk_index(record.content));
    case Opcode::kMetadataIndex:
      return add(summary.metadata, read_metadata_index(record.content));
    case Opcode::kStatistics: {
      auto statistics = read_statistics(record.content);
      if (statistics) summary.statistics = std::move(*statistics);
      return statistics.has_value();
    }
    default:
      return true;
  }
}

}  // namespace

void append_end(Bytes& out, const Summary& summary, std::uint64_t offset) {
  SummaryWriter writer(out, offset);
  append_data_end(out);
  const std::uint64_t summary_start = writer.position();
  const std::size_t first = out.size();
  writer.group(Opcode::kSchema, [&] {
    for (const auto& [id, schema] : summary.schemas) append_schema(out, schema);
  });
  writer.group(Opcode::kChannel, [&] {
    for (const auto& [id, channel] : summary.channels) append_channel(out, channel);
  });
  writer.group(Opcode::kStatistics, [&] { append_statistics(out, summary); });
  writer.group(Opcode::kChunkIndex, [&] {
    for (const ChunkIndex& chunk : summary.chunks) append_chunk_index(out, chunk);
  });
  writer.group(Opcode::kMetadataIndex, [&] {
    for (const MetadataIndex& metadata : summary.metadata) append_metadata_index(out, metadata);
  });
  const std::uint64_t offsets_start = writer.position();
  writer.offsets();
  FieldWriter footer(out);
  footer.u8(static_cast<std::uint8_t>(Opcode::kFooter));
  footer.u64(kFooterBytes - kRecordHeaderBytes);
  footer.u64(summary_start);
  footer.u64(offsets_start);
  footer.u32(crc32(std::as_bytes(std::span(out).subspan(first))));  // of all bytes up to here
  out.insert(out.end(), kMagic.begin(), kMagic.end());
}

void add_to_summary(Summary& summary, ChunkIndex index,
                    const std::map<ChannelId, MessageOffsets>& offsets) {
  Statistics& statistics = summary.statistics;
  if (!offsets.empty()) {
    const bool is_first = statistics.message_count == 0;
    statistics.start_time =
        is_first ? index.start_time : std::min(statistics.start_time, index.start_time);
    statistics.end_time = is_first ? index.end_time : std::max(statistics.end_time, index.end_time);
  }
  for (const auto& [channel, messages] : offsets) {
    statistics.message_count += messages.size();
    statistics.channel_message_counts[channel] += messages.size();
  }
  summary.chunks.push_back(std::move(index));
}

Result<Footer> read_footer(ByteView last_bytes) {
  if (last_bytes.size() != kFooterBytes + kMagic.size() ||
      !std::ranges::equal(last_bytes.last(kMagic.size()), kMagic)) {
    return malformed("its end is missing");
  }
  FieldReader fields(last_bytes);
  const bool is_footer = Opcode{fields.u8()} == Opcode::kFooter && fields.u64() == 20;
  Footer footer;
  footer.summary_start = fields.u64();
  fields.u64();  // start of the summary offsets: unused, because the whole summary is read
  footer.summary_crc = fields.u32();
  if (!is_footer) return malformed("its last record is not a footer");
  return footer;
}

Result<Summary> read_summary(ByteView section, const Footer& footer) {
  if (footer.summary_crc != 0 && crc32(std::as_bytes(section)) != footer.summary_crc) {
    return malformed("the checksum of its summary is wrong");
  }
  constexpr std::size_t kFooterStart = kRecordHeaderBytes + 16;  // of the footer, in `section`
  if (section.size() < kFooterStart) return malformed("its summary is truncated");
  ByteView records = section.first(section.size() - kFooterStart);
  Summary summary;
  while (!records.empty()) {
    const auto record = take_record(records);
    if (!record || !take_summary_record(*record, summary))
      return malformed("its summary is damaged");
  }
  return summary;
}

}  // namespace roomcast::recording::mcap
