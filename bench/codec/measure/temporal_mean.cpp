// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/measure/temporal_mean.h"

#include <cstdlib>

namespace roomcast::bench {
namespace {

constexpr int kNear = 10;  // per channel; camera noise is 1 to 4

bool is_near(Rgb8 a, Rgb8 b) {
  return std::abs(a.r - b.r) <= kNear && std::abs(a.g - b.g) <= kNear &&
         std::abs(a.b - b.b) <= kNear;
}

struct Mean {
  int r = 0, g = 0, b = 0, count = 0;
  void add(Rgb8 c) {
    r += c.r;
    g += c.g;
    b += c.b;
    ++count;
  }
  [[nodiscard]] std::uint8_t rounded(int sum) const {
    return static_cast<std::uint8_t>((sum + count / 2) / count);
  }
  [[nodiscard]] Rgb8 color() const { return {rounded(r), rounded(g), rounded(b)}; }
};

}  // namespace

void temporal_mean(const SeenColor& frame, std::span<const SeenColor> around, ColorImage& out) {
  out.resize(frame.color.width, frame.color.height);
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) {
      if (!frame.seen.at(x, y)) continue;
      const Rgb8 own = frame.color.at(x, y);
      Mean mean;
      mean.add(own);
      for (const SeenColor& other : around) {
        const Rgb8 c = other.color.at(x, y);
        if (other.seen.at(x, y) && is_near(c, own)) mean.add(c);
      }
      out.at(x, y) = mean.color();
    }
  }
}

}  // namespace roomcast::bench
