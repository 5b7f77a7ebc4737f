// SPDX-License-Identifier: Apache-2.0
// What a calibration left over, as pictures: where in the colour picture corners lie off, and by
// how much depth is off at which distance, before and after. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/calibration/sensor_calibration.h"
#include "roomcast/core/image.h"

namespace roomcast::alignment::calibration {

/// Every corner of every view, with its error a hundredfold; the picture shows what part of the
/// field of view the boards covered.
[[nodiscard]] ColorImage corner_error_picture(const LensFit& lens);

/// Each view's mean error against its distance: hollow before, filled after.
[[nodiscard]] ColorImage depth_error_picture(const DepthFit& depth);

}  // namespace roomcast::alignment::calibration
