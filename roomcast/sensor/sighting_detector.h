// SPDX-License-Identifier: Apache-2.0
// SightingDetector: what a sensor tells of that passes through its view while the aligner asks for
// it: heads and printed tags, so that sensors which share too little can be placed by somebody who
// walks about, or holds a board. Some looks a second, a message twice a second. Single-threaded.
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
inline constexpr std::chrono::milliseconds kTagInterval{240};  // dearer
inline constexpr std::chrono::milliseconds kSightingsMessageInterval{500};

class SightingDetector {
 public:
  /// The sensor stands where it saw this; nothing: it was moved, and nobody knows where it stands.
  void stand(std::optional<alignment::CalibrationBundle> bundle);

  /// What is asked for now.
  void want(const wire::pb::SightingRequest& request) { wanted_ = request; }

  /// `taken` is when the frame was. A message when it is time for one.
  [[nodiscard]] std::optional<wire::pb::Sightings> add(const source::CapturedFrame& frame, RoomTime taken);

 private:
  void look_for_heads(const source::CapturedFrame& frame, RoomTime taken);
  void look_for_tags(const source::CapturedFrame& frame, RoomTime taken);

  wire::pb::SightingRequest wanted_;
  std::optional<alignment::CalibrationBundle> bundle_;
  std::optional<alignment::HeadDetector> heads_;  // made when first asked for
  bool sees_floor_ = true;                    // as far as is known
  std::optional<alignment::TagTracker> tags_;     // made when first asked for
  std::optional<RoomTime> last_heads_, last_tags_, last_message_;
  wire::pb::Sightings seen_;
};

}  // namespace roomcast::sensor
