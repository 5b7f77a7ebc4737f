// SPDX-License-Identifier: Apache-2.0
// DepthCamera: the depth camera of a simulated sensor. Static surfaces and their systematic errors
// are computed once; a frame costs only the moving things and the noise. Const calls are
// thread-safe if every thread uses its own Work.
#pragma once

#include <utility>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/parallel_rows.h"
#include "roomcast/simulator/people/moving_layer.h"
#include "roomcast/simulator/people/moving_outline.h"
#include "roomcast/simulator/people/moving_things.h"
#include "roomcast/simulator/sensing/depth_sensing.h"
#include "roomcast/simulator/sensing/mutual_interference.h"
#include "roomcast/simulator/sensing/sensor_unit.h"
#include "roomcast/simulator/simulated_room.h"
#include "roomcast/simulator/tracing/static_plate.h"

namespace roomcast::simulator {

class DepthCamera {
 public:
  /// Memory of one thread, with the depth at the instant of the last draw.
  struct Work {
    MovingLayer layer, fine_layer;  // the fine one is drawn on the outline only
    MovingOutline outline;
    FrameNoise noise;
    DepthImage clean_mm;
  };

  DepthCamera(const SimulatedRoom& room, const SensorUnit& unit,
              const RigidTransform& world_from_depth, const SensingOptions& options,
              const Workers& workers);

  /// From now on the light of other sensors disturbs this one.
  void expose_to(MutualInterference others) { others_ = std::move(others); }

  [[nodiscard]] Work make_work() const;
  [[nodiscard]] const PlacedCamera& placed() const { return camera_; }
  [[nodiscard]] const DepthPlate& plate() const { return plate_; }
  /// Depth of the empty room in millimetres.
  [[nodiscard]] const DepthImage& still_mm() const { return still_mm_; }

  /// Renders the things in their current state. Must precede the other calls for each instant.
  void draw(const MovingThings& things, Work& work) const;
  /// True depth in millimetres at the last draw.
  [[nodiscard]] const DepthImage& clean_mm(const Work& work) const { return work.clean_mm; }
  /// Sets 255 where the true depth is that of a movable thing, 0 elsewhere.
  void mark_moving(const Work& work, MaskImage& moving) const;

  /// The reported depth: a function of `key` and of the scene time (interference).
  void read(const MovingThings& things, std::uint32_t key, nanoseconds scene_time, Work& work,
            DepthImage& depth_mm) const;
  /// The reported depth without random effects, that is with systematic errors only; next to an
  /// edge, the surface at the pixel's centre; 0 where there is never a reading.
  void expect(const MovingThings& things, const Work& work, DepthImage& depth_mm) const;

 private:
  [[nodiscard]] Image<ExpectedReading> expect_still() const;
  [[nodiscard]] DepthReading centre_of(const MovingThings& things, const Work& work, int x,
                                       int y) const;
  [[nodiscard]] OtherSurface beside(const DepthReading& centre, const MovingThings& things,
                                    const Work& work, int x, int y) const;
  [[nodiscard]] bool shows_moving(const Work& work, int x, int y) const;
  [[nodiscard]] const Surface& surface_at(const MovingThings& things, const MovingLayer& layer,
                                          int x, int y) const;
  [[nodiscard]] FineSample fine_sample(const MovingThings& things, const Work& work, int x,
                                       int y) const;
  /// Calls `what(x, y, sees)` for each pixel that shows a moving thing.
  template <class Do>
  void for_each_moving(const Work& work, Do&& what) const;
  void read_moving(const MovingThings& things, Work& work, ImageView<std::uint16_t> out) const;

  /// What happens to the picture after sensing: patches, foreign light, shadow, steps, scale.
  void finish(const Work& work, nanoseconds scene_time, ImageView<std::uint16_t> depth_mm) const;

  const Room& room_;
  bool noise_;
  double depth_scale_;
  std::uint32_t patches_key_;
  PlacedCamera camera_, fine_camera_;
  DepthPlate plate_;
  DepthImage still_mm_;
  DepthSensing sensing_;
  StillDepth still_;
  Interference interference_;
  MutualInterference others_;
  GaussianTable gaussians_;
};

}  // namespace roomcast::simulator
