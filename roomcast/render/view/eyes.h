// SPDX-License-Identifier: Apache-2.0
// Eyes: the one or two eyes of a picture; two are side by side in it, the first at the left. Each
// draw call serves all eyes: one instance per eye. The vertex shader (shaders/eyes.glsl) moves an
// instance to its eye's part of the picture, and two clip planes confine it there. In OpenGL 4.5
// core the alternative would be a geometry shader.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "roomcast/render/gl/shaders.h"
#include "roomcast/render/view/view_camera.h"

namespace roomcast::render {

inline constexpr int kMaxEyes = 2;

class Eyes {
 public:
  /// One eye. Implicit, so that code for one eye can pass a ViewCamera.
  Eyes(const ViewCamera& only) : cameras_{only, only} {}  // NOLINT(google-explicit-constructor)
  Eyes(const ViewCamera& left, const ViewCamera& right) : cameras_{left, right}, count_(2) {}

  /// Errors as ViewCamera::check; kInvalidArgument unless all eyes have the same size, near and
  /// far.
  [[nodiscard]] Status check() const;

  [[nodiscard]] int count() const { return count_; }
  /// Size of one eye's part of the picture, pixels.
  [[nodiscard]] int width() const { return cameras_[0].width; }
  [[nodiscard]] int height() const { return cameras_[0].height; }

  [[nodiscard]] const ViewCamera& operator[](std::size_t eye) const { return cameras_[eye]; }
  [[nodiscard]] auto begin() const { return cameras_.begin(); }
  [[nodiscard]] auto end() const { return cameras_.begin() + count_; }

 private:
  std::array<ViewCamera, kMaxEyes> cameras_;
  int count_ = 1;
};

/// One matrix for each eye.
using EyeMatrices = std::array<Eigen::Matrix4f, kMaxEyes>;

/// World -> clip.
[[nodiscard]] EyeMatrices clip_from_world(const Eyes& eyes);

/// Sets the number of eyes.
void set_eyes(ProgramWith<shaders::eyes_glsl> program, const Eyes& eyes);

/// Confines drawing for each eye to that eye's part of the picture for the lifetime of this object.
/// Only programs with shaders/eyes.glsl may draw meanwhile.
class EyeBorders {
 public:
  explicit EyeBorders(const Eyes& eyes);
  ~EyeBorders();
  EyeBorders(const EyeBorders&) = delete;
  EyeBorders& operator=(const EyeBorders&) = delete;

 private:
  bool are_there_;
};

}  // namespace roomcast::render
