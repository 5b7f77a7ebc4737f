// SPDX-License-Identifier: Apache-2.0
// Reader: reads MCAP files (https://mcap.dev/spec) whose messages are in chunks. A file without a
// valid summary, for instance of a killed recorder, is read from its beginning up to the damage.
// Files are untrusted: sizes are checked before anything is allocated. Any number of threads may
// read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "roomcast/core/result.h"
#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/mcap/chunk_contents.h"

namespace roomcast::recording::mcap {

class Reader {
 public:
  /// kNotFound; kMalformed if the file is not MCAP. Messages name the file.
  static Result<Reader> open(const std::filesystem::path& path);
  /// `name` is used in error messages.
  static Result<Reader> read(std::unique_ptr<ByteSource> source, std::string name);

  [[nodiscard]] const Summary& summary() const { return summary_; }
  /// Reason why the end of the file cannot be read, as a sentence; nothing if the file is complete.
  [[nodiscard]] const std::optional<std::string>& damage() const { return damage_; }
  /// End of the readable part of a damaged file.
  [[nodiscard]] std::uint64_t sound_bytes() const { return sound_bytes_; }

  /// `number` is below summary().chunks.size(). kMalformed if this chunk is damaged; others may be
  /// valid. kUnsupported, kTooLarge as open_chunk.
  [[nodiscard]] Result<ChunkContents> chunk(std::size_t number) const;
  /// The last metadata record of that name. kNotFound, kMalformed.
  [[nodiscard]] Result<StringMap> metadata(const std::string& name) const;

 private:
  Reader(std::unique_ptr<ByteSource> source, std::string name)
      : source_(std::move(source)), name_(std::move(name)) {}
  [[nodiscard]] Status check_start() const;
  [[nodiscard]] Result<Summary> read_end() const;
  [[nodiscard]] Result<Bytes> record_at(std::uint64_t offset, std::uint64_t length, Opcode opcode,
                                        std::size_t limit) const;
  [[nodiscard]] Error named(Error error) const;

  std::unique_ptr<ByteSource> source_;
  std::string name_;
  Summary summary_;
  std::optional<std::string> damage_;
  std::uint64_t sound_bytes_ = 0;
};

}  // namespace roomcast::recording::mcap
