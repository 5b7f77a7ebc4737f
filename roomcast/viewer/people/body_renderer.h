// SPDX-License-Identifier: Apache-2.0
// BodyRenderer: draws people's heads, hands and laser pointers into a room: a head with a visor,
// balls as hands, a beam with a spot at its end. Shapes and sizes as on the page
// (web/src/view/avatars.ts). Draws into the bound framebuffer and its depth; needs the GL context
// it was made with.
#pragma once

#include <span>

#include "roomcast/client/room/person_pose.h"
#include "roomcast/core/image.h"
#include "roomcast/render/view/eyes.h"
#include "roomcast/viewer/people/avatars.h"
#include "roomcast/viewer/people/shaders.h"

namespace roomcast::viewer {

class BodyRenderer {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<BodyRenderer> create();

  void draw(const render::Eyes& eyes, std::span<const Avatar> avatars);
  /// Draws this viewer's hands and beam, without a head, because the eyes are there.
  void draw_own(const render::Eyes& eyes, const client::PersonPose& self, Rgb8 color);

 private:
  using Program =
      render::DrawProgram<render::Vertex<render::shaders::eyes_glsl, shaders::body_vert>,
                          render::Fragment<shaders::body_frag>>;

  explicit BodyRenderer(Program program);
  void begin(const render::Eyes& eyes);
  void draw_head(const RigidTransform& world_from_head, Rgb8 color) const;
  void draw_hands_and_beam(const client::PersonPose& pose, Rgb8 color) const;
  void draw_beam(const client::PointerBeam& beam, Rgb8 color) const;
  void draw_ball(const RigidTransform& world_from_ball, const Eigen::Vector3d& radii_m, Rgb8 color,
                 float own_light) const;

  Program program_;
  render::GlVertexArray no_attributes_;
  GLsizei eyes_ = 1;  // of the picture being drawn
};

}  // namespace roomcast::viewer
