// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/people/body_renderer.h"

#include <utility>

#include "roomcast/geometry/rotations.h"
#include "roomcast/render/view/surface_view.h"
#include "roomcast/viewer/people/drawing_over.h"

namespace roomcast::viewer {
namespace {

constexpr GLsizei kSectors = 32, kRings = 16;

const Eigen::Vector3d kSkull_m(0.101, 0.129, 0.115);
const Eigen::Vector3d kVisor_m(0.086, 0.042, 0.07);
const Eigen::Vector3d kVisorPlace_m(0, 0.02, -0.062);
constexpr Rgb8 kVisorColor = {0x11, 0x15, 0x1a};
constexpr double kHandRadius_m = 0.045;
constexpr double kBeamRadius_m = 0.003;
constexpr double kSpotRadius_m = 0.014;
constexpr float kLit = 0, kShines = 0.85F;

RigidTransform at(const Eigen::Vector3d& place_m) {
  return {Eigen::Matrix3d::Identity(), place_m};
}

}  // namespace

Result<BodyRenderer> BodyRenderer::create() {
  Result<Program> program = Program::create();
  if (!program) return std::move(program).error();
  return BodyRenderer(*std::move(program));
}

BodyRenderer::BodyRenderer(Program program)
    : program_(std::move(program)), no_attributes_(render::GlVertexArray::create()) {}

void BodyRenderer::draw(const render::Eyes& eyes, std::span<const Avatar> avatars) {
  const DrawingOver room(DrawingOver::kSolid);
  begin(eyes);
  for (const Avatar& avatar : avatars) {
    draw_head(avatar.shown.world_from_head, avatar.color);
    draw_hands_and_beam(avatar.shown, avatar.color);
  }
}

void BodyRenderer::draw_own(const render::Eyes& eyes, const client::PersonPose& self, Rgb8 color) {
  const DrawingOver room(DrawingOver::kSolid);
  begin(eyes);
  draw_hands_and_beam(self, color);
}

void BodyRenderer::begin(const render::Eyes& eyes) {
  eyes_ = eyes.count();
  render::set_eyes(program_, eyes);
  program_.set(shaders::body_vert::clip_from_world, render::clip_from_world(eyes));
  program_.use();
  glBindVertexArray(no_attributes_.name());
}

void BodyRenderer::draw_head(const RigidTransform& world_from_head, Rgb8 color) const {
  draw_ball(world_from_head, kSkull_m, color, kLit);
  draw_ball(world_from_head * at(kVisorPlace_m), kVisor_m, kVisorColor, kLit);
}

void BodyRenderer::draw_hands_and_beam(const client::PersonPose& pose, Rgb8 color) const {
  const Eigen::Vector3d hand_m = Eigen::Vector3d::Constant(kHandRadius_m);
  if (pose.world_from_left_hand) draw_ball(*pose.world_from_left_hand, hand_m, color, kLit);
  if (pose.world_from_right_hand) draw_ball(*pose.world_from_right_hand, hand_m, color, kLit);
  if (pose.pointer) draw_beam(*pose.pointer, color);
}

/// A ball stretched between the beam's ends.
void BodyRenderer::draw_beam(const client::PointerBeam& beam, Rgb8 color) const {
  const Eigen::Vector3d along_m = beam.to_m - beam.from_m;
  RigidTransform world_from_beam = at((beam.from_m + beam.to_m) / 2);
  world_from_beam.rotation = rotation_between(Eigen::Vector3d::UnitZ(), along_m);
  draw_ball(world_from_beam, {kBeamRadius_m, kBeamRadius_m, along_m.norm() / 2}, color, kShines);
  draw_ball(at(beam.to_m), Eigen::Vector3d::Constant(kSpotRadius_m), color, kShines);
}

void BodyRenderer::draw_ball(const RigidTransform& world_from_ball, const Eigen::Vector3d& radii_m,
                             Rgb8 color, float own_light) const {
  const Eigen::Vector3f radii = radii_m.cast<float>().cwiseMax(1e-6F);
  Eigen::Matrix4f matrix = render::matrix_from_transform(world_from_ball);
  const Eigen::Matrix3f normals =
      matrix.topLeftCorner<3, 3>() * radii.cwiseInverse().asDiagonal().toDenseMatrix();
  matrix.topLeftCorner<3, 3>() *= radii.asDiagonal().toDenseMatrix();
  program_.set(shaders::body_vert::world_from_ball, matrix);
  program_.set(shaders::body_vert::world_from_normal, normals);
  program_.set(shaders::body_frag::color,
               {static_cast<float>(color.r) / 255, static_cast<float>(color.g) / 255,
                static_cast<float>(color.b) / 255});
  program_.set(shaders::body_frag::own_light, own_light);
  glDrawArraysInstanced(GL_TRIANGLES, 0, 6 * kSectors * kRings, eyes_);
}

}  // namespace roomcast::viewer
