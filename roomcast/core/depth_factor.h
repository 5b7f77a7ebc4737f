// SPDX-License-Identifier: Apache-2.0
// Multiplies depth pictures: the readings of a sensor whose camera reads too short or too long by a
// factor. Thread-safe (no state).
#pragma once

#include "roomcast/core/image.h"

namespace roomcast {

/// Rounds to whole millimetres; readings that become too large end at 65535. 0, no reading, stays.
void multiply_depth(ImageView<std::uint16_t> depth_mm, double factor);

}  // namespace roomcast
