// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/image_file.h"

#include <string>
#include <utility>

#include "roomcast/core/assert.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/png_codec.h"

namespace roomcast::io {
namespace {

/// Turns a codec's problem into a sentence about the file.
Status refused(const std::filesystem::path& path, const std::string& problem) {
  if (problem.empty()) return {};
  return Error{ErrorCode::kMalformed, path.string() + " is refused: " + problem};
}

Status not_written(const std::filesystem::path& path, const std::string& problem) {
  return Error{ErrorCode::kInvalidArgument, "cannot write " + path.string() + ": " + problem};
}

bool is_jpeg(const std::vector<std::uint8_t>& bytes) {
  return bytes.size() >= 2 && bytes[0] == 0xFF && bytes[1] == 0xD8;
}

template <class T>
void resize_to(Image<T>& image, ImageSize size) {
  ROOMCAST_ASSERT(size.width <= kMaxImageSide && size.height <= kMaxImageSide);
  if (image.width() != size.width || image.height() != size.height) {
    image.resize(size.width, size.height);
  }
}

}  // namespace

Status ImageFileReader::read_depth(const std::filesystem::path& path, ImageSize size,
                                   DepthImage& depth) {
  if (Status status = read_file(path, kMaxImageFileBytes, bytes_); !status.ok()) return status;
  resize_to(depth, size);
  return refused(path, decode_depth_png(bytes_, depth.view()));
}

Status ImageFileReader::read_color(const std::filesystem::path& path, ImageSize size,
                                   ColorImage& color) {
  if (Status status = read_file(path, kMaxImageFileBytes, bytes_); !status.ok()) return status;
  resize_to(color, size);
  return refused(path, is_jpeg(bytes_) ? jpeg_.decode(bytes_, color.view())
                                       : decode_color_png(bytes_, color.view()));
}

Status ImageFileReader::read_mask(const std::filesystem::path& path, ImageSize size,
                                  MaskImage& mask) {
  if (Status status = read_file(path, kMaxImageFileBytes, bytes_); !status.ok()) return status;
  resize_to(mask, size);
  return refused(path, decode_mask_png(bytes_, mask.view()));
}

Status write_depth_png(const std::filesystem::path& path, DepthView depth) {
  std::vector<std::uint8_t> bytes;
  const std::string problem = encode_depth_png(depth, bytes);
  return problem.empty() ? write_file(path, bytes) : not_written(path, problem);
}

Status write_color_png(const std::filesystem::path& path, ColorView color) {
  std::vector<std::uint8_t> bytes;
  const std::string problem = encode_color_png(color, bytes);
  return problem.empty() ? write_file(path, bytes) : not_written(path, problem);
}

Status write_mask_png(const std::filesystem::path& path, MaskView mask) {
  std::vector<std::uint8_t> bytes;
  const std::string problem = encode_mask_png(mask, bytes);
  return problem.empty() ? write_file(path, bytes) : not_written(path, problem);
}

Status write_color_jpeg(const std::filesystem::path& path, ColorView color, int quality) {
  std::vector<std::uint8_t> bytes;
  const std::string problem = JpegCodec().encode(color, quality, bytes);
  return problem.empty() ? write_file(path, bytes) : not_written(path, problem);
}

}  // namespace roomcast::io
