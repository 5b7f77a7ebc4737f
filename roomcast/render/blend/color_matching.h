// SPDX-License-Identifier: Apache-2.0
// ColorMatching: corrects colour differences between cameras (white balance, exposure). Computes a
// factor per sensor and channel from surfaces that two sensors both see: the median ratio of each
// pair, then log_gains() over all pairs. Runs on the CPU, on a fraction of the pictures and a few
// pairs at a time, so that no picture of a large room waits for it. Single-threaded.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/ids.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/color_balance.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::render {

class ColorMatching {
 public:
  /// Uses a sensor's first picture and then every kEvery-th; sensors take turns. All images have
  /// the size of `lens`.
  void offer(SensorId sensor, const CameraIntrinsics& lens, DepthView depth_mm, ColorView color,
             MaskView seen);
  void forget(SensorId sensor);

  /// Compares pairs of sensors that have new pictures or poses, at most kMaxComparisons of them,
  /// and recomputes the factors. A change is applied over several updates.
  void update(const std::map<SensorId, RigidTransform>& world_from_depth);

  /// Factors, red first; 1 while nothing is known.
  [[nodiscard]] Eigen::Vector3f gain(SensorId sensor) const;

  static constexpr int kEvery = 10;
  static constexpr std::size_t kMaxComparisons = 6;  // per update: all pairs of three sensors

 private:
  /// A place that a sensor sees: where, in its depth frame in metres, and in which colour.
  struct Place {
    Eigen::Vector3d point_m;
    Rgb8 color;
  };
  struct Picture {
    CameraIntrinsics lens;
    DepthImage depth_mm;
    ColorImage color;
    MaskImage seen;
    std::vector<Place> places;  // on a grid
    Eigen::Vector3f log_gain = Eigen::Vector3f::Zero();
    int skipped = kEvery;       // so that the first picture is used
    std::uint64_t version = 0;  // grows with each picture that is used
  };
  /// A sensor's places beside what another sensor sees there.
  struct Comparison {
    std::uint64_t version = 0, other_version = 0;  // of the compared pictures; 0: none yet
    RigidTransform other_from_sensor;
    std::uint64_t made_in = 0;        // number of the update
    std::optional<ColorRatio> ratio;  // the cameras' numbers are not set
  };
  using Pair = std::pair<SensorId, SensorId>;

  [[nodiscard]] static std::vector<Place> places_of(const Picture& picture);
  [[nodiscard]] static std::optional<ColorRatio> compare(const Picture& a, const Picture& b,
                                                         const RigidTransform& b_from_a);
  [[nodiscard]] std::vector<Pair> outdated(
      const std::map<SensorId, RigidTransform>& world_from_depth);
  void solve(const std::map<SensorId, RigidTransform>& world_from_depth);

  std::map<SensorId, Picture> pictures_;
  std::map<Pair, Comparison> comparisons_;
  std::uint64_t updates_ = 0;
};

}  // namespace roomcast::render
