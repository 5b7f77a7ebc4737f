// SPDX-License-Identifier: Apache-2.0
// Reads what a C program says of its sensor and of a frame, and checks it: anything may be null,
// huge or no number. Units as in roomcast.h. Threading: no state.
#pragma once

#include "roomcast/capi/roomcast.h"
#include "roomcast/client/publisher.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/sensor/sender/codec_choice.h"

namespace roomcast::capi {

/// How the sensor joins. kInvalidArgument, kMalformed: the sentence names the field.
[[nodiscard]] Result<client::PublisherOptions> publisher_options(
    const roomcast_options* options, const roomcast_sensor_options* sensor);

/// How its frames are encoded. kInvalidArgument: an unknown depth mode; numbers out of range are
/// left to FrameEncoderOptions::check.
[[nodiscard]] Result<sensor::CodecChoice> codec_choice(const roomcast_sensor_options* sensor);

/// A frame of a C program; the views are of its memory.
struct GivenFrame {
  DepthView depth_mm;
  ColorView color;  // no pixels: no colour
  HostTime capture_time{};
};

/// kInvalidArgument: a picture is missing or has another size than `calibration`, or the time is
/// neither now nor a little before.
[[nodiscard]] Result<GivenFrame> given_frame(const roomcast_capture* capture,
                                             const SensorCalibration& calibration, HostTime now);

}  // namespace roomcast::capi
