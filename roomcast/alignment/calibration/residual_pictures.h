// SPDX-License-Identifier: Apache-2.0
// Pictures of the residuals of a calibration: the corner errors over the colour picture, and the
// depth error over distance, before and after. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/calibration/sensor_calibration.h"
#include "roomcast/core/image.h"

namespace roomcast::alignment::calibration {

/// All corners of all views, with errors magnified a hundredfold; the picture also shows the part
/// of the field of view that the boards covered.
[[nodiscard]] ColorImage corner_error_picture(const LensFit& lens);

/// Each view's mean error over its distance: hollow before, filled after the fit.
[[nodiscard]] ColorImage depth_error_picture(const DepthFit& depth);

}  // namespace roomcast::alignment::calibration
