// SPDX-License-Identifier: Apache-2.0
// Converts JPEG bytes to pixels and back, through libjpeg-turbo. A JpegCodec keeps the library's
// state from picture to picture. Single-threaded.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::io {

class JpegCodec {
 public:
  JpegCodec() = default;
  ~JpegCodec();
  JpegCodec(JpegCodec&& other) noexcept;
  JpegCodec& operator=(JpegCodec&& other) noexcept;

  /// Decodes a JPEG of exactly the size of `color`. Returns the problem, or an empty string.
  [[nodiscard]] std::string decode(std::span<const std::uint8_t> bytes, ImageView<Rgb8> color);

  /// Replaces `bytes` by a JPEG file (4:2:0). `quality` 1..100. Returns the problem, or an empty
  /// string.
  [[nodiscard]] std::string encode(ColorView color, int quality, std::vector<std::uint8_t>& bytes);

 private:
  void* decompressor_ = nullptr;  // created when needed
  void* compressor_ = nullptr;
};

}  // namespace roomcast::io
