// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/people/label_renderer.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include "roomcast/render/view/surface_view.h"
#include "roomcast/viewer/people/drawing_over.h"

namespace roomcast::viewer {
namespace {

constexpr GLsizei kPlateCorners = 6;

constexpr float kLetterHeight_m = 0.058F;
constexpr float kPlateHeight_m = 0.09F;
constexpr float kPlateMargin_m = 0.03F;
constexpr double kAboveHead_m = 0.27;

std::vector<LabelCorner> plate_of(float width_m) {
  const float x_m = width_m / 2 + kPlateMargin_m, y_m = kPlateHeight_m / 2;
  std::vector<LabelCorner> corners;
  for (const auto& [x, y] :
       {std::pair{-1.F, 1.F}, {-1.F, -1.F}, {1.F, 1.F}, {1.F, 1.F}, {-1.F, -1.F}, {1.F, -1.F}}) {
    corners.push_back({{x * x_m, y * y_m}, {x, y}});
  }
  return corners;
}

render::GlVertexArray vertices_in(const render::GlBuffer& buffer) {
  render::GlVertexArray vertices = render::GlVertexArray::create();
  const GLuint name = vertices.name();
  glVertexArrayVertexBuffer(name, 0, buffer.name(), 0, sizeof(LabelCorner));
  const auto add = [name](render::glsl::VertexInput<shaders::label_vert, Eigen::Vector2f> input,
                          std::size_t offset) {
    glEnableVertexArrayAttrib(name, input.location);
    glVertexArrayAttribFormat(name, input.location, 2, GL_FLOAT, GL_FALSE,
                              static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(name, input.location, 0);
  };
  add(shaders::label_vert::place, offsetof(LabelCorner, place_m));
  add(shaders::label_vert::in_atlas, offsetof(LabelCorner, in_atlas));
  return vertices;
}

}  // namespace

RigidTransform world_from_label(const RigidTransform& world_from_view,
                                const RigidTransform& world_from_head) {
  const Eigen::Vector3d place_m =
      world_from_head.translation_m + kAboveHead_m * Eigen::Vector3d::UnitY();
  Eigen::Vector3d towards_eye = world_from_view.translation_m - place_m;
  towards_eye.y() = 0;
  if (towards_eye.norm() < 1e-3) towards_eye = Eigen::Vector3d::UnitZ();
  RigidTransform label{Eigen::Matrix3d::Identity(), place_m};
  label.rotation.col(2) = towards_eye.normalized();
  label.rotation.col(0) = Eigen::Vector3d::UnitY().cross(label.rotation.col(2)).normalized();
  label.rotation.col(1) = label.rotation.col(2).cross(label.rotation.col(0));
  return label;
}

Result<LabelRenderer> LabelRenderer::create() {
  Result<Program> program = Program::create();
  if (!program) return std::move(program).error();
  return LabelRenderer(*std::move(program));
}

void LabelRenderer::draw(const render::Eyes& eyes, std::span<const Avatar> avatars) {
  forget_who_left(avatars);
  const DrawingOver room(DrawingOver::kTransparent);
  const render::EyeMatrices clip_from_room = render::clip_from_world(eyes);
  program_.use();
  render::set_eyes(program_, eyes);
  program_.bind(shaders::label_frag::letters, font_.texture());
  for (const Avatar& avatar : avatars) {
    render::EyeMatrices clip_from_label = clip_from_room;
    for (std::size_t eye = 0; eye < clip_from_label.size(); ++eye) {
      clip_from_label[eye] *= render::matrix_from_transform(
          world_from_label(eyes[eye].world_from_view, avatar.shown.world_from_head));
    }
    draw_label(label_of(avatar), clip_from_label, eyes.count());
  }
}

void LabelRenderer::forget_who_left(std::span<const Avatar> avatars) {
  std::erase_if(labels_, [&](const auto& label) {
    return std::ranges::find(avatars, label.first, &Avatar::id) == avatars.end();
  });
}

const LabelRenderer::Label& LabelRenderer::label_of(const Avatar& avatar) {
  Label& label = labels_[avatar.id];
  if (label.text != avatar.name) label = make_label(avatar.name);
  return label;
}

LabelRenderer::Label LabelRenderer::make_label(const std::string& text) const {
  const LabelText letters = font_.lay_out(text, kLetterHeight_m);
  std::vector<LabelCorner> corners = plate_of(letters.width_m);
  corners.insert(corners.end(), letters.corners.begin(), letters.corners.end());
  Label label;
  label.text = text;
  label.width_m = letters.width_m;
  label.letter_corners = static_cast<GLsizei>(letters.corners.size());
  label.corners = render::GlBuffer::create();
  glNamedBufferStorage(label.corners.name(),
                       static_cast<GLsizeiptr>(corners.size() * sizeof(LabelCorner)),
                       corners.data(), 0);
  label.vertices = vertices_in(label.corners);
  return label;
}

void LabelRenderer::draw_label(const Label& label, const render::EyeMatrices& clip_from_label,
                               GLsizei eyes) const {
  using shaders::label_frag;
  program_.set(shaders::label_vert::clip_from_label, clip_from_label);
  glBindVertexArray(label.vertices.name());
  program_.set(label_frag::plate_m, {label.width_m / 2 + kPlateMargin_m, kPlateHeight_m / 2});
  program_.set(label_frag::color, {0.05F, 0.067F, 0.09F, 0.72F});
  glDrawArraysInstanced(GL_TRIANGLES, 0, kPlateCorners, eyes);
  program_.set(label_frag::plate_m, {0, 0});
  program_.set(label_frag::color, {0.95F, 0.96F, 0.97F, 1});
  glDrawArraysInstanced(GL_TRIANGLES, kPlateCorners, label.letter_corners, eyes);
}

}  // namespace roomcast::viewer
