// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/blend_renderer.h"

#include <array>
#include <utility>

#include "roomcast/render/gl/gl_state.h"

namespace roomcast::render {
namespace {

constexpr std::size_t kLevels = 10;  // a pixel of the coarsest covers 1024 pixels
// Levels whose coverage is used; one pixel there covers 16 and 64 pixels of the picture.
constexpr std::size_t kNarrow = 3, kWide = 5;
constexpr float kBackgroundWeight = 0.02F;

void attach(const GlFramebuffer& framebuffer, GLenum attachment, const GlTexture& texture) {
  glNamedFramebufferTexture(framebuffer.name(), attachment, texture.name(), 0);
}

}  // namespace

Result<BlendRenderer> BlendRenderer::create() {
  auto programs =
      create_parts(&Programs::nearest, &Programs::mix, &Programs::begin, &Programs::shrink,
                   &Programs::grow, &Programs::surroundings, &Programs::resolve);
  if (!programs) return std::move(programs).error();
  return BlendRenderer(*std::move(programs));
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
  shown_depth_ = make_texture(GL_DEPTH_COMPONENT32F, eyes_ * width, height);
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

void BlendRenderer::draw(std::span<const SurfaceLayer> layers, StillModel& model, const Eyes& eyes,
                         Unseen unseen, const OffscreenTarget& target) {
  make_room(eyes);
  glEnable(GL_DEPTH_TEST);
  draw_nearest(layers, eyes, target);
  mix(layers, eyes, target.depth());
  if (!model.is_empty()) fill(layers, model, eyes, target.depth());
  find_surroundings(eyes, unseen, target.depth());
  resolve(target);
}

void BlendRenderer::draw_nearest(std::span<const SurfaceLayer> layers, const Eyes& eyes,
                                 const OffscreenTarget& target) {
  const EyeBorders borders(eyes);
  const AttachmentKept color(OffscreenTarget::kColorAttachment);
  target.bind();
  glDepthFunc(GL_LESS);
  for (const SurfaceLayer& layer : layers) {
    painter_.draw(programs_.nearest, layer, eyes);
  }
}

/// Sums the weighted colours of all surfaces within the mixing distance behind the nearest one.
void BlendRenderer::mix(std::span<const SurfaceLayer> layers, const Eyes& eyes,
                        const GlTexture& nearest_depth) {
  const EyeBorders borders(eyes);
  const Blending sum(GL_ONE, GL_ONE);
  constexpr std::array<float, 4> kNothing{};
  attach(sum_target_, GL_DEPTH_ATTACHMENT, nearest_depth);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, sum_target_.name());
  glClearNamedFramebufferfv(sum_target_.name(), GL_COLOR, 0, kNothing.data());
  const DepthKept nearest;
  for (const SurfaceLayer& layer : layers) {
    const bool is_background = layer.part == SurfaceLayer::Part::kBackground;
    programs_.mix.set(shaders::mix_vert::weight, is_background ? kBackgroundWeight : 1);
    painter_.draw(programs_.mix, layer, eyes);
  }
}

/// Into the sums, which the layers have left at 0 there, and into the depth.
void BlendRenderer::fill(std::span<const SurfaceLayer> layers, StillModel& model, const Eyes& eyes,
                         const GlTexture& nearest_depth) {
  glCopyImageSubData(nearest_depth.name(), GL_TEXTURE_2D, 0, 0, 0, 0, shown_depth_.name(),
                     GL_TEXTURE_2D, 0, 0, 0, 0, eyes_ * width_, height_, 1);
  glDepthFunc(GL_LESS);
  const bool may_pick = model.wants_holes() && !layers.empty();  // without layers all is one hole
  if (may_pick) find_holes(nearest_depth);
  model.draw(eyes, shown_depth_, may_pick ? &holes_ : nullptr);
}

void BlendRenderer::find_holes(const GlTexture& nearest_depth) {
  const int width = eyes_ * width_;
  read_depth_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height_));
  glGetTextureImage(nearest_depth.name(), 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                    static_cast<GLsizei>(read_depth_.size() * sizeof(float)), read_depth_.data());
  holes_.find(read_depth_, width);
}

void BlendRenderer::find_surroundings(const Eyes& eyes, Unseen unseen,
                                      const GlTexture& nearest_depth) {
  begin_surroundings(eyes, nearest_depth);
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    using shaders::shrink_comp;
    const Level &finer = levels_[i - 1], &coarser = levels_[i];
    programs_.shrink.bind(shrink_comp::finer_color, finer.color);
    programs_.shrink.bind(shrink_comp::finer_coverage, finer.coverage);
    programs_.shrink.bind(shrink_comp::coarser, coarser.color);
    programs_.shrink.bind(shrink_comp::coarser_coverage, coarser.coverage);
    programs_.shrink.run(coarser.width, coarser.height, eyes_);
  }
  for (std::size_t i = levels_.size() - 1; i > 1; --i) {
    const Level &finer = levels_[i - 1], &coarser = levels_[i];
    programs_.grow.bind(shaders::grow_comp::coarser, coarser.color);
    programs_.grow.bind(shaders::grow_comp::level, finer.color);
    programs_.grow.run(finer.width, finer.height, eyes_);
  }
  finish_surroundings(unseen);
}

void BlendRenderer::begin_surroundings(const Eyes& eyes, const GlTexture& nearest_depth) {
  using shaders::shrink_picture_comp;
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  const Eigen::Matrix4f clip = clip_from_view(eyes[0]);  // the same for both eyes
  const Level& finest = levels_.front();
  programs_.begin.set(shrink_picture_comp::depth_from_z, {-clip(2, 2), clip(2, 3)});
  programs_.begin.bind(shrink_picture_comp::color_sum, color_sum_);
  programs_.begin.bind(shrink_picture_comp::nearest_depth, nearest_depth);
  programs_.begin.bind(shrink_picture_comp::coarser, finest.color);
  programs_.begin.bind(shrink_picture_comp::coarser_coverage, finest.coverage);
  programs_.begin.run(finest.width, finest.height, eyes_);
}

void BlendRenderer::finish_surroundings(Unseen unseen) {
  using shaders::surroundings_comp;
  const auto& program = programs_.surroundings;
  const Level &finest = levels_[0], &narrow = levels_[kNarrow], &wide = levels_[kWide];
  const auto px = [](int pixels, std::size_t level) { return static_cast<float>(pixels << level); };
  program.set(surroundings_comp::coverage_sizes,
              {px(narrow.width, kNarrow), px(narrow.height, kNarrow), px(wide.width, kWide),
               px(wide.height, kWide)});
  program.set(surroundings_comp::unseen, static_cast<GLint>(unseen));
  program.bind(surroundings_comp::coarser, levels_[1].color);
  program.bind(surroundings_comp::narrow_coverage, narrow.coverage);
  program.bind(surroundings_comp::wide_coverage, wide.coverage);
  program.bind(surroundings_comp::level, finest.color);
  program.run(finest.width, finest.height, eyes_);
}

void BlendRenderer::resolve(const OffscreenTarget& target) {
  using shaders::resolve_frag;
  attach(picture_target_, GL_COLOR_ATTACHMENT0, target.color());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture_target_.name());
  programs_.resolve.bind(resolve_frag::color_sum, color_sum_);
  programs_.resolve.bind(resolve_frag::nearest_depth, target.depth());
  programs_.resolve.bind(resolve_frag::surroundings, levels_.front().color);
  const Blending blending(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  programs_.resolve.use();
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  target.bind();
}

}  // namespace roomcast::render
