// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/rosbag/chunk.h"

#include <memory>

#include <bzlib.h>
#include <lz4frame.h>

namespace roomcast::recording::rosbag {
namespace {

/// Memory that a compressed chunk may ask for before it has shown that it has contents: nothing
/// compresses better than this.
constexpr std::size_t kLargestRatio = 2000;

bool read_lz4(ByteView stored, std::vector<std::uint8_t>& plain) {
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION))) return false;
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      raw, &LZ4F_freeDecompressionContext);
  std::size_t written = 0;
  while (written < plain.size() && !stored.empty()) {
    std::size_t out = plain.size() - written, in = stored.size();
    const std::size_t hint =
        LZ4F_decompress(context.get(), plain.data() + written, &out, stored.data(), &in, nullptr);
    if (LZ4F_isError(hint) || (out == 0 && in == 0)) return false;
    written += out;
    stored = stored.subspan(in);
  }
  return written == plain.size();
}

bool read_bz2(ByteView stored, std::vector<std::uint8_t>& plain) {
  bz_stream stream{};
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) return false;
  // The library does not write to its input, but its type does not say so.
  stream.next_in = const_cast<char*>(reinterpret_cast<const char*>(stored.data()));
  stream.avail_in = static_cast<unsigned>(stored.size());
  stream.next_out = reinterpret_cast<char*>(plain.data());
  stream.avail_out = static_cast<unsigned>(plain.size());
  int code = BZ_OK;
  while (code == BZ_OK && stream.avail_out > 0) {
    const unsigned in = stream.avail_in, out = stream.avail_out;
    code = BZ2_bzDecompress(&stream);
    if (stream.avail_in == in && stream.avail_out == out) break;
  }
  BZ2_bzDecompressEnd(&stream);
  return stream.avail_out == 0 && (code == BZ_OK || code == BZ_STREAM_END);
}

}  // namespace

Status decompress_chunk(const std::string& compression, ByteView stored, std::size_t size,
                        std::vector<std::uint8_t>& plain) {
  if (size > kMaxChunkBytes || stored.size() > kMaxChunkBytes)
    return Error{ErrorCode::kTooLarge, "a chunk of it is too large"};
  if (compression == "none") {
    if (stored.size() != size) return malformed("a chunk of it has the wrong size");
    plain.assign(stored.begin(), stored.end());
    return {};
  }
  if (compression != "bz2" && compression != "lz4")
    return Error{ErrorCode::kUnsupported, "its chunks are compressed in an unknown way"};
  const bool plausible = size / kLargestRatio <= stored.size();
  if (plausible) plain.resize(size);
  if (plausible && size > 0 &&
      (compression == "bz2" ? read_bz2(stored, plain) : read_lz4(stored, plain)))
    return {};
  return malformed("a chunk of it cannot be decompressed");
}

}  // namespace roomcast::recording::rosbag
