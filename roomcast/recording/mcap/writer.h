// SPDX-License-Identifier: Apache-2.0
// Writer: writes an MCAP file (https://mcap.dev/spec): messages in uncompressed chunks, each with
// its CRC-32 and message index, and at the end a summary for random access. Until the summary is
// written, the file can be read from its beginning up to the last closed chunk. Memory: one chunk,
// plus some 150 bytes per chunk written. Single-threaded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/mcap/output_file.h"
#include "roomcast/recording/mcap/record_codec.h"

namespace roomcast::recording::mcap {

struct WriterOptions {
  std::string profile;                  // from the MCAP registry; may be empty
  std::string library = "roomcast";     // name of the writing program
  std::size_t chunk_bytes = 1U << 20U;  // a chunk is closed when it exceeds this size
};

class Writer {
 public:
  /// Errors as OutputFile::create.
  static Result<Writer> create(const std::filesystem::path& path,
                               const WriterOptions& options = {});

  SchemaId add_schema(std::string_view name, std::string_view encoding, ByteView data);
  ChannelId add_channel(SchemaId schema, std::string_view topic, std::string_view message_encoding,
                        StringMap metadata = {});

  /// `message.channel`: as returned by add_channel. Closes the chunk when it is large enough. After
  /// an error, which is that of OutputFile::append, the open chunk is lost; writing may continue.
  [[nodiscard]] Status add_message(const Message& message);
  [[nodiscard]] Status add_metadata(std::string_view name, const StringMap& metadata);

  /// Closes the chunk: messages added so far survive a crash of this program.
  [[nodiscard]] Status close_chunk();
  /// Closes the chunk and writes summary and footer. Nothing may be added afterwards.
  [[nodiscard]] Status finish();

  [[nodiscard]] bool chunk_is_empty() const { return chunk_.empty(); }
  /// Bytes on disk plus those in the open chunk.
  [[nodiscard]] std::uint64_t bytes() const { return file_.size() + chunk_.size(); }
  [[nodiscard]] const Summary& summary() const { return summary_; }

 private:
  Writer(OutputFile file, WriterOptions options)
      : file_(std::move(file)), options_(std::move(options)) {}
  void announce(ChannelId channel);
  Status write_chunk();
  void forget_chunk();

  OutputFile file_;
  WriterOptions options_;
  Summary summary_;  // of the chunks on disk; schemas and channels: all that were added

  // The open chunk.
  Bytes chunk_;
  std::map<ChannelId, MessageOffsets> offsets_;
  nanoseconds start_time_{}, end_time_{};
  std::set<ChannelId> announced_;  // their records are in the file or in the open chunk
  std::set<ChannelId> announced_before_chunk_;
  Bytes scratch_;
};

}  // namespace roomcast::recording::mcap
