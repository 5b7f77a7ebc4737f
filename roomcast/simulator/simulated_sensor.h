// SPDX-License-Identifier: Apache-2.0
// SimulatedSensor: one simulated sensor in its room: the true view at any instant, and the reported
// frames. The empty room is traced once when the sensor is opened; a frame then costs only the
// moving things and the noise. Reports are a function of (seed, index, frame, scene time,
// exposure): the same on any thread, in any order. Metres; scene time starts at 0 and may be any
// instant. Const calls are thread-safe if every thread uses its own Moment.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/parallel_rows.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/registration.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/simulator/color_camera.h"
#include "roomcast/simulator/depth_camera.h"
#include "roomcast/simulator/sensing/frame_clock.h"
#include "roomcast/simulator/sensing/sensing_options.h"
#include "roomcast/simulator/simulated_room.h"

namespace roomcast::simulator {

class SimulatedSensor {
 public:
  struct Options {
    int index = 0;
    int count = 3;           // sensors around the room, 1..simulator::kMaxSimulatedSensors
    std::uint64_t seed = 1;  // of device differences and noise
    double speed = 1;        // of all motion: 0.05 is slow motion, 0 no motion
    Workers workers = {};    // for tracing the empty room
    simulator::SensingOptions sensing;
    RigidTransform mount_from_depth = {};  // displacement from its mount
    // Of the other sensors' frames, for mutual interference:
    double fps = 30;
    simulator::TimingOptions timing = {};
  };

  /// The sensor's view at an instant, with the memory of one thread.
  class Moment {
   public:
    [[nodiscard]] nanoseconds scene_time() const { return scene_time_; }

   private:
    friend class SimulatedSensor;
    Moment(const SimulatedSensor& sensor);
    nanoseconds scene_time_{};
    simulator::MovingThings things_;
    simulator::DepthCamera::Work depth_;
    simulator::ColorCamera::Work color_;
    // Of sensors that register their colour:
    std::optional<Registration> registration_;
    DepthImage reported_mm_;
    ColorImage unregistered_;
    RegisteredColor registered_;
  };

  /// kInvalidArgument for an index or count out of range; kClosed if the workers were stopped.
  static Result<std::unique_ptr<SimulatedSensor>> open(std::shared_ptr<const SimulatedRoom> room,
                                                       const Options& options);

  /// The reported calibration, and the exact one.
  [[nodiscard]] const SensorCalibration& calibration() const { return unit_.reported; }
  [[nodiscard]] const SensorCalibration& exact_calibration() const { return unit_.exact; }
  [[nodiscard]] const RigidTransform& world_from_depth() const { return world_from_depth_; }
  [[nodiscard]] const simulator::SensorUnit& unit() const { return unit_; }
  [[nodiscard]] const simulator::DepthCamera& depth_camera() const { return depth_; }

  [[nodiscard]] Moment make_moment() const { return Moment(*this); }

  /// Renders the room at an instant. Must precede the calls below.
  void look(nanoseconds scene_time, Moment& moment) const;

  /// Ground truth: depth; mask with 255 where depth is that of a movable thing; colour without
  /// noise, but with the unit's white balance and exposure. The pictures keep their memory.
  [[nodiscard]] const DepthImage& clean_depth_mm(const Moment& moment) const;
  void mark_moving(const Moment& moment, MaskImage& moving) const;
  void clean_color(float exposure, const Moment& moment, ColorImage& color) const;

  /// The reported pictures of frame number `frame`.
  void read_depth(std::uint64_t frame, Moment& moment, DepthImage& depth_mm) const;
  /// The reported depth without random effects.
  void expected_depth(const Moment& moment, DepthImage& depth_mm) const;
  /// A sensor that registers its colour needs its depth: read_depth of that frame must precede.
  void read_color(std::uint64_t frame, float exposure, Moment& moment, ColorImage& color) const;
  /// All gains of linear light at an instant, red first.
  [[nodiscard]] std::array<float, 3> color_gains(float exposure, nanoseconds scene_time) const;

  /// The exposure gains of consecutive frames; 1 without exposure control. Does not need a
  /// preceding look().
  [[nodiscard]] simulator::AutoExposure auto_exposure() const { return color_.auto_exposure(); }
  float next_exposure(nanoseconds scene_time, Moment& moment,
                      simulator::AutoExposure& control) const;

 private:
  SimulatedSensor(std::shared_ptr<const SimulatedRoom> room, const Options& options);
  [[nodiscard]] simulator::MutualInterference light_of_others() const;
  [[nodiscard]] std::uint32_t noise_key(std::uint64_t frame) const;
  void register_color(Moment& moment, ColorImage& color) const;

  std::shared_ptr<const SimulatedRoom> room_;
  Options options_;
  simulator::SensorUnit unit_;
  RigidTransform world_from_depth_;
  simulator::DepthCamera depth_;
  simulator::ColorCamera color_;
};

}  // namespace roomcast::simulator
