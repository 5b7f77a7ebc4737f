// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/axis_step.h"

#include <cmath>
#include <initializer_list>

namespace roomcast {

double axis_step(double span, int steps) {
  const double rough = span / steps, power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

}  // namespace roomcast
