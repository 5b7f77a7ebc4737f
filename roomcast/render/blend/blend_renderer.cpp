// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/blend_renderer.h"

#include <array>
#include <utility>

#include "roomcast/render/shader_sources.h"
#include "roomcast/render/surface_view.h"

namespace roomcast {
namespace {

constexpr std::size_t kLevels = 10;  // the coarsest covers 1024 pixels
// Of which coverage is asked; 16 and 64 pixels are one there.
constexpr std::size_t kNarrow = 4, kWide = 6;
constexpr float kBackgroundWeight = 0.02F;
// How much alike directions count: higher is sharper, lower hides seams.
constexpr float kExponent = 4;

// As in shaders/blend/.
enum MixUniform : GLint { kWeight = 4, kDirections = 5 };
constexpr GLint kFromPicture = 0;  // uniform of shrink.comp
enum ResolveUniform : GLint { kCoverageSizes = 1, kUnseen = 2 };
constexpr GLint kDepthFromZ = 6;

void use_outputs(const GlFramebuffer& framebuffer, std::initializer_list<const GlTexture*> colors) {
  std::vector<GLenum> outputs;
  for (const GlTexture* color : colors) {
    outputs.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(outputs.size()));
    glNamedFramebufferTexture(framebuffer.name(), outputs.back(), color->name(), 0);
  }
  glNamedFramebufferDrawBuffers(framebuffer.name(), static_cast<GLsizei>(outputs.size()),
                                outputs.data());
}

void set_depth_from_z(const GlProgram& program, const ViewCamera& camera) {
  const Eigen::Matrix4f clip = clip_from_view(camera);
  glProgramUniform2f(program.name(), kDepthFromZ, -clip(2, 2), clip(2, 3));
}

}  // namespace

Result<BlendRenderer> BlendRenderer::create() {
  auto nearest = make_program(
      {{GL_VERTEX_SHADER,
        {shaders::nearest_depth_glsl, shaders::blend_surface_glsl, shaders::nearest_vert}},
       {GL_FRAGMENT_SHADER, {shaders::blend_surface_glsl, shaders::nearest_frag}}});
  if (!nearest) return std::move(nearest).error();
  auto mix = make_program({{GL_VERTEX_SHADER, {shaders::blend_surface_glsl, shaders::mix_vert}},
                           {GL_FRAGMENT_SHADER, {shaders::blend_surface_glsl, shaders::mix_frag}}});
  if (!mix) return std::move(mix).error();
  auto resolve =
      make_program({{GL_VERTEX_SHADER, {shaders::whole_picture_vert}},
                    {GL_FRAGMENT_SHADER, {shaders::nearest_depth_glsl, shaders::resolve_frag}}});
  if (!resolve) return std::move(resolve).error();
  auto shrink = ComputePass::create({shaders::nearest_depth_glsl, shaders::shrink_comp});
  if (!shrink) return std::move(shrink).error();
  auto grow = ComputePass::create({shaders::grow_comp});
  if (!grow) return std::move(grow).error();
  return BlendRenderer({*std::move(nearest), *std::move(mix), *std::move(resolve),
                        *std::move(shrink), *std::move(grow)});
}

BlendRenderer::BlendRenderer(Programs programs)
    : programs_(std::move(programs)), no_vertices_(GlVertexArray::create()) {}

void BlendRenderer::make_room(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  nearest_depth_ = make_texture(GL_DEPTH_COMPONENT32F, width, height);
  nearest_sensor_ = make_texture(GL_R32I, width, height);
  color_sum_ = make_texture(GL_RGBA16F, width, height);
  nearest_target_ = GlFramebuffer::create();
  use_outputs(nearest_target_, {&nearest_sensor_});
  sum_target_ = GlFramebuffer::create();
  use_outputs(sum_target_, {&color_sum_});
  for (const GlFramebuffer* target : {&nearest_target_, &sum_target_}) {
    glNamedFramebufferTexture(target->name(), GL_DEPTH_ATTACHMENT, nearest_depth_.name(), 0);
  }
  levels_.clear();
  while (levels_.size() < kLevels) {
    width = (width + 1) / 2;
    height = (height + 1) / 2;
    levels_.push_back({make_smooth_texture(GL_RGBA16F, width, height),
                       make_smooth_texture(GL_R16F, width, height), width, height});
  }
}

