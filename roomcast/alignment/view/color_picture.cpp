// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/color_picture.h"

#include <algorithm>
#include <cmath>

namespace roomcast::alignment {
namespace {

/// `of_pixel` of the picture, downscaled by `factor`: each output pixel is the mean of factor x
/// factor input pixels.
template <class OfPixel>
Image<float> shrunk(ColorView color, int factor, OfPixel of_pixel) {
  Image<float> out(std::max(1, color.width / factor), std::max(1, color.height / factor));
  const float scale = 1 / static_cast<float>(factor * factor);
  for (int y = 0; y < out.height(); ++y) {
    for (int dy = 0; dy < factor && y * factor + dy < color.height; ++dy) {
      const Rgb8* const from = color.row(y * factor + dy);
      float* const to = out.view().row(y);
      for (int x = 0; x < out.width() * factor; ++x) to[x / factor] += scale * of_pixel(from[x]);
    }
  }
  return out;
}

float grey_of(Rgb8 pixel) {
  return 0.25F * static_cast<float>(pixel.r + 2 * pixel.g + pixel.b);
}

float tint_of(Rgb8 pixel) {
  constexpr float kEvenly = 0.25F;  // offsets rounding halves up, so that neither sign is favoured
  return kNoTint - kEvenly + 0.5F * static_cast<float>(pixel.r - pixel.g);
}

float bilinear(const Image<float>& image, float u, float v) {
  const int x = std::clamp(static_cast<int>(u), 0, std::max(0, image.width() - 2));
  const int y = std::clamp(static_cast<int>(v), 0, std::max(0, image.height() - 2));
  const int right = std::min(x + 1, image.width() - 1), below = std::min(y + 1, image.height() - 1);
  const float a = u - static_cast<float>(x), b = v - static_cast<float>(y);
  return (1 - b) * ((1 - a) * image.at(x, y) + a * image.at(right, y)) +
         b * ((1 - a) * image.at(x, below) + a * image.at(right, below));
}

CameraIntrinsics shrunk(CameraIntrinsics camera, int factor) {
  camera.width = std::max(1, camera.width / factor);
  camera.height = std::max(1, camera.height / factor);
  camera.fx /= factor;
  camera.fy /= factor;
  camera.cx = (camera.cx + 0.5) / factor - 0.5;
  camera.cy = (camera.cy + 0.5) / factor - 0.5;
  return camera;
}

Image<std::uint8_t> undistorted(const Image<float>& grey, const CameraIntrinsics& camera) {
  const Lens lens(camera);
  Image<std::uint8_t> out(camera.width, camera.height);
  const float right = static_cast<float>(camera.width - 1);
  const float bottom = static_cast<float>(camera.height - 1);
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) {
      const Eigen::Vector3f ray(static_cast<float>((x - camera.cx) / camera.fx),
                                static_cast<float>((y - camera.cy) / camera.fy), 1);
      Eigen::Vector2f from;
      if (!lens.project(ray, from)) continue;
      if (from.x() < 0 || from.y() < 0 || from.x() > right || from.y() > bottom) continue;
      out.at(x, y) = static_cast<std::uint8_t>(std::lround(bilinear(grey, from.x(), from.y())));
    }
  }
  return out;
}

/// Splats each depth reading over as many pixels as neighbouring readings are apart; the nearest
/// depth wins.
void splat(const DepthSurface& surface, int max_reach, ColorPicture& picture) {
  const float spread = picture.camera.fx / static_cast<float>(surface.camera.fx);
  const int reach = std::clamp(static_cast<int>(std::ceil(spread)), 1, max_reach);
  for (std::size_t i = 0; i < surface.at.view().pixel_count(); ++i) {
    const Eigen::Vector3f& point = surface.at.data()[i].point_m;
    if (!(point.z() > 0)) continue;
    const Eigen::Vector3f in_color = picture.in_color_frame(point);
    if (!(in_color.z() > picture.nearest_m)) continue;
    const Eigen::Vector2f pixel = picture.pixel_of(in_color);
    const float offset = 0.5F * static_cast<float>(reach - 1);
    const float left = std::round(pixel.x() - offset), top = std::round(pixel.y() - offset);
    if (!(left > -10 && top > -10 && left < 1e5F && top < 1e5F)) continue;
    const int x0 = static_cast<int>(left), y0 = static_cast<int>(top);
    for (int y = std::max(0, y0); y < std::min(picture.z_m.height(), y0 + reach + 1); ++y) {
      for (int x = std::max(0, x0); x < std::min(picture.z_m.width(), x0 + reach + 1); ++x) {
        float& z = picture.z_m.at(x, y);
        if (z == 0 || in_color.z() < z) z = in_color.z();
      }
    }
  }
}

}  // namespace

ColorPicture color_picture(ColorView color, const SensorCalibration& calibration,
                           const DepthSurface& surface, const ColorPictureOptions& options) {
  const int factor = (color.width + options.max_width_px - 1) / options.max_width_px;
  const CameraIntrinsics camera = shrunk(calibration.color, factor);
  ColorPicture picture;
  const auto f = [](double x) { return static_cast<float>(x); };
  picture.camera = {f(camera.fx), f(camera.fy), f(camera.cx), f(camera.cy)};
  picture.grey = undistorted(shrunk(color, factor, grey_of), camera);
  picture.tint = undistorted(shrunk(color, factor, tint_of), camera);
  picture.color_from_depth_rotation = calibration.color_from_depth.rotation.cast<float>();
  picture.color_from_depth_m = calibration.color_from_depth.translation_m.cast<float>();
  picture.nearest_m = surface.options.nearest_m;
  picture.z_m.resize(camera.width, camera.height);
  splat(surface, options.max_splat_px, picture);
  return picture;
}

}  // namespace roomcast::alignment
