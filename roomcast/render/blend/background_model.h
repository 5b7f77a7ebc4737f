// SPDX-License-Identifier: Apache-2.0
// BackgroundModel: two clean surfaces of one sensor: its live surface and the remembered background
// behind it. The background fills areas hidden by people or briefly without readings. It is removed
// where any sensor sees through it; objects in front of it that give no readings are drawn in front
// of it (DepthCompletion). Single-threaded; needs the GL context it was made with.
#pragma once

#include <span>
#include <utility>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/render/blend/clean_surface.h"
#include "roomcast/render/blend/depth_completion.h"
#include "roomcast/render/blend/surface_flow.h"
#include "roomcast/render/surface/sensor_surface.h"

namespace roomcast::render {

/// Another sensor, used to find surfaces that it sees through.
struct OtherSensor {
  const SensorSurface* surface = nullptr;
  RigidTransform other_from_depth;
  bool is_late = false;
};

class BackgroundModel {
 public:
  explicit BackgroundModel(const CameraIntrinsics& lens);

  [[nodiscard]] const CleanSurface& live() const { return live_; }
  [[nodiscard]] const CleanSurface& background() const { return background_; }

 private:
  friend class BackgroundUpdater;
  /// Clears all colours if the scale changes.
  void set_color_scale(int scale);

  GlTexture newest_m_;          // R32F: the newest readings, 0 without a reading
  GlTexture steadiness_;        // R16F: see update_background.comp
  GlTexture classes_, seen_;    // R8UI: see DepthCompletion
  GlTexture readings_;          // RGBA32F: see update_background.comp
  GlTexture background_color_;  // RGBA16F, scaled: rgb, readings
  int color_scale_ = 0;
  CleanSurface live_, background_;
};

/// The shader programs that update background models; shared by all sensors.
class BackgroundUpdater {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<BackgroundUpdater> create();

  /// Updates the model with the sensor's new picture. Call it for every picture, drawn or not.
  void update(const SensorSurface& sensor, BackgroundModel& model) const;

  struct Options {
    SurfaceMeshOptions mesh;
    Eigen::Vector3f gain;  // for the sensor's colours, red first
    bool is_late = false;  // then the live surface is removed where another sensor sees through it
    SurfaceFlow& flow;     // of the sensor: gets its velocities
  };

  /// Computes both surfaces for drawing. Call it when all sensors have their newest pictures, and
  /// after a sensor was moved.
  void refresh(const SensorSurface& sensor, std::span<const OtherSensor> others,
               const Options& options, BackgroundModel& model);

 private:
  struct Parts {
    ComputeProgram<shaders::sensor_surface_glsl, shaders::depth_noise_glsl,
                   shaders::update_background_comp>
        update;
    ComputeProgram<shaders::sensor_surface_glsl, shaders::background_depth_comp> background;
    ComputeProgram<shaders::carve_comp> carve;
    DepthCompletion completion;
    SurfaceCleaner cleaner;
    FlowInterpolation flow;
  };
  explicit BackgroundUpdater(Parts parts) : parts_(std::move(parts)) {}
  void carve(const SensorSurface& sensor, const OtherSensor& other, const GlTexture& depth) const;

  Parts parts_;
};

}  // namespace roomcast::render
