// SPDX-License-Identifier: Apache-2.0
// The step between the numbers along an axis of a chart. Thread-safe (no state).
#pragma once

namespace roomcast {

/// 1, 2 or 5 times a power of ten, so that `steps` of them or fewer reach over `span`, above 0.
[[nodiscard]] double axis_step(double span, int steps);

}  // namespace roomcast