void BlendRenderer::draw(std::span<const SurfaceLayer> layers, const ViewCamera& camera,
                         Unseen unseen, const OffscreenTarget& target) {
  make_room(camera.width, camera.height);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  draw_nearest(layers, camera);
  mix(layers, camera);
  glDisable(GL_CULL_FACE);
  find_surroundings(camera);
  resolve(camera, unseen, target);
}

void BlendRenderer::draw_nearest(std::span<const SurfaceLayer> layers, const ViewCamera& camera) {
  constexpr std::array<GLint, 4> kNobody = {kDrawnByNoSensor, 0, 0, 0};
  constexpr float kFarthest = 1;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, nearest_target_.name());
  glViewport(0, 0, width_, height_);
  glClearNamedFramebufferiv(nearest_target_.name(), GL_COLOR, 0, kNobody.data());
  glClearNamedFramebufferfv(nearest_target_.name(), GL_DEPTH, 0, &kFarthest);
  glDepthFunc(GL_LESS);
  for (const SurfaceLayer& layer : layers) {
    painter_.draw(programs_.nearest, layer, camera);
  }
}

/// Sums up whatever lies no farther than the nearest surface, which has been set back.
void BlendRenderer::mix(std::span<const SurfaceLayer> layers, const ViewCamera& camera) {
  constexpr std::array<float, 4> kNothing{};
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, sum_target_.name());
  glClearNamedFramebufferfv(sum_target_.name(), GL_COLOR, 0, kNothing.data());
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glProgramUniform1f(programs_.mix.name(), kDirections, kExponent);
  for (const SurfaceLayer& layer : layers) {
    glProgramUniform1f(programs_.mix.name(), kWeight, layer.is_background ? kBackgroundWeight : 1);
    painter_.draw(programs_.mix, layer, camera);
  }
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

void BlendRenderer::find_surroundings(const ViewCamera& camera) {
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  set_depth_from_z(programs_.shrink.program(), camera);
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    const Level& level = levels_[i];
    glProgramUniform1i(programs_.shrink.program().name(), kFromPicture, i == 0);
    glBindTextureUnit(0, i == 0 ? color_sum_.name() : levels_[i - 1].color.name());
    glBindTextureUnit(1, nearest_depth_.name());
    glBindTextureUnit(2, i == 0 ? nearest_depth_.name() : levels_[i - 1].coverage.name());
    bind_image(0, level.color, ImageAccess::kWrite, GL_RGBA16F);
    bind_image(1, level.coverage, ImageAccess::kWrite, GL_R16F);
    programs_.shrink.run(level.width, level.height);
  }
  for (std::size_t i = levels_.size() - 1; i > 0; --i) {
    const Level& finer = levels_[i - 1];
    glBindTextureUnit(0, levels_[i].color.name());
    bind_image(0, finer.color, ImageAccess::kBoth, GL_RGBA16F);
    programs_.grow.run(finer.width, finer.height);
  }
}

void BlendRenderer::resolve(const ViewCamera& camera, Unseen unseen,
                            const OffscreenTarget& target) {
  target.bind();
  set_depth_from_z(programs_.resolve, camera);
  glBindTextureUnit(0, color_sum_.name());
  glBindTextureUnit(1, nearest_depth_.name());
  const Level &narrow = levels_[kNarrow - 1], &wide = levels_[kWide - 1];
  glBindTextureUnit(2, levels_.front().color.name());
  glBindTextureUnit(3, nearest_sensor_.name());
  glBindTextureUnit(4, narrow.coverage.name());
  glBindTextureUnit(5, wide.coverage.name());
  const auto px = [](int pixels, std::size_t level) { return static_cast<float>(pixels << level); };
  glProgramUniform4f(programs_.resolve.name(), kCoverageSizes, px(narrow.width, kNarrow),
                     px(narrow.height, kNarrow), px(wide.width, kWide), px(wide.height, kWide));
  glProgramUniform1i(programs_.resolve.name(), kUnseen, static_cast<GLint>(unseen));
  if (unseen == Unseen::kHolesFilled) glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthFunc(GL_ALWAYS);
  glUseProgram(programs_.resolve.name());
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
}

}  // namespace roomcast
