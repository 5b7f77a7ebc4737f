// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/texture.h"

#include <array>
#include <cmath>

namespace roomcast::alignment {
namespace {

constexpr int kBlurReach = kTextureBlurReach;

std::array<float, 2 * kBlurReach + 1> gaussian(float sigma_px) {
  std::array<float, 2 * kBlurReach + 1> kernel{};
  float sum = 0;
  for (int i = -kBlurReach; i <= kBlurReach; ++i) {
    const float x = static_cast<float>(i) / sigma_px;
    sum += kernel[static_cast<std::size_t>(i + kBlurReach)] = std::exp(-0.5F * x * x);
  }
  for (float& k : kernel) k /= sum;
  return kernel;
}

/// Pixels nearer to the border than the kernel reaches stay 0; no point uses them.
Image<float> blurred(const Image<std::uint8_t>& grey, float sigma_px) {
  const auto kernel = gaussian(sigma_px);
  const int width = grey.width(), height = grey.height();
  Image<float> across(width, height), out(width, height);
  for (int y = 0; y < height; ++y) {
    for (int shift = -kBlurReach; shift <= kBlurReach; ++shift) {
      const float weight = kernel[static_cast<std::size_t>(shift + kBlurReach)];
      const std::uint8_t* const from = grey.view().row(y) + shift;
      float* const to = across.view().row(y);
      for (int x = kBlurReach; x < width - kBlurReach; ++x) to[x] += weight * from[x];
    }
  }
  for (int y = kBlurReach; y < height - kBlurReach; ++y) {
    for (int shift = -kBlurReach; shift <= kBlurReach; ++shift) {
      const float weight = kernel[static_cast<std::size_t>(shift + kBlurReach)];
      const float* const from = across.view().row(y + shift);
      float* const to = out.view().row(y);
      for (int x = 0; x < width; ++x) to[x] += weight * from[x];
    }
  }
  return out;
}

std::optional<float> soft_at(const Image<float>& soft, const Eigen::Vector2f& pixel) {
  const float left = kBlurReach, top = kBlurReach;
  const float right = static_cast<float>(soft.width() - 1 - kBlurReach);
  const float bottom = static_cast<float>(soft.height() - 1 - kBlurReach);
  if (!(pixel.x() >= left && pixel.y() >= top && pixel.x() <= right && pixel.y() <= bottom)) {
    return std::nullopt;
  }
  return soft.at(static_cast<int>(std::lround(pixel.x())),
                 static_cast<int>(std::lround(pixel.y())));
}

/// Whether any pixel has a hue. One is enough: even in a grey room lamps and white balance tint the
/// picture of a colour camera.
bool has_hues(const Image<float>& soft_tint, float min_tint) {
  for (int y = kBlurReach; y < soft_tint.height() - kBlurReach; ++y) {
    for (int x = kBlurReach; x < soft_tint.width() - kBlurReach; ++x) {
      if (std::abs(soft_tint.at(x, y) - kNoTint) > min_tint) return true;
    }
  }
  return false;
}

}  // namespace

Texture make_texture(const DepthSurface& surface, const ColorPicture& picture,
                     const TextureOptions& options) {
  Texture texture;
  texture.width = surface.z_m.width() / kTextureStep;
  texture.height = surface.z_m.height() / kTextureStep;
  texture.soft_grey = blurred(picture.grey, options.blur_sigma_px);
  texture.soft_tint = blurred(picture.tint, options.blur_sigma_px);
  texture.has_hues = has_hues(texture.soft_tint, options.min_tint);
  for (int y = 0; y < texture.height; ++y) {
    for (int x = 0; x < texture.width; ++x) {
      const Eigen::Vector3f& point = surface.at.at(kTextureStep * x, kTextureStep * y).point_m;
      if (!(point.z() > 0)) continue;
      const Eigen::Vector3f in_color = picture.in_color_frame(point);
      if (!(in_color.z() > picture.nearest_m)) continue;
      const auto grey = texture_grey(texture, picture.pixel_of(in_color));
      if (!grey) continue;
      const Eigen::Vector2f pixel = picture.pixel_of(in_color);
      const float seen_z = picture.z_m.at(static_cast<int>(std::lround(pixel.x())),
                                          static_cast<int>(std::lround(pixel.y())));
      if (in_color.z() - seen_z > options.hidden_m) continue;
      texture.points.push_back({x, y, point, *grey});
    }
  }
  return texture;
}

std::optional<float> texture_grey(const Texture& texture, const Eigen::Vector2f& pixel) {
  return soft_at(texture.soft_grey, pixel);
}

std::optional<float> texture_tint(const Texture& texture, const Eigen::Vector2f& pixel) {
  return soft_at(texture.soft_tint, pixel);
}

}  // namespace roomcast::alignment
