// SPDX-License-Identifier: Apache-2.0
// RoomPicture: an off-screen picture of the room in the size that a ViewTarget needs, with its
// drawing time. Needs the GL context it was made with.
#pragma once

#include <array>
#include <optional>

#include "roomcast/core/clock.h"
#include "roomcast/render/gl/gl_object.h"
#include "roomcast/render/view/offscreen_target.h"
#include "roomcast/viewer/view/room_view.h"
#include "roomcast/viewer/view/view_target.h"

namespace roomcast::viewer {

struct GlQueryKind {
  static GLuint create();  // GL_TIME_ELAPSED
  static void destroy(GLuint name);
};
using GlQuery = render::GlObject<GlQueryKind>;

/// Measures the GPU time of pictures without waiting for the GPU. Drivers exist whose answers are
/// longer than the time since begin(): those are dropped.
class DrawTimer {
 public:
  void begin();
  void end();
  /// The time of the newest finished picture; empty if none has finished since the last call.
  [[nodiscard]] std::optional<nanoseconds> take();

 private:
  static constexpr std::size_t kInFlight = 4;
  std::array<GlQuery, kInFlight> queries_ = {GlQuery::create(), GlQuery::create(),
                                             GlQuery::create(), GlQuery::create()};
  std::array<HostTime, kInFlight> begins_{};
  std::size_t begun_ = 0, taken_ = 0;  // running counts
  bool measures_ = false;
};

class RoomPicture {
 public:
  /// Draws at the eyes' size. Errors as OffscreenTarget::create and RoomView::draw.
  Status draw(RoomView& room, const render::Eyes& eyes, render::RenderMode mode);

  /// Null before the first draw().
  [[nodiscard]] const render::OffscreenTarget* target() const {
    return target_ ? &*target_ : nullptr;
  }
  [[nodiscard]] std::optional<nanoseconds> take_drawing_time() { return timer_.take(); }

 private:
  std::optional<render::OffscreenTarget> target_;
  DrawTimer timer_;
};

/// The surface point at a pixel (from the top left) of a picture drawn for `camera`; empty if there
/// is no surface. World frame, metres. Waits for drawing to finish.
[[nodiscard]] std::optional<Eigen::Vector3d> surface_at(const render::OffscreenTarget& picture,
                                                        const render::ViewCamera& camera, int x,
                                                        int y);

/// The point at this OpenGL depth (0 near to 1 far). World frame, metres.
[[nodiscard]] Eigen::Vector3d world_from_pixel(const render::ViewCamera& camera, double x, double y,
                                               double depth);

}  // namespace roomcast::viewer
