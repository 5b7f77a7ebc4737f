// SPDX-License-Identifier: Apache-2.0
// InstantReporter: what the sensor sees at moments that all sensors of the room share, for the
// aligner (alignment/bundle/depth_instants.h). While nothing moves only few are reported: that
// somebody is seen elsewhere says something about poses, too. Single-threaded.
#pragma once

#include <optional>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::sensor {

class InstantReporter {
 public:
  /// The steady depth of what the sensor sees, millimetres; empty: it is not known.
  void stand(const DepthImage& steady_mm);

  /// Takes the depth of a frame that was captured at `taken`. Returns a message when one is due;
  /// its depth_scale is left to the caller.
  [[nodiscard]] std::optional<wire::pb::DepthInstant> add(const DepthImage& depth_mm,
                                                          RoomTime taken);

 private:
  DepthImage steady_mm_;  // in blocks
  std::optional<long long> moment_;
};

}  // namespace roomcast::sensor
