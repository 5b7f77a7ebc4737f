// SPDX-License-Identifier: Apache-2.0
// Ground-truth pictures from free viewpoints that belong to a simulated rig (`truth/views.json`,
// written by `roomcast simulate --views`): a viewer should see them from positions without a
// sensor.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/dataset/rig_json.h"
#include "roomcast/render/view/view_camera.h"

namespace roomcast::bench {

struct TruthViewEntry {
  int view = 0, instant = 0;
  render::ViewCamera camera;
  RoomTime time;  // of the rig's true clock
  std::filesystem::path color, depth, seen;
  std::vector<std::uint64_t> frames;  // for each sensor of the rig, the frame nearest in time
};

struct TruthViews {
  recording::RigDescription rig;
  std::vector<TruthViewEntry> entries;
};

struct TruthView {
  ColorImage color;
  DepthImage depth_mm;  // along the eye's axis
  MaskImage seen;       // bit i: sensor i sees the surface now
};

/// The surface points of a true view, in the world.
class ViewPoints {
 public:
  explicit ViewPoints(const render::ViewCamera& camera);
  /// `depth_m` along the eye's axis.
  [[nodiscard]] Eigen::Vector3d at(int x, int y, double depth_m) const;

 private:
  RigidTransform world_from_optical_;
  double focal_px_;
  Eigen::Vector2d middle_px_;
};

/// kNotFound: there is no such file. kMalformed, naming the file: it is not as above.
[[nodiscard]] Result<TruthViews> read_truth_views(const std::filesystem::path& rig_folder);

/// Errors as ImageFileReader's.
[[nodiscard]] Result<TruthView> load(const TruthViewEntry& entry);

}  // namespace roomcast::bench
