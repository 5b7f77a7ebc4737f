// SPDX-License-Identifier: Apache-2.0
// The texture of a view's surfaces, for comparison with another sensor's view: on every second row
// and column of the depth grid, the point in space and its slightly blurred grey in the colour
// picture. Metres, grey 0..255. Thread-safe (immutable after being made).
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/view/color_picture.h"
#include "roomcast/alignment/view/depth_surface.h"
#include "roomcast/core/image.h"

namespace roomcast::alignment {

struct TexturedPoint {
  int x = 0, y = 0;  // in the grid
  Eigen::Vector3f point_m;
  float grey = 0;
};

inline constexpr int kTextureStep = 2;       // rows and columns of the depth grid
inline constexpr int kTextureBlurReach = 4;  // pixels: radius of the blur

struct TextureOptions {
  float blur_sigma_px = 1.8F;  // about the footprint of a cell of the grid
  float hidden_m = 0.05F;      // points further behind the surface seen in the pixel are hidden
  float min_tint = 4;          // levels from grey to a hue; above the noise of blurred colour

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("blur_sigma_px", blur_sigma_px, Range{0.1, kTextureBlurReach});
    visit("hidden_m", hidden_m, Range{0, 1});
    visit("min_tint", min_tint, Range{0, 128});
  }
  [[nodiscard]] Status check() const { return check_fields("TextureOptions", *this); }
};

struct Texture {
  int width = 0, height = 0;          // of the grid
  std::vector<TexturedPoint> points;  // row by row; only points that both cameras see
  Image<float> soft_grey;             // the grey picture, blurred like the points' greys
  Image<float> soft_tint;             // the tint picture, blurred alike
  bool has_hues = false;              // false where the whole picture is grey
};

[[nodiscard]] Texture make_texture(const DepthSurface& surface, const ColorPicture& picture,
                                   const TextureOptions& options = {});

/// The blurred grey, or tint, at a pixel of the colour picture; nothing outside it or closer to its
/// border than kTextureBlurReach.
[[nodiscard]] std::optional<float> texture_grey(const Texture& texture,
                                                const Eigen::Vector2f& pixel);
[[nodiscard]] std::optional<float> texture_tint(const Texture& texture,
                                                const Eigen::Vector2f& pixel);

}  // namespace roomcast::alignment
