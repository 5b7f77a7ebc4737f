// SPDX-License-Identifier: Apache-2.0
// Coarse depth: how far the surfaces in a sensor's view are, in a few cells, for the hub, which
// decodes no frames (docs/spec/wire.md §3 "Only what a viewer looks at").
#pragma once

#include <optional>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::sensor {

/// Of each of 12 x 9 cells the distance that a tenth of its readings fall short of, and the one
/// that a tenth exceed. A cell with hardly any readings shows nothing.
[[nodiscard]] wire::pb::CoarseDepth coarse_depth(DepthView depth_mm);

/// Decides when to send it: once a second while it changes, and now and then while it does not,
/// since a hub forgets it when the sensor reconnects.
class CoarseDepthReporter {
 public:
  /// Takes a frame; returns the message to send, if one is due.
  [[nodiscard]] std::optional<wire::pb::CoarseDepth> add(DepthView depth_mm, HostTime captured);

 private:
  std::optional<HostTime> looked_, sent_;
  wire::pb::CoarseDepth last_;  // as sent
};

}  // namespace roomcast::sensor
