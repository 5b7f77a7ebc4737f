// SPDX-License-Identifier: Apache-2.0
// Picture files: depth as 16-bit grey PNG, colour as JPEG or PNG (docs/adr/0002). Files are
// untrusted: damaged, truncated, oversized and wrongly sized ones are refused with a sentence that
// names the file. Depth values are those of the file, in any unit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/io/jpeg_codec.h"

namespace roomcast::io {

struct ImageSize {
  int width = 0, height = 0;
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

/// Larger picture files are refused.
inline constexpr std::size_t kMaxImageFileBytes = 64U << 20U;

/// Reads pictures of a known size. Reuses its buffers, so that playing a recording does not
/// allocate per frame in this code. Single-threaded.
class ImageFileReader {
 public:
  /// Errors: kNotFound, kTooLarge, kMalformed (not a 16-bit grey PNG, damaged, truncated, of
  /// another size).
  [[nodiscard]] Status read_depth(const std::filesystem::path& path, ImageSize size,
                                  DepthImage& depth);
  /// JPEG or PNG, distinguished by content. Errors as above.
  [[nodiscard]] Status read_color(const std::filesystem::path& path, ImageSize size,
                                  ColorImage& color);
  /// 8-bit grey PNG. Errors as above.
  [[nodiscard]] Status read_mask(const std::filesystem::path& path, ImageSize size,
                                 MaskImage& mask);

 private:
  std::vector<std::uint8_t> bytes_;
  JpegCodec jpeg_;
};

/// Files are written completely or not at all. kUnavailable if the file cannot be written.
[[nodiscard]] Status write_depth_png(const std::filesystem::path& path, DepthView depth);
[[nodiscard]] Status write_color_png(const std::filesystem::path& path, ColorView color);
[[nodiscard]] Status write_mask_png(const std::filesystem::path& path, MaskView mask);
/// `quality` 1..100.
[[nodiscard]] Status write_color_jpeg(const std::filesystem::path& path, ColorView color,
                                      int quality);

}  // namespace roomcast::io
