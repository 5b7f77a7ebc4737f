// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/background_model.h"

#include <utility>

#include "roomcast/render/gl/shader_sources.h"
#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {
namespace {

// As in shaders/blend/.
enum ImageUnit : GLuint { kReadings = 0, kColor = 1, kDepthOut = 2, kSteadiness = 3 };
enum CarveTexture : GLuint { kRays = 1, kOtherDepth = 4 };
enum CarveUniform : GLint {
  kOtherFromDepth = 0,
  kFocalCenter = 1,
  kRadial = 2,
  kTangential = 3,
  kWidest = 4,
};

void clear(const GlTexture& texture) {
  glClearTexImage(texture.name(), 0, GL_RGBA, GL_FLOAT, nullptr);
}

}  // namespace

BackgroundModel::BackgroundModel(const CameraIntrinsics& lens)
    : newest_m_(make_texture(GL_R32F, lens.width, lens.height)),
      steadiness_(make_texture(GL_R16F, lens.width, lens.height)),
      verdict_(make_texture(GL_R8UI, lens.width, lens.height)),
      seen_(make_texture(GL_R8UI, lens.width, lens.height)),
      readings_(make_texture(GL_RGBA32F, lens.width, lens.height)),
      live_(lens),
      background_(lens) {
  clear(newest_m_);
  clear(steadiness_);
  clear(readings_);
  set_color_scale(1);
}

void BackgroundModel::set_color_scale(int scale) {
  if (scale == color_scale_) return;
  color_scale_ = scale;
  background_color_ = make_texture(GL_RGBA16F, scale * live_.width, scale * live_.height);
  clear(background_color_);
  live_.set_color_scale(scale);
  background_.set_color_scale(scale);
}

Result<BackgroundUpdater> BackgroundUpdater::create() {
  auto remember = ComputePass::create(
      {shaders::sensor_surface_glsl, shaders::depth_noise_glsl, shaders::remember_background_comp});
  if (!remember) return std::move(remember).error();
  auto background =
      ComputePass::create({shaders::sensor_surface_glsl, shaders::background_depth_comp});
  if (!background) return std::move(background).error();
  auto carve = ComputePass::create({shaders::carve_comp});
  if (!carve) return std::move(carve).error();
  auto lost = LostDepth::create();
  if (!lost) return std::move(lost).error();
  auto cleaner = SurfaceCleaner::create();
  if (!cleaner) return std::move(cleaner).error();
  return BackgroundUpdater(*std::move(remember), *std::move(background), *std::move(carve),
                           *std::move(lost), *std::move(cleaner));
}

BackgroundUpdater::BackgroundUpdater(ComputePass remember, ComputePass background,
                                     ComputePass carve, LostDepth lost, SurfaceCleaner cleaner)
    : remember_(std::move(remember)),
      background_(std::move(background)),
      carve_(std::move(carve)),
      lost_(std::move(lost)),
      cleaner_(std::move(cleaner)) {}

void BackgroundUpdater::remember(const SensorSurface& sensor, BackgroundModel& memory) const {
  memory.set_color_scale(sensor.color_scale());
  sensor.bind();
  bind_image(kReadings, memory.readings_, ImageAccess::kBoth, GL_RGBA32F);
  bind_image(kColor, memory.background_color_, ImageAccess::kBoth, GL_RGBA16F);
  bind_image(kDepthOut, memory.newest_m_, ImageAccess::kBoth, GL_R32F);
  bind_image(kSteadiness, memory.steadiness_, ImageAccess::kBoth, GL_R16F);
  remember_.run(sensor.intrinsics().width, sensor.intrinsics().height);
}

void BackgroundUpdater::refresh(const SensorSurface& sensor, std::span<const OtherSensor> others,
                                const SurfaceCleaner::Options& options, BackgroundModel& memory) {
  memory.set_color_scale(sensor.color_scale());
  sensor.bind();
  bind_image(kReadings, memory.readings_, ImageAccess::kRead, GL_RGBA32F);
  bind_image(kDepthOut, memory.background_.depth_m, ImageAccess::kWrite, GL_R32F);
  background_.run(sensor.intrinsics().width, sensor.intrinsics().height);
  lost_.cover(sensor,
              {memory.newest_m_, memory.readings_, memory.background_color_, memory.steadiness_},
              {memory.verdict_, memory.live_.depth_m, memory.seen_});
  using Shows = SurfaceCleaner::Shows;
  cleaner_.repair(Shows::kNewest, memory.live_);
  for (const OtherSensor& other : others) carve(sensor, other, memory.background_.depth_m);
  cleaner_.repair(Shows::kBackground, memory.background_);

  const SurfaceCleaner::Known known{memory.readings_, memory.background_color_, memory.seen_};
  cleaner_.finish(sensor, known, Shows::kNewest, options, memory.live_);
  SurfaceCleaner::Options behind = options;
  behind.covering = &memory.live_;
  cleaner_.finish(sensor, known, Shows::kBackground, behind, memory.background_);
}

void BackgroundUpdater::carve(const SensorSurface& sensor, const OtherSensor& other,
                              const GlTexture& depth) const {
  const CameraIntrinsics& lens = other.surface->intrinsics();
  const Eigen::Matrix4f other_from_depth = matrix_from_transform(other.other_from_depth);
  const GLuint program = carve_.program().name();
  const auto real = [](double value) { return static_cast<float>(value); };
  glProgramUniformMatrix4fv(program, kOtherFromDepth, 1, GL_FALSE, other_from_depth.data());
  glProgramUniform4f(program, kFocalCenter, real(lens.fx), real(lens.fy), real(lens.cx),
                     real(lens.cy));
  glProgramUniform3f(program, kRadial, real(lens.k1), real(lens.k2), real(lens.k3));
  glProgramUniform2f(program, kTangential, real(lens.p1), real(lens.p2));
  glProgramUniform1f(program, kWidest, real(widest_radius_squared(lens)));
  glBindTextureUnit(kRays, sensor.rays().name());
  glBindTextureUnit(kOtherDepth, other.surface->depth_mm().name());
  bind_image(0, depth, ImageAccess::kBoth, GL_R32F);
  carve_.run(sensor.intrinsics().width, sensor.intrinsics().height);
}

}  // namespace roomcast::render
