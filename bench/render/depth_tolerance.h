// SPDX-License-Identifier: Apache-2.0
// How far a drawn surface may be from the true one and still be the same: 6 cm, or 3 % where that
// is more.
#pragma once

#include <algorithm>

namespace roomcast::bench {

[[nodiscard]] constexpr double depth_tolerance_m(double true_m) {
  return std::max(0.06, 0.03 * true_m);
}

}  // namespace roomcast::bench
