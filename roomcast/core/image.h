// SPDX-License-Identifier: Apache-2.0
// Images and views of them. Row-major, origin top left. A view never owns pixels; an image always
// does.
//   DepthImage  u16 millimetres along the optical axis (z), 0 = no reading
//   ColorImage  8-bit sRGB, red first
//   MaskImage   u8, 0 = false, any other value = true
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "roomcast/core/assert.h"

namespace roomcast {

struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  friend constexpr bool operator==(const Rgb8&, const Rgb8&) = default;
};
static_assert(sizeof(Rgb8) == 3, "rows of Rgb8 are handed to image libraries as packed bytes");

/// A view of `height` rows of `width` pixels; row starts are `stride` pixels apart. A const `T`
/// makes it read-only.
template <class T>
struct ImageView {
  T* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;  // in pixels

  [[nodiscard]] T* row(int y) const { return data + y * stride; }
  [[nodiscard]] T& at(int x, int y) const { return row(y)[x]; }
  [[nodiscard]] std::size_t pixel_count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] bool contiguous() const { return stride == width; }
  operator ImageView<const T>() const requires(!std::is_const_v<T>) {
    return {data, width, height, stride};
  }
};

template <class A, class B>
[[nodiscard]] bool same_size(const A& a, const B& b) {
  return a.width == b.width && a.height == b.height;
}

/// Owns its pixels, rows without gaps. `resize` keeps the allocation when it is large enough.
template <class T>
class Image {
 public:
  Image() = default;
  Image(int width, int height, T fill = T{}) { resize(width, height, fill); }

  void resize(int width, int height, T fill = T{}) {
    ROOMCAST_ASSERT(width >= 0 && height >= 0);
    pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill);
    width_ = width;
    height_ = height;
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool empty() const { return pixels_.empty(); }
  [[nodiscard]] T* data() { return pixels_.data(); }
  [[nodiscard]] const T* data() const { return pixels_.data(); }
  [[nodiscard]] T& at(int x, int y) { return view().at(x, y); }
  [[nodiscard]] const T& at(int x, int y) const { return view().at(x, y); }
  [[nodiscard]] ImageView<T> view() { return {pixels_.data(), width_, height_, width_}; }
  [[nodiscard]] ImageView<const T> view() const {
    return {pixels_.data(), width_, height_, width_};
  }
  operator ImageView<const T>() const { return view(); }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  std::vector<T> pixels_;
  int width_ = 0;
  int height_ = 0;
};

using DepthImage = Image<std::uint16_t>;
using ColorImage = Image<Rgb8>;
using MaskImage = Image<std::uint8_t>;
using DepthView = ImageView<const std::uint16_t>;
using ColorView = ImageView<const Rgb8>;
using MaskView = ImageView<const std::uint8_t>;

}  // namespace roomcast
