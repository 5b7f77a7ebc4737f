// SPDX-License-Identifier: Apache-2.0
// SightingDetector: detects heads and printed tags in a sensor's view while the aligner requests
// them. With these sightings, sensors with too little overlap can be placed by a person who walks
// around or carries a board. Several detections a second, a message twice a second.
// Single-threaded.
#pragma once

#include <optional>

#include "roomcast/alignment/board/tag_tracker.h"
#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/alignment/person/head_detector.h"
#include "roomcast/core/clock.h"
#include "roomcast/source/frame_source.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::sensor {

inline constexpr std::chrono::milliseconds kHeadInterval{110};
inline constexpr std::chrono::milliseconds kTagInterval{240};  // more expensive than heads
inline constexpr std::chrono::milliseconds kSightingsMessageInterval{500};

class SightingDetector {
 public:
  /// The bundle of the sensor's current pose; nothing: the sensor was moved, and its new pose is
  /// unknown.
  void stand(std::optional<alignment::CalibrationBundle> bundle);

  /// Sets the sightings that the aligner requests now.
  void want(const wire::pb::SightingRequest& request) { wanted_ = request; }

  /// Takes a frame that was captured at `taken`. Returns a message when one is due.
  [[nodiscard]] std::optional<wire::pb::Sightings> add(const source::CapturedFrame& frame,
                                                       RoomTime taken);

 private:
  void detect_heads(const source::CapturedFrame& frame, RoomTime taken);
  void detect_tags(const source::CapturedFrame& frame, RoomTime taken);

  wire::pb::SightingRequest wanted_;
  std::optional<alignment::CalibrationBundle> bundle_;
  std::optional<alignment::HeadDetector> heads_;  // made when first asked for
  bool sees_floor_ = true;                        // true until the bundle shows otherwise
  std::optional<alignment::TagTracker> tags_;     // made when first asked for
  std::optional<RoomTime> last_heads_, last_tags_, last_message_;
  wire::pb::Sightings seen_;
};

}  // namespace roomcast::sensor
