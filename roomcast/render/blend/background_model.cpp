// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/background_model.h"

#include <utility>

#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {
namespace {

void clear(const GlTexture& texture) {
  glClearTexImage(texture.name(), 0, GL_RGBA, GL_FLOAT, nullptr);
}

}  // namespace

BackgroundModel::BackgroundModel(const CameraIntrinsics& lens)
    : newest_m_(make_texture(GL_R32F, lens.width, lens.height)),
      steadiness_(make_texture(GL_R16F, lens.width, lens.height)),
      classes_(make_texture(GL_R8UI, lens.width, lens.height)),
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
  auto parts = create_parts(&Parts::update, &Parts::background, &Parts::carve, &Parts::completion,
                            &Parts::cleaner, &Parts::flow);
  if (!parts) return std::move(parts).error();
  return BackgroundUpdater(*std::move(parts));
}

void BackgroundUpdater::update(const SensorSurface& sensor, BackgroundModel& model) const {
  using shaders::update_background_comp;
  model.set_color_scale(sensor.color_scale());
  sensor.bind_to(parts_.update);
  parts_.update.bind(update_background_comp::background, model.readings_);
  parts_.update.bind(update_background_comp::background_color, model.background_color_);
  parts_.update.bind(update_background_comp::depth_out, model.newest_m_);
  parts_.update.bind(update_background_comp::steadiness, model.steadiness_);
  parts_.update.run(sensor.intrinsics().width, sensor.intrinsics().height);
}

void BackgroundUpdater::refresh(const SensorSurface& sensor, std::span<const OtherSensor> others,
                                const Options& options, BackgroundModel& model) {
  using shaders::background_depth_comp;
  model.set_color_scale(sensor.color_scale());
  sensor.bind_to(parts_.background);
  parts_.background.bind(background_depth_comp::background, model.readings_);
  parts_.background.bind(background_depth_comp::depth_out, model.background_.depth_m);
  parts_.background.run(sensor.intrinsics().width, sensor.intrinsics().height);
  parts_.completion.complete(
      sensor, {model.newest_m_, model.readings_, model.background_color_, model.steadiness_},
      {model.classes_, model.live_.depth_m, model.seen_});
  using Shows = SurfaceCleaner::Shows;
  parts_.cleaner.repair(Shows::kNewest, model.live_);
  for (const OtherSensor& other : others) {
    carve(sensor, other, model.background_.depth_m);
    if (options.is_late && !other.is_late) carve(sensor, other, model.live_.depth_m);
  }
  parts_.cleaner.repair(Shows::kBackground, model.background_);

  const SurfaceCleaner::Known known{model.readings_, model.background_color_, model.seen_};
  parts_.cleaner.finish(sensor, known, Shows::kNewest, {options.mesh, options.gain}, model.live_);
  const SurfaceCleaner::Options behind{options.mesh, options.gain, &model.live_};
  parts_.cleaner.finish(sensor, known, Shows::kBackground, behind, model.background_);
  options.flow.interpolate(parts_.flow, model.live_.depth_m);
  parts_.cleaner.find_foreground(model.background_, options.mesh, options.flow.velocities(),
                                 model.live_);
}

void BackgroundUpdater::carve(const SensorSurface& sensor, const OtherSensor& other,
                              const GlTexture& depth) const {
  using shaders::carve_comp;
  const auto& program = parts_.carve;
  const CameraIntrinsics& lens = other.surface->intrinsics();
  const auto real = [](double value) { return static_cast<float>(value); };
  program.set(carve_comp::other_from_depth, matrix_from_transform(other.other_from_depth));
  program.set(carve_comp::other_focal_center,
              {real(lens.fx), real(lens.fy), real(lens.cx), real(lens.cy)});
  program.set(carve_comp::other_radial, {real(lens.k1), real(lens.k2), real(lens.k3)});
  program.set(carve_comp::other_tangential, {real(lens.p1), real(lens.p2)});
  program.set(carve_comp::other_widest_squared, real(other.surface->widest_radius_squared()));
  program.bind(carve_comp::rays, sensor.rays());
  program.bind(carve_comp::other_depth_mm, other.surface->depth_mm());
  program.bind(carve_comp::depth, depth);
  program.run(sensor.intrinsics().width, sensor.intrinsics().height);
}

}  // namespace roomcast::render
