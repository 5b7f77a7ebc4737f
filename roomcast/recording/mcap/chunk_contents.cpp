// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mcap/chunk_contents.h"

#include <string>
#include <utility>

#include <zstd.h>

#include "roomcast/core/crc32.h"

namespace roomcast::recording::mcap {
namespace {

/// Decompresses the records in `chunk`, which point into `bytes`, and replaces both.
Status decompress(StoredChunk& chunk, Bytes& bytes) {
  if (chunk.uncompressed_size > kMaxChunkBytes)
    return Error{ErrorCode::kTooLarge, "a chunk in it is too large"};
  if (chunk.compression.empty()) return {};
  if (chunk.compression != "zstd") {
    return Error{ErrorCode::kUnsupported, "its chunks are compressed with \"" + chunk.compression +
                                              "\"; rewrite it with zstd or without compression"};
  }
  Bytes plain(static_cast<std::size_t>(chunk.uncompressed_size));
  const std::size_t size =
      ZSTD_decompress(plain.data(), plain.size(), chunk.records.data(), chunk.records.size());
  if (ZSTD_isError(size) || size != plain.size())
    return malformed("a chunk cannot be decompressed");
  bytes = std::move(plain);
  chunk.records = bytes;
  return {};
}

template <class T>
bool add(std::vector<T>& list, std::optional<T> read) {
  if (read) list.push_back(std::move(*read));
  return read.has_value();
}

bool take(const Record& record, ChunkContents& contents) {
  switch (record.opcode) {
    case Opcode::kSchema:
      return add(contents.schemas, read_schema(record.content));
    case Opcode::kChannel:
      return add(contents.channels, read_channel(record.content));
    case Opcode::kMessage:
      return add(contents.messages, read_message(record.content));
    default:
      return true;
  }
}

}  // namespace

Result<ChunkContents> open_chunk(Bytes record) {
  ChunkContents contents;
  contents.bytes = std::move(record);
  auto chunk = read_chunk(contents.bytes);
  if (!chunk) return malformed("a chunk is truncated");
  if (auto status = decompress(*chunk, contents.bytes); !status) return status.error();
  if (chunk->records.size() != chunk->uncompressed_size)
    return malformed("a chunk has the wrong size");
  const bool checked = chunk->uncompressed_crc == 0 ||
                       crc32(std::as_bytes(chunk->records)) == chunk->uncompressed_crc;
  if (!checked) return malformed("the checksum of a chunk is wrong");
  ByteView records = chunk->records;
  while (!records.empty()) {
    const auto taken = take_record(records);
    if (!taken || !take(*taken, contents)) return malformed("a record in a chunk is damaged");
  }
  return contents;
}

}  // namespace roomcast::recording::mcap
