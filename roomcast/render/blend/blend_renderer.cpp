// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/blend_renderer.h"

#include <array>
#include <utility>

#include "roomcast/render/gl/shader_sources.h"
#include "roomcast/render/view/surface_view.h"

namespace roomcast::render {
namespace {

constexpr std::size_t kLevels = 10;  // a pixel of the coarsest covers 1024 pixels
// Levels whose coverage is used; one pixel there covers 16 and 64 pixels of the picture.
constexpr std::size_t kNarrow = 3, kWide = 5;
constexpr float kBackgroundWeight = 0.02F;

// Uniforms, as in shaders/blend/.
constexpr GLint kWeight = 6;      // of mix.vert
constexpr GLint kDepthFromZ = 0;  // of shrink_picture.comp
enum SurroundingsUniform : GLint { kCoverageSizes = 1, kUnseen = 2 };

void attach(const GlFramebuffer& framebuffer, GLenum attachment, const GlTexture& texture) {
  glNamedFramebufferTexture(framebuffer.name(), attachment, texture.name(), 0);
}

}  // namespace

Result<BlendRenderer> BlendRenderer::create() {
  auto nearest = make_layer_program(shaders::nearest_vert, shaders::nearest_frag);
  if (!nearest) return std::move(nearest).error();
  auto mix = make_layer_program(shaders::mix_vert, shaders::mix_frag);
  if (!mix) return std::move(mix).error();
  auto resolve = make_program({{GL_VERTEX_SHADER, {shaders::whole_picture_vert}},
                               {GL_FRAGMENT_SHADER, {shaders::resolve_frag}}});
  if (!resolve) return std::move(resolve).error();
  auto begin = ComputePass::create({shaders::shrink_picture_comp});
  if (!begin) return std::move(begin).error();
  auto shrink = ComputePass::create({shaders::shrink_comp});
  if (!shrink) return std::move(shrink).error();
  auto grow = ComputePass::create({shaders::grow_comp});
  if (!grow) return std::move(grow).error();
  auto surroundings = ComputePass::create({shaders::surroundings_comp});
  if (!surroundings) return std::move(surroundings).error();
  return BlendRenderer({*std::move(nearest), *std::move(mix), *std::move(resolve),
                        *std::move(begin), *std::move(shrink), *std::move(grow),
                        *std::move(surroundings)});
}

BlendRenderer::BlendRenderer(Programs programs)
    : programs_(std::move(programs)), no_vertices_(GlVertexArray::create()) {}

void BlendRenderer::make_room(const Eyes& eyes) {
  int width = eyes.width(), height = eyes.height();
  if (width == width_ && height == height_ && eyes.count() == eyes_) return;
  width_ = width;
  height_ = height;
  eyes_ = eyes.count();
  color_sum_ = make_texture(GL_RGBA16F, eyes_ * width, height);
  sum_target_ = GlFramebuffer::create();
  attach(sum_target_, GL_COLOR_ATTACHMENT0, color_sum_);
  picture_target_ = GlFramebuffer::create();
  levels_.clear();
  while (levels_.size() < kLevels) {
    width = (width + 1) / 2;
    height = (height + 1) / 2;
    levels_.push_back({make_smooth_layers(GL_RGBA16F, width, height, eyes_),
                       make_smooth_layers(GL_R16F, width, height, eyes_), width, height});
  }
}

void BlendRenderer::draw(std::span<const SurfaceLayer> layers, const Eyes& eyes, Unseen unseen,
                         const OffscreenTarget& target) {
  make_room(eyes);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  draw_nearest(layers, eyes, target);
  mix(layers, eyes, target.depth());
  glDisable(GL_CULL_FACE);
  find_surroundings(eyes, unseen, target.depth());
  resolve(target);
}

void BlendRenderer::draw_nearest(std::span<const SurfaceLayer> layers, const Eyes& eyes,
                                 const OffscreenTarget& target) {
  const EyeBorders borders(eyes);
  constexpr GLuint kPicture = 0;
  target.bind();
  glColorMaski(kPicture, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthFunc(GL_LESS);
  for (const SurfaceLayer& layer : layers) {
    painter_.draw(programs_.nearest, layer, eyes);
  }
  glColorMaski(kPicture, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

/// Sums the weighted colours of all surfaces within the mixing distance behind the nearest one.
void BlendRenderer::mix(std::span<const SurfaceLayer> layers, const Eyes& eyes,
                        const GlTexture& nearest_depth) {
  const EyeBorders borders(eyes);
  constexpr std::array<float, 4> kNothing{};
  attach(sum_target_, GL_DEPTH_ATTACHMENT, nearest_depth);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, sum_target_.name());
  glClearNamedFramebufferfv(sum_target_.name(), GL_COLOR, 0, kNothing.data());
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  for (const SurfaceLayer& layer : layers) {
    glProgramUniform1f(programs_.mix.name(), kWeight, layer.is_background ? kBackgroundWeight : 1);
    painter_.draw(programs_.mix, layer, eyes);
  }
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

void BlendRenderer::find_surroundings(const Eyes& eyes, Unseen unseen,
                                      const GlTexture& nearest_depth) {
  begin_surroundings(eyes, nearest_depth);
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    const Level& level = levels_[i];
    glBindTextureUnit(0, levels_[i - 1].color.name());
    glBindTextureUnit(1, levels_[i - 1].coverage.name());
    bind_image(0, level.color, ImageAccess::kWrite, GL_RGBA16F);
    bind_image(1, level.coverage, ImageAccess::kWrite, GL_R16F);
    programs_.shrink.run(level.width, level.height, eyes_);
  }
  for (std::size_t i = levels_.size() - 1; i > 1; --i) {
    const Level& finer = levels_[i - 1];
    glBindTextureUnit(0, levels_[i].color.name());
    bind_image(0, finer.color, ImageAccess::kBoth, GL_RGBA16F);
    programs_.grow.run(finer.width, finer.height, eyes_);
  }
  finish_surroundings(unseen);
}

void BlendRenderer::begin_surroundings(const Eyes& eyes, const GlTexture& nearest_depth) {
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  const Eigen::Matrix4f clip = clip_from_view(eyes[0]);  // the same for both eyes
  glProgramUniform2f(programs_.begin.program().name(), kDepthFromZ, -clip(2, 2), clip(2, 3));
  const Level& finest = levels_.front();
  glBindTextureUnit(0, color_sum_.name());
  glBindTextureUnit(1, nearest_depth.name());
  bind_image(0, finest.color, ImageAccess::kWrite, GL_RGBA16F);
  bind_image(1, finest.coverage, ImageAccess::kWrite, GL_R16F);
  programs_.begin.run(finest.width, finest.height, eyes_);
}

void BlendRenderer::finish_surroundings(Unseen unseen) {
  const Level &finest = levels_[0], &narrow = levels_[kNarrow], &wide = levels_[kWide];
  const auto px = [](int pixels, std::size_t level) { return static_cast<float>(pixels << level); };
  const GLuint program = programs_.surroundings.program().name();
  glProgramUniform4f(program, kCoverageSizes, px(narrow.width, kNarrow), px(narrow.height, kNarrow),
                     px(wide.width, kWide), px(wide.height, kWide));
  glProgramUniform1i(program, kUnseen, static_cast<GLint>(unseen));
  glBindTextureUnit(0, levels_[1].color.name());
  glBindTextureUnit(3, narrow.coverage.name());
  glBindTextureUnit(4, wide.coverage.name());
  bind_image(0, finest.color, ImageAccess::kBoth, GL_RGBA16F);
  programs_.surroundings.run(finest.width, finest.height, eyes_);
}

void BlendRenderer::resolve(const OffscreenTarget& target) {
  attach(picture_target_, GL_COLOR_ATTACHMENT0, target.color());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture_target_.name());
  glBindTextureUnit(0, color_sum_.name());
  glBindTextureUnit(1, target.depth().name());
  glBindTextureUnit(2, levels_.front().color.name());
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(programs_.resolve.name());
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
  target.bind();
}

}  // namespace roomcast::render
