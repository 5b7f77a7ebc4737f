// SPDX-License-Identifier: Apache-2.0
// The depth camera of a simulated sensor in its room. What stands still is traced and its errors
// worked out once; a frame costs what moves, and the noise. Const calls are thread-safe as long as
// every thread brings its own Work.
#pragma once

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/simulator/people/moving_layer.h"
#include "roomcast/simulator/people/moving_outline.h"
#include "roomcast/simulator/people/moving_things.h"
#include "roomcast/simulator/sensing/depth_sensing.h"
#include "roomcast/simulator/sensing/sensor_unit.h"
#include "roomcast/simulator/simulated_room.h"
#include "roomcast/simulator/tracing/static_plate.h"

namespace roomcast::simulator {

class DepthCamera {
 public:
  /// Memory of one thread, and what is to be seen at the instant it was last drawn for.
  struct Work {
    MovingLayer layer, fine_layer;  // the fine one on the outline only
    MovingOutline outline;
    FrameNoise noise;
    DepthImage clean_mm;
  };

  DepthCamera(const SimulatedRoom& room, const SensorUnit& unit,
              const RigidTransform& world_from_depth, const SensingOptions& options, int threads);

  [[nodiscard]] Work make_work() const;
  [[nodiscard]] const PlacedCamera& placed() const { return camera_; }
  [[nodiscard]] const DepthPlate& plate() const { return plate_; }
  /// The empty room.
  [[nodiscard]] const DepthImage& still_mm() const { return still_mm_; }

  /// Looks at the things where they are now. First of all for every instant.
  void draw(const MovingThings& things, Work& work) const;
  /// What is there, in millimetres: of the last draw.
  [[nodiscard]] const DepthImage& clean_mm(const Work& work) const { return work.clean_mm; }
  /// 255 where that is something that can move, 0 elsewhere.
  void mark_moving(const Work& work, MaskImage& moving) const;

  /// What the sensor reports of it: a function of `key` and of the scene time (interference).
  void read(const MovingThings& things, std::uint32_t key, nanoseconds scene_time, Work& work,
            DepthImage& depth_mm) const;
  /// What it would report without anything random: with its systematic errors alone; beside an edge
  /// the surface at the pixel's centre; 0 where there is never a reading.
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
  /// Calls `what(x, y, sees)` for the pixels that see something that moves.
  template <class Do>
  void for_each_moving(const Work& work, Do&& what) const;
  void read_moving(const MovingThings& things, Work& work, ImageView<std::uint16_t> out) const;

  const Room& room_;
  bool noise_;
  PlacedCamera camera_, fine_camera_;
  DepthPlate plate_;
  DepthImage still_mm_;
  DepthSensing sensing_;
  StillDepth still_;
  Interference interference_;
  GaussianTable gaussians_;
};

}  // namespace roomcast::simulator
