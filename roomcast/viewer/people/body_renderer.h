// SPDX-License-Identifier: Apache-2.0
// Draws people's heads, hands and laser pointers among the surfaces of a room: a head with a visor,
// balls for hands, a beam with a spot at its end; shapes and sizes as on the page
// (web/src/view/avatars.ts). Draws into the bound framebuffer and its depth; needs the GL context
// it was made with.
#pragma once

#include <span>

#include "roomcast/client/room/person_pose.h"
#include "roomcast/core/image.h"
#include "roomcast/render/gl/gl_program.h"
#include "roomcast/render/view/eyes.h"
#include "roomcast/viewer/people/avatars.h"

namespace roomcast::viewer {

class BodyRenderer {
 public:
  /// kUnsupported with the driver's log when it does not take the shaders.
  static Result<BodyRenderer> create();

  void draw(const render::Eyes& eyes, std::span<const Avatar> avatars);
  /// The hands and the beam of the one who looks; the head is where the eyes are.
  void draw_own(const render::Eyes& eyes, const client::PersonPose& self, Rgb8 color);

 private:
  explicit BodyRenderer(render::GlProgram program);
  void begin(const render::Eyes& eyes);
  void draw_head(const RigidTransform& world_from_head, Rgb8 color) const;
  void draw_hands_and_beam(const client::PersonPose& pose, Rgb8 color) const;
  void draw_beam(const client::PointerBeam& beam, Rgb8 color) const;
  void draw_ball(const RigidTransform& world_from_ball, const Eigen::Vector3d& radii_m, Rgb8 color,
                 float own_light) const;

  render::GlProgram program_;
  render::GlVertexArray no_attributes_;
  GLsizei eyes_ = 1;  // of the picture that was begun
};

}  // namespace roomcast::viewer
