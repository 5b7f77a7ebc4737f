// SPDX-License-Identifier: Apache-2.0
// FileIndex: what a Matroska file (RFC 9559) contains and where: tracks, tags, attachments, and the
// place of every video block. Pictures are not read. A file whose end is missing, for instance of a
// killed recorder, is indexed up to there. Files are untrusted: sizes are checked before anything
// is allocated. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/bytes/byte_source.h"

namespace roomcast::recording::matroska {

// Limits of a file.
inline constexpr std::size_t kMaxTracks = 64, kMaxAttachments = 64, kMaxTags = 1024;
inline constexpr std::size_t kMaxCodecPrivateBytes = 64U << 10U;
inline constexpr std::size_t kMaxAttachmentBytes = 4U << 20U;
inline constexpr std::size_t kMaxBlocks = 4U << 20U;       // of video: 12 hours of three tracks
inline constexpr std::uint64_t kMaxElements = 32U << 20U;  // read in all
inline constexpr std::size_t kMaxBlockBytes = 256U << 20U;

struct Track {
  std::uint64_t number = 0;  // by which blocks name it
  std::uint64_t uid = 0;     // by which tags name it
  bool is_video = false;
  std::string name;
  std::string codec;                        // "V_MS/VFW/FOURCC"
  std::vector<std::uint8_t> codec_private;  // for that codec a BITMAPINFOHEADER
  std::uint64_t width = 0, height = 0;      // pixels
  nanoseconds frame_period{};               // 0: not stated
  bool is_encoded = false;                  // blocks are compressed or encrypted as bytes
};

struct Block {
  nanoseconds time{};        // since the start of the recording
  std::uint64_t offset = 0;  // of its picture in the file
  std::uint32_t size = 0;    // bytes
  std::uint32_t track = 0;   // index in FileIndex::tracks
};

struct Attachment {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

struct FileIndex {
  std::string writing_program;
  std::optional<nanoseconds> began_utc;  // since 1970; files state it to the second
  std::vector<Track> tracks;
  std::map<std::string, std::string> tags;  // of all targets, the first of each name
  std::vector<Attachment> attachments;
  std::vector<Block> blocks;  // of video tracks, in file order
  /// Why the end of the file cannot be read; nothing if the file is complete.
  std::optional<std::string> damage;
};

/// kMalformed: not a Matroska file, or damaged before its first cluster; kTooLarge: above a limit.
[[nodiscard]] Result<FileIndex> read_file_index(const ByteSource& source);

}  // namespace roomcast::recording::matroska
