// SPDX-License-Identifier: Apache-2.0
// RoomRenderer: draws the surfaces of all sensors of a room in one world frame, for one or two
// eyes. Single-threaded; needs a current OpenGL 4.5 context (EglContext) for its whole life.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/render/blend/adaptive_renderer.h"
#include "roomcast/render/blend/background_model.h"
#include "roomcast/render/blend/blend_renderer.h"
#include "roomcast/render/blend/color_matching.h"
#include "roomcast/render/blend/still_model.h"
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
  /// Instead of the background, what the picture is laid over: there it is black, with alpha 0
  /// (premultiplied).
  bool background_is_clear = false;
  bool floor_grid = true;
  Rgb8 floor_line = {150, 160, 175};
  SurfaceMeshOptions mesh;
  /// Whether each upload updates the background model, in every mode. Modes that show the
  /// background need it.
  bool update_background = true;
  Unseen unseen = Unseen::kSurroundings;  // for RenderMode::kBlend

  /// As SurfaceMeshOptions::check.
  [[nodiscard]] Status check() const { return mesh.check(); }
};

/// set_sensor refuses more sensors: each takes about ten megabytes of GPU memory.
inline constexpr std::size_t kMaxRenderedSensors = 64;

class RoomRenderer {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<RoomRenderer> create();

  /// Adds a sensor or changes its pose. A sensor keeps its pictures unless its intrinsics change.
  /// Fails as SensorSurface::create does; kTooLarge beyond kMaxRenderedSensors; kInvalidArgument
  /// for a pose that is not finite. On failure nothing has changed.
  Status set_sensor(SensorId id, const CameraIntrinsics& depth,
                    const RigidTransform& world_from_depth);

  /// Marks a sensor whose pose is unknown and that is shown next to the room. It is drawn
  /// separately, as a mesh in the adaptive and blend modes, without effect on other sensors'
  /// colours or background. Does nothing if there is no such sensor.
  void set_unplaced(SensorId id, bool unplaced);

  /// Marks a sensor whose newest pictures are older than the other sensors'. In the adaptive and
  /// blend modes its live surface is left out where a sensor that is not late sees through it: what
  /// moves was there, and is seen elsewhere now. Does nothing if there is no such sensor.
  void set_late(SensorId id, bool late);

  /// Sets the sensor's newest pictures, and how what they show moves. kNotFound without a
  /// set_sensor before it; other errors as SensorSurface::upload.
  Status upload(SensorId id, DepthView depth_mm, ColorView color, MaskView seen,
                const PictureMotion& motion = {});

  /// The blend and adaptive modes draw what moves where it is at this instant, kMaxAhead from the
  /// pictures at most. Without an instant it is in the middle between the sensors' newest pictures,
  /// of those that can be brought to one instant.
  void set_instant(std::optional<RoomTime> instant) { instant_ = instant; }

  /// Does nothing if there is no such sensor.
  void remove(SensorId id);

  /// A piece of the room's model, which the blend mode shows where no sensor shows anything, and
  /// the still mode alone. Errors as StillModel::set_piece.
  Status set_model_piece(const ModelPlace& place, const ModelSurface& surface) {
    return parts_.model.set_piece(place, surface);
  }
  void clear_model() { parts_.model.clear(); }

  /// Errors as RenderOptions::check; then nothing has changed.
  Status set_options(const RenderOptions& options);

  /// Draws a new picture into all of `target`, for as many eyes as it has parts. Each sensor's
  /// surface is drawn once for all eyes. kInvalidArgument if an eye is invalid (Eyes::check) or
  /// does not have the target's size.
  Status draw(const Eyes& eyes, const OffscreenTarget& target, RenderMode mode);

 private:
  struct Sensor {
    SensorSurface surface;
    RigidTransform world_from_depth;
    SurfaceMesh mesh;
    BackgroundModel background_model;
    SurfaceFlow flow;
    bool model_is_fresh = false;
    bool is_unplaced = false;
    bool is_late = false;
  };
  struct Parts {
    PointRenderer points;
    SurfaceMesher mesher;
    MeshRenderer meshes;
    FloorGrid floor;
    BackgroundUpdater updater;
    AdaptiveRenderer adaptive;
    BlendRenderer blend;
    StillModel model;
  };

  explicit RoomRenderer(Parts parts) : parts_(std::move(parts)) {}
  void draw_sensors(const Eyes& eyes, RenderMode mode);
  void draw_unplaced(const Eyes& eyes);
  void draw_sensor(SensorId id, Sensor& sensor, const Eyes& eyes, RenderMode mode);
  [[nodiscard]] std::optional<RoomTime> shown_instant() const;
  void gather_layers(RenderMode mode);
  void refresh_background_models();

  Parts parts_;
  ColorMatching colors_;
  RenderOptions options_;
  std::optional<RoomTime> instant_;
  std::vector<SurfaceLayer> layers_;  // of the last picture
  std::map<SensorId, Sensor>
      sensors_;  // ordered, so that the same room always gives the same picture
};

}  // namespace roomcast::render
