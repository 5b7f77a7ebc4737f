// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/lost_depth.h"

#include <bit>
#include <utility>

#include "roomcast/render/gl/shader_sources.h"

namespace roomcast::render {
namespace {

// As in shaders/blend/judge_lost.comp and cover_lost.comp.
enum TextureUnit : GLuint {
  kNewest = 0,
  kColor = 2,
  kSeen = 3,
  kVerdict = 4,
  kBackgroundColor = 5,
  kReadings = 6,
  kSteadiness = 7,
};
constexpr GLint kColorShift = 0;

}  // namespace

Result<LostDepth> LostDepth::create() {
  auto judge = ComputePass::create({shaders::judge_lost_comp});
  if (!judge) return std::move(judge).error();
  auto cover = ComputePass::create({shaders::cover_lost_comp});
  if (!cover) return std::move(cover).error();
  return LostDepth(*std::move(judge), *std::move(cover));
}

void LostDepth::cover(const SensorSurface& sensor, const Known& known, const Out& out) const {
  const int width = sensor.intrinsics().width, height = sensor.intrinsics().height;
  glBindTextureUnit(kNewest, known.newest_m.name());
  glBindTextureUnit(kColor, sensor.color().name());
  glBindTextureUnit(kBackgroundColor, known.color.name());
  glBindTextureUnit(kReadings, known.readings.name());
  glBindTextureUnit(kSteadiness, known.steadiness.name());
  glProgramUniform1i(judge_.program().name(), kColorShift,
                     std::countr_zero(static_cast<unsigned>(sensor.color_scale())));
  bind_image(0, out.verdict, ImageAccess::kWrite, GL_R8UI);
  judge_.run(width, height);

  glBindTextureUnit(kSeen, sensor.seen().name());
  glBindTextureUnit(kVerdict, out.verdict.name());
  bind_image(0, out.depth_m, ImageAccess::kWrite, GL_R32F);
  bind_image(1, out.seen, ImageAccess::kWrite, GL_R8UI);
  cover_.run(width, height);
}

}  // namespace roomcast::render
