// SPDX-License-Identifier: Apache-2.0
// Decodes VP9 colour sections through libvpx. docs/spec/codec.md §3.1. Hostile bytes: the frame's
// header is checked before libvpx reads the frame, so that it can neither choose a size other than
// the two allowed ones nor contain a second frame. Memory is bounded by the larger size.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "roomcast/codec/color/vp9_header.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::codec {

class Vp9ColorDecoder {
 public:
  /// For a depth grid of this size: pictures have the same size or, if the key frame says so, twice
  /// that. kUnavailable if libvpx does not start.
  static Result<std::unique_ptr<Vp9ColorDecoder>> create(int width, int height);
  ~Vp9ColorDecoder();

  /// Returns kMalformed, also for another size or missing references; kUnsupported for frames that
  /// parse_vp9_header reports as such. After an error, frames are refused until the next key frame.
  [[nodiscard]] Status decode(std::span<const std::uint8_t> frame, ColorImage& color);

 private:
  struct Codec;
  Vp9ColorDecoder(int width, int height, std::unique_ptr<Codec> codec);
  [[nodiscard]] Status check_header(std::span<const std::uint8_t> frame);
  [[nodiscard]] bool take_size(const Vp9Header& header);
  [[nodiscard]] Status take_picture(ColorImage& color);

  const int grid_width_, grid_height_;
  int width_, height_;  // of the picture since the newest key frame
  std::unique_ptr<Codec> codec_;
  std::vector<std::uint8_t> framed_;
  bool needs_key_ = true;
};

}  // namespace roomcast::codec
