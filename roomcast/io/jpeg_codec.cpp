// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/jpeg_codec.h"

#include <utility>

#include <turbojpeg.h>

namespace roomcast::io {
namespace {

constexpr const char* kNoMemory = "there is not enough memory";

int pitch_bytes(std::ptrdiff_t stride) {
  return static_cast<int>(stride * 3);
}

std::string decompress(tjhandle handle, std::span<const std::uint8_t> bytes,
                       ImageView<Rgb8> color) {
  int width = 0, height = 0, subsampling = 0, colorspace = 0;
  if (tjDecompressHeader3(handle, bytes.data(), bytes.size(), &width, &height, &subsampling,
                          &colorspace) != 0) {
    return tjGetErrorStr2(handle);
  }
  if (width != color.width || height != color.height) {
    return "its size differs from the calibration";
  }
  // Warnings are damage too: after the end of a truncated file libjpeg continues with grey.
  if (tjDecompress2(handle, bytes.data(), bytes.size(), &color.data->r, width,
                    pitch_bytes(color.stride), height, TJPF_RGB,
                    TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS) != 0) {
    return tjGetErrorStr2(handle);
  }
  return {};
}

}  // namespace

JpegCodec::~JpegCodec() {
  if (decompressor_ != nullptr) tjDestroy(decompressor_);
  if (compressor_ != nullptr) tjDestroy(compressor_);
}

JpegCodec::JpegCodec(JpegCodec&& other) noexcept
    : decompressor_(std::exchange(other.decompressor_, nullptr)),
      compressor_(std::exchange(other.compressor_, nullptr)) {}

JpegCodec& JpegCodec::operator=(JpegCodec&& other) noexcept {
  std::swap(decompressor_, other.decompressor_);
  std::swap(compressor_, other.compressor_);
  return *this;
}

std::string JpegCodec::decode(std::span<const std::uint8_t> bytes, ImageView<Rgb8> color) {
  if (decompressor_ == nullptr) decompressor_ = tjInitDecompress();
  if (decompressor_ == nullptr) return kNoMemory;
  std::string problem = decompress(decompressor_, bytes, color);
  if (!problem.empty()) {  // tables of a damaged picture would damage the next one
    tjDestroy(decompressor_);
    decompressor_ = nullptr;
  }
  return problem;
}

std::string JpegCodec::encode(ColorView color, int quality, std::vector<std::uint8_t>& bytes) {
  if (compressor_ == nullptr) compressor_ = tjInitCompress();
  if (compressor_ == nullptr) return kNoMemory;
  bytes.resize(tjBufSize(color.width, color.height, TJSAMP_420));
  unsigned char* buffer = bytes.data();
  unsigned long size = bytes.size();
  if (tjCompress2(compressor_, &color.data->r, color.width, pitch_bytes(color.stride), color.height,
                  TJPF_RGB, &buffer, &size, TJSAMP_420, quality, TJFLAG_NOREALLOC) != 0) {
    return tjGetErrorStr2(compressor_);
  }
  bytes.resize(size);
  return {};
}

}  // namespace roomcast::io
