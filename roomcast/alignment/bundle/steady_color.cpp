// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/bundle/steady_color.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "roomcast/alignment/bundle/sample_stack.h"

namespace roomcast::alignment {

ColorImage steady_color(std::span<const ColorImage> pictures) {
  ROOMCAST_ASSERT(!pictures.empty());
  ColorImage steady(pictures[0].width(), pictures[0].height());
  const std::size_t row_bytes = static_cast<std::size_t>(steady.width()) * sizeof(Rgb8);
  SampleStack<std::uint8_t> stack(pictures.size(), row_bytes);
  for (int y = 0; y < steady.height(); ++y) {
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      std::memcpy(stack.picture(i).data(), pictures[i].view().row(y), row_bytes);
    }
    stack.sort();
    const auto middle = stack.picture(pictures.size() / 2);
    std::memcpy(static_cast<void*>(steady.view().row(y)), middle.data(), row_bytes);
  }
  return steady;
}

}  // namespace roomcast::alignment
