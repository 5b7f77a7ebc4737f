// SPDX-License-Identifier: Apache-2.0
// BackgroundModel: what one sensor shows now and what it has seen behind that before: two clean
// surfaces. The remembered background fills what people hide and what a sensor momentarily loses;
// it gives way where any sensor looks through it, and what stands before it without a reading is
// drawn before it. Single-threaded; needs the GL context it was made
// with.
#pragma once

#include <span>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/render/blend/clean_surface.h"
#include "roomcast/render/blend/compute_pass.h"
#include "roomcast/render/blend/lost_depth.h"
#include "roomcast/render/surface/sensor_surface.h"

namespace roomcast::render {

/// Of another sensor, to look through what this one remembers.
struct OtherSensor {
  const SensorSurface* surface = nullptr;
  RigidTransform other_from_depth;
};

class BackgroundModel {
 public:
  explicit BackgroundModel(const CameraIntrinsics& lens);

  [[nodiscard]] const CleanSurface& live() const { return live_; }
  [[nodiscard]] const CleanSurface& background() const { return background_; }

 private:
  friend class BackgroundUpdater;
  /// Forgets all colours when it is another one.
  void set_color_scale(int scale);

  GlTexture newest_m_;          // R32F: what was read last, 0 without a reading
  GlTexture steadiness_;        // R16F: remember_background.comp
  GlTexture verdict_, seen_;    // R8UI: LostDepth
  GlTexture readings_;          // RGBA32F: remember_background.comp
  GlTexture background_color_;  // RGBA16F, scaled: rgb, readings
  int color_scale_ = 0;
  CleanSurface live_, background_;
};

/// The programs that keep memories; one for all sensors.
class BackgroundUpdater {
 public:
  /// kUnsupported with the driver's log when it does not take the shaders.
  static Result<BackgroundUpdater> create();

  /// The sensor has a new picture. Every one counts, whether it is drawn or not.
  void remember(const SensorSurface& sensor, BackgroundModel& memory) const;

  /// Makes the surfaces ready to be drawn: when all sensors have their newest pictures, and when
  /// one was moved.
  void refresh(const SensorSurface& sensor, std::span<const OtherSensor> others,
               const SurfaceCleaner::Options& options, BackgroundModel& memory);

 private:
  BackgroundUpdater(ComputePass remember, ComputePass background, ComputePass carve, LostDepth lost,
                    SurfaceCleaner cleaner);
  void carve(const SensorSurface& sensor, const OtherSensor& other, const GlTexture& depth) const;

  ComputePass remember_, background_, carve_;
  LostDepth lost_;
  SurfaceCleaner cleaner_;
};

}  // namespace roomcast::render
