// SPDX-License-Identifier: Apache-2.0
// Whom a picture is drawn for: one eye, or two in one picture side by side, the first at the left.
// Whatever is drawn is drawn once for all of them: each instance of it is for one eye, its vertex
// shader (shaders/eyes.glsl) puts it into that eye's part of the picture, and two clip planes keep
// it there. OpenGL 4.5 core has no other way to draw for two eyes at once without a geometry
// shader.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "roomcast/render/gl/gl_program.h"
#include "roomcast/render/view/view_camera.h"

namespace roomcast::render {

inline constexpr int kMaxEyes = 2;

class Eyes {
 public:
  /// One; so that whoever draws for one need not know of more.
  Eyes(const ViewCamera& only) : cameras_{only, only} {}  // NOLINT(google-explicit-constructor)
  Eyes(const ViewCamera& left, const ViewCamera& right) : cameras_{left, right}, count_(2) {}

  /// As ViewCamera::check; kInvalidArgument unless all have one size and the same near and far.
  [[nodiscard]] Status check() const;

  [[nodiscard]] int count() const { return count_; }
  /// Of one eye's part of the picture, pixels.
  [[nodiscard]] int width() const { return cameras_[0].width; }
  [[nodiscard]] int height() const { return cameras_[0].height; }

  [[nodiscard]] const ViewCamera& operator[](std::size_t eye) const { return cameras_[eye]; }
  [[nodiscard]] auto begin() const { return cameras_.begin(); }
  [[nodiscard]] auto end() const { return cameras_.begin() + count_; }

 private:
  std::array<ViewCamera, kMaxEyes> cameras_;
  int count_ = 1;
};

/// For each eye.
using EyeMatrices = std::array<Eigen::Matrix4f, kMaxEyes>;

/// World -> clip.
[[nodiscard]] EyeMatrices clip_from_world(const Eyes& eyes);

/// Tells shaders/eyes.glsl, in this program, how many there are.
void set_eyes(const GlProgram& program, const Eyes& eyes);
/// Fills a `uniform mat4[2]`.
void set_matrices(const GlProgram& program, GLint location, const EyeMatrices& matrices);

/// While it lives, what is drawn for an eye stays in that eye's part. Only programs with
/// shaders/eyes.glsl may draw meanwhile.
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
