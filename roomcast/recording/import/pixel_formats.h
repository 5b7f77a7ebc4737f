// SPDX-License-Identifier: Apache-2.0
// Converts pictures as cameras and other programs store them: raw pixels of several formats, JPEG
// and PNG, to depth values and colour. Bytes are untrusted; every size is checked. Single-threaded.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/io/jpeg_codec.h"

namespace roomcast::recording {

enum class PixelFormat {
  kRgb8,
  kBgr8,
  kRgba8,
  kBgra8,
  kMono8,
  kYuy2,  // 4:2:2, Y0 U Y1 V
  kUyvy,  // 4:2:2, U Y0 V Y1
  kNv12,  // 4:2:0, a plane of Y, then one of U V
  kDepth16Little,
  kDepth16Big,
  kDepthFloat,  // 32 bit, metres, little-endian; NaN and infinity: no reading
  kJpeg,
  kPng,
};

[[nodiscard]] bool is_depth(PixelFormat format);  // kPng may be either

/// A picture as stored. `row_bytes` is 0 for rows without gaps.
struct StoredPicture {
  PixelFormat format{};
  int width = 0, height = 0;
  std::size_t row_bytes = 0;
  std::span<const std::uint8_t> bytes;
};

class PictureDecoder {
 public:
  /// Values of a depth picture, in its own unit; kDepthFloat in millimetres. `depth` gets the size
  /// of the picture. kMalformed: bytes are missing or damaged; kUnsupported: not depth.
  [[nodiscard]] Status depth(const StoredPicture& picture, DepthImage& depth);
  /// kMalformed, kUnsupported likewise. YUV is that of ITU-R BT.601 with 16 to 235, as the makers'
  /// libraries convert it.
  [[nodiscard]] Status color(const StoredPicture& picture, ColorImage& color);

 private:
  io::JpegCodec jpeg_;
};

}  // namespace roomcast::recording
