// SPDX-License-Identifier: Apache-2.0
// Copies pixels from a library's buffer, whose rows may have gaps between them. Thread-safe (no
// state).
#pragma once

#include <cstddef>
#include <cstring>

#include "roomcast/core/image.h"

namespace roomcast::source {

/// `picture` is not reallocated if it has this size already. `data` contains `height` rows of
/// `stride_bytes`; the last row may end after `width` pixels.
template <class Pixel>
void copy_rows(const void* data, std::ptrdiff_t stride_bytes, int width, int height,
               Image<Pixel>& picture) {
  if (picture.width() != width || picture.height() != height) picture.resize(width, height);
  const auto* const bytes = static_cast<const char*>(data);
  for (int y = 0; y < height; ++y) {
    std::memcpy(picture.view().row(y), bytes + stride_bytes * y,
                sizeof(Pixel) * static_cast<std::size_t>(width));
  }
}

}  // namespace roomcast::source
