// SPDX-License-Identifier: Apache-2.0
// Calibration bundles <-> the wire's message: depth lossless, colour as JPEG. docs/spec/wire.md §3.
#pragma once

#include <string>

#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::alignment {

/// kInvalidArgument: the bundle is not usable; the sentence gives the reason.
[[nodiscard]] Result<wire::pb::CalibrationBundle> message_from_bundle(
    const alignment::CalibrationBundle& bundle);

/// `name` and `calibration` from the roster. kMalformed: the bytes are not pictures of these
/// cameras.
[[nodiscard]] Result<alignment::CalibrationBundle> bundle_from_message(
    const wire::pb::CalibrationBundle& message, std::string name,
    const SensorCalibration& calibration);

}  // namespace roomcast::alignment
