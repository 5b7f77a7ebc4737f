// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mcap/writer.h"

#include <algorithm>
#include <utility>

#include "roomcast/core/assert.h"
#include "roomcast/core/crc32.h"
#include "roomcast/recording/mcap/fields.h"
#include "roomcast/recording/mcap/summary_section.h"

namespace roomcast::recording::mcap {

Result<Writer> Writer::create(const std::filesystem::path& path, const WriterOptions& options) {
  auto file = OutputFile::create(path);
  if (!file) return file.error();
  Writer writer(std::move(*file), options);
  Bytes start(kMagic.begin(), kMagic.end());
  append_header(start, options.profile, options.library);
  if (auto status = writer.file_.append(start); !status) return status.error();
  return writer;
}

SchemaId Writer::add_schema(std::string_view name, std::string_view encoding, ByteView data) {
  const SchemaId id{static_cast<std::uint16_t>(summary_.schemas.size() + 1)};
  summary_.schemas[id] = {id, std::string(name), std::string(encoding), {data.begin(), data.end()}};
  return id;
}

ChannelId Writer::add_channel(SchemaId schema, std::string_view topic,
                              std::string_view message_encoding, StringMap metadata) {
  const ChannelId id{static_cast<std::uint16_t>(summary_.channels.size())};
  summary_.channels[id] = {id, schema, std::string(topic), std::string(message_encoding),
                           std::move(metadata)};
  return id;
}

/// Writes a channel's schema and channel records into the chunk of its first message.
void Writer::announce(ChannelId id) {
  if (!announced_.insert(id).second) return;
  const auto channel = summary_.channels.find(id);
  ROOMCAST_ASSERT(channel != summary_.channels.end());
  const auto schema = summary_.schemas.find(channel->second.schema);
  if (schema != summary_.schemas.end()) append_schema(chunk_, schema->second);
  append_channel(chunk_, channel->second);
}

Status Writer::add_message(const Message& message) {
  announce(message.channel);
  const bool is_first = offsets_.empty();
  start_time_ = is_first ? message.log_time : std::min(start_time_, message.log_time);
  end_time_ = is_first ? message.log_time : std::max(end_time_, message.log_time);
  offsets_[message.channel].emplace_back(message.log_time, chunk_.size());
  append_message(chunk_, message);
  return chunk_.size() < options_.chunk_bytes ? Status() : close_chunk();
}

Status Writer::close_chunk() {
  if (chunk_.empty()) return {};
  Status status = write_chunk();
  if (status) announced_before_chunk_ = announced_;
  forget_chunk();
  return status;
}

void Writer::forget_chunk() {
  announced_ = announced_before_chunk_;
  chunk_.clear();
  offsets_.clear();
}

Status Writer::write_chunk() {
  ChunkIndex index;
  index.start_time = start_time_;
  index.end_time = end_time_;
  index.offset = file_.size();
  index.compressed_size = index.uncompressed_size = chunk_.size();
  scratch_.clear();
  append_chunk_start(scratch_, start_time_, end_time_, chunk_);
  index.length = scratch_.size() + chunk_.size();
  const std::size_t start_bytes = scratch_.size();
  for (const auto& [channel, offsets] : offsets_) {
    index.message_index_offsets[channel] =
        index.offset + index.length + scratch_.size() - start_bytes;
    append_message_index(scratch_, channel, offsets);
  }
  index.message_index_length = scratch_.size() - start_bytes;
  const ByteView written(scratch_);
  // The chunk is written completely or not at all; its message indexes may be missing, as the spec
  // allows.
  if (auto status = file_.append(written.first(start_bytes), chunk_); !status) return status;
  if (!file_.append(written.subspan(start_bytes))) {
    index.message_index_offsets.clear();
    index.message_index_length = 0;
  }
  add_to_summary(summary_, std::move(index), offsets_);
  return {};
}

Status Writer::add_metadata(std::string_view name, const StringMap& metadata) {
  if (auto status = close_chunk(); !status) return status;
  scratch_.clear();
  append_metadata(scratch_, name, metadata);
  MetadataIndex index{file_.size(), scratch_.size(), std::string(name)};
  if (auto status = file_.append(scratch_); !status) return status;
  summary_.metadata.push_back(std::move(index));
  return {};
}

Status Writer::finish() {
  Status chunk_status = close_chunk();
  scratch_.clear();
  append_end(scratch_, summary_, file_.size());
  Status end_status = file_.append(scratch_);
  return chunk_status ? end_status : chunk_status;
}

}  // namespace roomcast::recording::mcap
