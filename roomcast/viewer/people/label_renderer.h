// SPDX-License-Identifier: Apache-2.0
// LabelRenderer: draws people's names above their heads, facing each eye, hidden by nearer
// surfaces. Draws into the bound framebuffer; needs the GL context it was made with.
#pragma once

#include <map>
#include <span>
#include <string>

#include "roomcast/core/ids.h"
#include "roomcast/render/view/eyes.h"
#include "roomcast/viewer/people/avatars.h"
#include "roomcast/viewer/people/shaders.h"
#include "roomcast/viewer/text/label_font.h"

namespace roomcast::viewer {

class LabelRenderer {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<LabelRenderer> create();

  void draw(const render::Eyes& eyes, std::span<const Avatar> avatars);

 private:
  struct Label {
    std::string text;
    render::GlBuffer corners;
    render::GlVertexArray vertices;
    GLsizei letter_corners = 0;
    float width_m = 0;
  };

  using Program =
      render::DrawProgram<render::Vertex<render::shaders::eyes_glsl, shaders::label_vert>,
                          render::Fragment<shaders::label_frag>>;

  explicit LabelRenderer(Program program) : program_(std::move(program)) {}
  const Label& label_of(const Avatar& avatar);
  [[nodiscard]] Label make_label(const std::string& text) const;
  void draw_label(const Label& label, const render::EyeMatrices& clip_from_label,
                  GLsizei eyes) const;
  void forget_who_left(std::span<const Avatar> avatars);

  Program program_;
  LabelFont font_;
  std::map<ViewerId, Label> labels_;
};

/// Label frame: x right and y up in the picture. Placed above the head, turned to the eye.
[[nodiscard]] RigidTransform world_from_label(const RigidTransform& world_from_view,
                                              const RigidTransform& world_from_head);

}  // namespace roomcast::viewer
