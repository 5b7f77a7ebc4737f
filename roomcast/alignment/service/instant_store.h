// SPDX-License-Identifier: Apache-2.0
// InstantStore: what the sensors of a running room saw at moments that they share. People who walk
// through the room tell poses from their half turns and repeats, and reveal sensors whose depth is
// too long or too short (depth_instants.h). The newest instants of each sensor are kept.
// Single-threaded.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "roomcast/alignment/bundle/depth_instants.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::alignment {

/// Reads an instant of a sensor with this depth camera. kMalformed: its bytes are not a picture of
/// the camera's blocks.
[[nodiscard]] Result<DepthInstant> instant_from_message(const wire::pb::DepthInstant& message,
                                                        const CameraIntrinsics& depth_camera);
/// kInvalidArgument: the picture is too small.
[[nodiscard]] Result<wire::pb::DepthInstant> message_from_instant(const DepthInstant& instant);

class InstantStore {
 public:
  static constexpr std::size_t kMaxInstants = 60;  // of each sensor

  /// `depth_scale`: the factor that the sensor has applied to its readings.
  void add(const std::string& sensor, DepthInstant instant, double depth_scale);
  void forget(const std::string& sensor);

  /// The sensor's instants, with readings as with this factor.
  [[nodiscard]] std::vector<DepthInstant> of(const std::string& sensor, double depth_scale) const;

  /// At how many moments two sensors or more have seen something move, since forget().
  [[nodiscard]] std::size_t shared_moments();

 private:
  struct Entry {
    DepthInstant instant;
    double depth_scale = 1;
  };
  std::map<std::string, std::deque<Entry>> entries_;
  std::set<long long> shared_;  // moments, in units of their interval
  bool is_counted_ = false;     // `shared_` is of all entries
};

}  // namespace roomcast::alignment
