// SPDX-License-Identifier: Apache-2.0
// Draws the surfaces of all sensors of a room in one world, from any eye or two at once.
// Single-threaded; needs a current OpenGL 4.5 context (EglContext) for its whole life.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "roomcast/core/ids.h"
#include "roomcast/render/blend/adaptive_renderer.h"
#include "roomcast/render/blend/background_model.h"
#include "roomcast/render/blend/blend_renderer.h"
#include "roomcast/render/blend/color_matching.h"
#include "roomcast/render/render_mode.h"
#include "roomcast/render/surface/floor_grid.h"
#include "roomcast/render/surface/mesh_renderer.h"
#include "roomcast/render/surface/point_renderer.h"
#include "roomcast/render/surface/sensor_surface.h"
#include "roomcast/render/surface/surface_mesh.h"
#include "roomcast/render/view/eyes.h"
#include "roomcast/render/view/offscreen_target.h"

namespace roomcast::render {

struct RenderOptions {
  Rgb8 background = {24, 26, 30};
  bool floor_grid = true;
  Rgb8 floor_line = {150, 160, 175};
  SurfaceMeshOptions mesh;
  /// For modes that need it: every picture is remembered, whichever mode is drawn.
  bool remember = true;
  Unseen unseen = Unseen::kSurroundings;  // for RenderMode::kBlend

  /// As SurfaceMeshOptions::check.
  [[nodiscard]] Status check() const { return mesh.check(); }
};

/// More sensors than this are refused: each holds some ten megabytes of the graphics card's memory.
inline constexpr std::size_t kMaxRenderedSensors = 64;

class RoomRenderer {
 public:
  /// kUnsupported with the driver's log when it does not take the shaders.
  static Result<RoomRenderer> create();

  /// Adds a sensor, or gives it another pose. It keeps its pictures unless its lens is another one.
  /// Fails as SensorSurface::create does; kTooLarge beyond kMaxRenderedSensors; kInvalidArgument
  /// for a pose that is not finite. On failure nothing has changed.
  Status set_sensor(SensorId id, const CameraIntrinsics& depth,
                    const RigidTransform& world_from_depth);

  /// Whether it only stands beside the room, because nobody knows where it is: it is drawn by
  /// itself, as a mesh where others are mixed, and what it sees tells nothing about what others
  /// remember. Nothing happens when there is no such sensor.
  void set_apart(SensorId id, bool apart);

  /// The sensor's newest pictures. kNotFound without a set_sensor before it; else as
  /// SensorSurface::upload.
  Status upload(SensorId id, DepthView depth_mm, ColorView color, MaskView seen);

  /// Nothing happens when there is no such sensor.
  void remove(SensorId id);

  /// Fails as RenderOptions::check does, changing nothing.
  Status set_look(const RenderOptions& look);

  /// A new picture in all of `target`, for as many eyes as it has room for: each sensor's surface
  /// is drawn once for all of them. kInvalidArgument when an eye is not legal, as Eyes::check, or
  /// not of the target's size.
  Status draw(const Eyes& eyes, const OffscreenTarget& target, RenderMode mode);

 private:
  struct Sensor {
    SensorSurface surface;
    RigidTransform world_from_depth;
    SurfaceMesh mesh;
    BackgroundModel memory;
    bool memory_is_fresh = false;
    bool is_apart = false;
  };
  struct Parts {
    PointRenderer points;
    SurfaceMesher mesher;
    MeshRenderer meshes;
    FloorGrid floor;
    BackgroundUpdater memories;
    AdaptiveRenderer adaptive;
    BlendRenderer blend;
  };

  explicit RoomRenderer(Parts parts) : parts_(std::move(parts)) {}
  void draw_sensors(const Eyes& eyes, RenderMode mode);
  void draw_apart(const Eyes& eyes);
  void draw_sensor(SensorId id, Sensor& sensor, const Eyes& eyes, RenderMode mode);
  void gather_layers(RenderMode mode);
  void refresh_memories();

  Parts parts_;
  ColorMatching colors_;
  RenderOptions look_;
  std::vector<SurfaceLayer> layers_;  // of the newest picture
  std::map<SensorId, Sensor>
      sensors_;  // in order, so that the same room always gives the same picture
};

}  // namespace roomcast::render
