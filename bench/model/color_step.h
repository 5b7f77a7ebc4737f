// SPDX-License-Identifier: Apache-2.0
// The step of colour that is seen where the views of two sensors meet on one surface, without and
// with color_gains. The gains are found in one half of the room, and the steps in the other: cubes
// of half a metre in turns. Levels, 0 to 255.
#pragma once

#include <cstddef>
#include <span>

#include "roomcast/model/color_gains.h"

namespace roomcast::bench {

struct ColorStep {
  double mean = 0, largest = 0;  // over the pairs of views: the mean of |median| of three channels
};
struct ColorSteps {
  std::size_t pairs = 0;  // of views that share at least 200 places
  ColorStep before, after;
};
[[nodiscard]] ColorSteps color_steps(std::span<const model::SharedColor> shared,
                                     std::size_t view_count);

}  // namespace roomcast::bench
