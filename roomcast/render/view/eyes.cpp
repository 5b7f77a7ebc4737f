// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/view/eyes.h"

#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {
namespace {

constexpr std::array<GLenum, 2> kPlanes = {GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE1};

bool fit_together(const ViewCamera& a, const ViewCamera& b) {
  return a.width == b.width && a.height == b.height && a.near_m == b.near_m && a.far_m == b.far_m;
}

}  // namespace

Status Eyes::check() const {
  for (const ViewCamera& camera : *this) {
    if (Status legal = camera.check(); !legal) return legal;
    if (!fit_together(camera, cameras_[0])) {
      return Error{
          ErrorCode::kInvalidArgument,
          "two eyes of one picture need the same size and the same near and far distances"};
    }
  }
  return {};
}

EyeMatrices clip_from_world(const Eyes& eyes) {
  EyeMatrices matrices;
  for (std::size_t eye = 0; eye < matrices.size(); ++eye) {
    matrices[eye] =
        clip_from_view(eyes[eye]) * matrix_from_transform(eyes[eye].world_from_view.inverse());
  }
  return matrices;
}

void set_eyes(ProgramWith<shaders::eyes_glsl> program, const Eyes& eyes) {
  program.set(shaders::eyes_glsl::eyes, eyes.count());
}

EyeBorders::EyeBorders(const Eyes& eyes) : are_there_(eyes.count() > 1) {
  if (!are_there_) return;
  for (const GLenum plane : kPlanes) glEnable(plane);
}

EyeBorders::~EyeBorders() {
  if (!are_there_) return;
  for (const GLenum plane : kPlanes) glDisable(plane);
}

}  // namespace roomcast::render
