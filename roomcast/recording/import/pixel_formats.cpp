// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/pixel_formats.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "roomcast/core/little_endian.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/io/png_codec.h"

namespace roomcast::recording {
namespace {

Error too_short() {
  return malformed("a picture in it is incomplete");
}

std::size_t pixel_bytes(PixelFormat format) {
  switch (format) {
    case PixelFormat::kRgb8:
    case PixelFormat::kBgr8:
      return 3;
    case PixelFormat::kRgba8:
    case PixelFormat::kBgra8:
    case PixelFormat::kDepthFloat:
      return 4;
    case PixelFormat::kYuy2:
    case PixelFormat::kUyvy:
    case PixelFormat::kDepth16Little:
    case PixelFormat::kDepth16Big:
      return 2;
    default:
      return 1;
  }
}

std::uint8_t clamped(int value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
}

/// ITU-R BT.601 in integers.
Rgb8 rgb_of(int y, int u, int v) {
  const int c = 298 * (y - 16) + 128, d = u - 128, e = v - 128;
  return {clamped((c + 409 * e) >> 8), clamped((c - 100 * d - 208 * e) >> 8),
          clamped((c + 516 * d) >> 8)};
}

void yuv422_row(const std::uint8_t* from, bool y_first, int width, Rgb8* to) {
  const int y0 = y_first ? 0 : 1, u = y_first ? 1 : 0;
  for (int x = 0; x + 1 < width; x += 2, from += 4) {
    to[x] = rgb_of(from[y0], from[u], from[u + 2]);
    to[x + 1] = rgb_of(from[y0 + 2], from[u], from[u + 2]);
  }
}

void interleaved_row(const std::uint8_t* from, PixelFormat format, int width, Rgb8* to) {
  const std::size_t step = pixel_bytes(format);
  const bool red_first = format == PixelFormat::kRgb8 || format == PixelFormat::kRgba8;
  for (int x = 0; x < width; ++x, from += step) {
    if (format == PixelFormat::kMono8) {
      to[x] = {from[0], from[0], from[0]};
    } else {
      to[x] = red_first ? Rgb8{from[0], from[1], from[2]} : Rgb8{from[2], from[1], from[0]};
    }
  }
}

void nv12(const StoredPicture& picture, std::size_t row_bytes, ColorImage& color) {
  const std::uint8_t* const y_plane = picture.bytes.data();
  const std::uint8_t* const uv_plane =
      y_plane + row_bytes * static_cast<std::size_t>(picture.height);
  for (int y = 0; y < picture.height; ++y) {
    const std::uint8_t* const ys = y_plane + row_bytes * static_cast<std::size_t>(y);
    const std::uint8_t* const uv = uv_plane + row_bytes * static_cast<std::size_t>(y / 2);
    Rgb8* const to = color.view().row(y);
    for (int x = 0; x < picture.width; ++x) to[x] = rgb_of(ys[x], uv[x & ~1], uv[x | 1]);
  }
}

/// The bytes of a row with its gap; nothing if `picture` has not enough bytes for all its rows.
std::optional<std::size_t> checked_row_bytes(const StoredPicture& picture) {
  const auto width = static_cast<std::size_t>(picture.width);
  const auto height = static_cast<std::size_t>(picture.height);
  const std::size_t least = width * pixel_bytes(picture.format);
  const std::size_t row = picture.row_bytes == 0 ? least : picture.row_bytes;
  std::size_t rows = height;
  if (picture.format == PixelFormat::kNv12) rows += height / 2;
  if (row < least || row > picture.bytes.size()) return std::nullopt;
  if ((rows - 1) * row + least > picture.bytes.size()) return std::nullopt;
  return row;
}

bool is_subsampled(PixelFormat format) {
  return format == PixelFormat::kYuy2 || format == PixelFormat::kUyvy ||
         format == PixelFormat::kNv12;
}

Status check_size(const StoredPicture& picture) {
  const bool fits = picture.width > 0 && picture.height > 0 && picture.width <= kMaxImageSide &&
                    picture.height <= kMaxImageSide;
  if (!fits) return Error{ErrorCode::kTooLarge, "a picture in it has an invalid size"};
  const bool odd =
      picture.width % 2 != 0 || (picture.format == PixelFormat::kNv12 && picture.height % 2 != 0);
  if (is_subsampled(picture.format) && odd) return malformed("a picture in it has an odd size");
  return {};
}

std::uint16_t mm_of(float metres) {
  const float mm = std::round(metres * 1000);
  return mm >= 1 && mm <= 65535 ? static_cast<std::uint16_t>(mm) : std::uint16_t{0};  // NaN: 0
}

void depth_row(const std::uint8_t* from, PixelFormat format, int width, std::uint16_t* to) {
  for (int x = 0; x < width; ++x) {
    if (format == PixelFormat::kDepthFloat) {
      to[x] = mm_of(std::bit_cast<float>(read_u32(from + 4 * x)));
    } else if (format == PixelFormat::kDepth16Big) {
      to[x] = static_cast<std::uint16_t>(from[2 * x] << 8 | from[2 * x + 1]);
    } else {
      to[x] = read_u16(from + 2 * x);
    }
  }
}

Status sentence(const std::string& problem) {
  if (problem.empty()) return {};
  return malformed("a picture in it cannot be read: " + problem);
}

}  // namespace

bool is_depth(PixelFormat format) {
  return format == PixelFormat::kDepth16Little || format == PixelFormat::kDepth16Big ||
         format == PixelFormat::kDepthFloat;
}

Status PictureDecoder::depth(const StoredPicture& picture, DepthImage& depth) {
  if (Status status = check_size(picture); !status) return status;
  if (picture.format == PixelFormat::kPng) {
    depth.resize(picture.width, picture.height);
    return sentence(io::decode_depth_png(picture.bytes, depth.view()));
  }
  if (!is_depth(picture.format))
    return Error{ErrorCode::kUnsupported, "a depth picture in it has a format that is not depth"};
  const auto row = checked_row_bytes(picture);
  if (!row) return too_short();
  if (depth.width() != picture.width || depth.height() != picture.height)
    depth.resize(picture.width, picture.height);
  for (int y = 0; y < picture.height; ++y) {
    depth_row(picture.bytes.data() + *row * static_cast<std::size_t>(y), picture.format,
              picture.width, depth.view().row(y));
  }
  return {};
}

Status PictureDecoder::color(const StoredPicture& picture, ColorImage& color) {
  if (Status status = check_size(picture); !status) return status;
  if (is_depth(picture.format))
    return Error{ErrorCode::kUnsupported, "a colour picture in it has the format of depth"};
  const bool is_raw = picture.format != PixelFormat::kJpeg && picture.format != PixelFormat::kPng;
  const auto row = is_raw ? checked_row_bytes(picture) : std::optional<std::size_t>(0);
  if (!row) return too_short();
  if (color.width() != picture.width || color.height() != picture.height)
    color.resize(picture.width, picture.height);
  if (picture.format == PixelFormat::kJpeg)
    return sentence(jpeg_.decode(picture.bytes, color.view()));
  if (picture.format == PixelFormat::kPng)
    return sentence(io::decode_color_png(picture.bytes, color.view()));
  if (picture.format == PixelFormat::kNv12) {
    nv12(picture, *row, color);
    return {};
  }
  for (int y = 0; y < picture.height; ++y) {
    const std::uint8_t* const from = picture.bytes.data() + *row * static_cast<std::size_t>(y);
    Rgb8* const to = color.view().row(y);
    if (is_subsampled(picture.format)) {
      yuv422_row(from, picture.format == PixelFormat::kYuy2, picture.width, to);
    } else {
      interleaved_row(from, picture.format, picture.width, to);
    }
  }
  return {};
}

}  // namespace roomcast::recording
