// SPDX-License-Identifier: Apache-2.0
// One simulated sensor in its room: renders what it sees at any instant, with
// or without its noise. The empty room is traced once at opening; a frame then
// costs the person, the copy and the noise. Without noise the pictures are the
// truth. Metres; scene time starts at 0 and may be any instant.
// Single-threaded.
#pragma once

#include <memory>
#include <string>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/source/simulator/people/moving_layer.h"
#include "roomcast/source/simulator/people/moving_picture.h"
#include "roomcast/source/simulator/people/moving_things.h"
#include "roomcast/source/simulator/people/surface_texels.h"
#include "roomcast/source/simulator/scene/room.h"
#include "roomcast/source/simulator/sensing/sensor_noise.h"
#include "roomcast/source/simulator/tracing/static_plate.h"

namespace roomcast {

class SimulatedSensor {
public:
  struct Options {
    std::string scene; // "" or "livingroom", "office"
    int sensor_index = 0;
    int sensor_count =
        3; // how many stand around the room, 1..sim::kMaxSimulatedSensors
    std::uint64_t seed = 1; // noise, and how things look
    double speed = 1; // of all motion: 0.05 is slow motion, 0 stands still
  };

  /// kNotFound for an unknown scene (the message lists them); kInvalidArgument
  /// for an index or count out of range; kUnavailable when the ray tracer does
  /// not start.
  static Result<std::unique_ptr<SimulatedSensor>> open(const Options &options);

  [[nodiscard]] const SensorCalibration &calibration() const {
    return calibration_;
  }
  [[nodiscard]] const RigidTransform &world_from_depth() const {
    return depth_camera_.world_from_camera();
  }
  [[nodiscard]] const sim::Room &room() const { return *room_; }

  /// Depth and colour of `scene_time`. The noise is a function of (seed,
  /// sensor, frame_index). The pictures keep their memory when they have the
  /// right size already.
  void render(nanoseconds scene_time, std::uint64_t frame_index,
              DepthImage &depth_mm, ColorImage &color, bool with_noise);

  /// Depth of `scene_time` without noise, alone: what `render` without noise
  /// gives.
  void render_true_depth(nanoseconds scene_time, DepthImage &depth_mm);

  /// 255 where the depth of `scene_time` is that of something moving, 0
  /// elsewhere.
  void render_moving(nanoseconds scene_time, MaskImage &moving);

private:
  SimulatedSensor(const Options &options, std::unique_ptr<const sim::Room> room,
                  const sim::RayScene &scene);

  [[nodiscard]] std::uint32_t noise_key(std::uint64_t frame_index) const;
  void render_depth(std::uint32_t key, bool with_noise,
                    ImageView<std::uint16_t> out);
  void render_color(ImageView<Rgb8> out);

  Options options_;
  std::unique_ptr<const sim::Room> room_;
  SensorCalibration calibration_;
  sim::PlacedCamera depth_camera_, color_camera_;
  sim::DepthPlate depth_plate_;
  sim::ColorPlate color_plate_;
  DepthImage plate_mm_;
  sim::MovingThings things_;
  sim::SurfaceTexels texels_;
  sim::MovingLayer things_in_depth_, things_in_color_;
  sim::MovingColors moving_colors_;
  sim::GaussianTable gaussians_;
  sim::DepthNoise depth_noise_;
};

} // namespace roomcast
