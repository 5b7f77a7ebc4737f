// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/window_range.h"

#include <algorithm>

namespace roomcast::alignment {
namespace {

/// `fold(a, b)` over the window, first along rows, then along columns; `outside` applies beyond the
/// picture.
template <class Fold>
Image<float> fold_window(const Image<float>& in, int reach, float outside, Fold fold) {
  const int width = in.width(), height = in.height();
  Image<float> across(width, height, outside), out(width, height, outside);
  for (int y = 0; y < height; ++y) {
    for (int shift = -reach; shift <= reach; ++shift) {
      const int first = std::max(0, -shift), last = std::min(width, width - shift);
      float* const to = across.view().row(y);
      const float* const from = in.view().row(y) + shift;
      for (int x = first; x < last; ++x) to[x] = fold(to[x], from[x]);
    }
  }
  for (int y = 0; y < height; ++y) {
    for (int shift = -reach; shift <= reach; ++shift) {
      if (y + shift < 0 || y + shift >= height) continue;
      float* const to = out.view().row(y);
      const float* const from = across.view().row(y + shift);
      for (int x = 0; x < width; ++x) to[x] = fold(to[x], from[x]);
    }
  }
  return out;
}

}  // namespace

WindowRange window_range(const Image<float>& z_m, int reach) {
  const auto smaller = [](float a, float b) { return a < b ? a : b; };
  const auto larger = [](float a, float b) { return a > b ? a : b; };
  Image<float> missing_far = z_m;
  for (std::size_t i = 0; i < z_m.view().pixel_count(); ++i) {
    if (!(z_m.data()[i] > 0)) missing_far.data()[i] = kNothing_m;
  }
  WindowRange range;
  range.nearest_m = fold_window(missing_far, reach, kNothing_m, smaller);
  range.farthest_m = fold_window(z_m, reach, 0, larger);
  const Image<float> largest = fold_window(missing_far, reach, 0, larger);
  range.complete.resize(z_m.width(), z_m.height());
  for (int y = reach; y < z_m.height() - reach; ++y) {
    for (int x = reach; x < z_m.width() - reach; ++x) {
      range.complete.at(x, y) = largest.at(x, y) < kNothing_m ? 255 : 0;
    }
  }
  return range;
}

}  // namespace roomcast::alignment
