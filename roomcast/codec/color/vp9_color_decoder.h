// SPDX-License-Identifier: Apache-2.0
// VP9 colour sections to pictures, through libvpx. docs/spec/codec.md §3.1.
// Hostile bytes: a frame is looked at before libvpx sees it, so that it can neither change the
// picture's size beyond the two that are allowed nor carry a second frame along; memory stays that
// of the larger one.
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
  /// For a depth grid of this size: pictures are of the same size or, as each key frame says, twice
  /// that. kUnavailable if libvpx does not start.
  static Result<std::unique_ptr<Vp9ColorDecoder>> create(int width, int height);
  ~Vp9ColorDecoder();

  /// kMalformed, also for another size or a frame whose references are missing; kUnsupported for
  /// what parse_vp9_header calls so. After an error, frames are refused until the next key frame.
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
