// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/rectified_features.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace roomcast::alignment {
namespace {

/// A picture of the plane: pixel (x, y) shows origin + x * right + y * down (depth frame, metres).
struct Rectification {
  Eigen::Vector3f origin_m, right_m, down_m;
  float scale_m = 0;  // per pixel
  int width = 0, height = 0;

  [[nodiscard]] Eigen::Vector3f at(const Eigen::Vector2f& pixel) const {
    return origin_m + pixel.x() * right_m + pixel.y() * down_m;
  }
};

struct Interval {
  float low, high;
};

Interval most_of(std::vector<float> values, const RectifiedFeatureOptions& options) {
  const auto cut =
      static_cast<std::ptrdiff_t>(options.outermost_share * static_cast<float>(values.size()));
  std::nth_element(values.begin(), values.begin() + cut, values.end());
  const float low = values[static_cast<std::size_t>(cut)];
  std::nth_element(values.begin(), values.end() - 1 - cut, values.end());
  return {low - options.margin_m, *(values.end() - 1 - cut) + options.margin_m};
}

/// Metres covered by a pixel, across the optical axis, where the plane is near.
float finest_pixel_m(const ColorPicture& picture, const Plane& plane, float near_share) {
  std::vector<float> z_m;
  for (const Eigen::Vector3f& point_m : plane.points_m)
    z_m.push_back(picture.in_color_frame(point_m).z());
  const auto near =
      z_m.begin() + static_cast<std::ptrdiff_t>(near_share * static_cast<float>(z_m.size()));
  std::nth_element(z_m.begin(), near, z_m.end());
  return *near / picture.camera.fx;
}

std::optional<Rectification> rectification_of(const ColorPicture& picture, const Plane& plane,
                                              const RectifiedFeatureOptions& options) {
  const Eigen::Vector3f& n = plane.normal;
  const Eigen::Vector3f up =
      std::abs(n.y()) < 0.8F ? Eigen::Vector3f(0, -1, 0) : Eigen::Vector3f(0, 0, 1);
  const Eigen::Vector3f right = up.cross(n).normalized();
  const Eigen::Vector3f down = -n.cross(right);
  const Eigen::Vector3f centre = -plane.offset_m * n;
  std::vector<float> x, y;
  for (const Eigen::Vector3f& point : plane.points_m) {
    x.push_back((point - centre).dot(right));
    y.push_back((point - centre).dot(down));
  }
  const Interval across = most_of(std::move(x), options), along = most_of(std::move(y), options);
  Rectification out;
  out.scale_m = std::max(options.min_pixel_m,
                         options.pixel_share * finest_pixel_m(picture, plane, options.near_share));
  out.width =
      std::min(options.max_side_px, static_cast<int>((across.high - across.low) / out.scale_m));
  out.height =
      std::min(options.max_side_px, static_cast<int>((along.high - along.low) / out.scale_m));
  if (out.width < options.min_side_px || out.height < options.min_side_px) return std::nullopt;
  out.origin_m = centre + across.low * right + along.low * down;
  out.right_m = out.scale_m * right;
  out.down_m = out.scale_m * down;
  return out;
}

/// Rectified pixel (homogeneous) -> point in the colour camera's frame.
Eigen::Matrix3f color_from_rectified(const ColorPicture& picture, const Rectification& view) {
  Eigen::Matrix3f matrix;
  matrix << picture.color_from_depth_rotation * view.right_m,
      picture.color_from_depth_rotation * view.down_m, picture.in_color_frame(view.origin_m);
  return matrix;
}

template <class T>
cv::Mat warped(const Image<T>& image, int type, const Eigen::Matrix3f& picture_from_rectified,
               const Rectification& view, int interpolation) {
  const cv::Mat from(image.height(), image.width(), type, const_cast<T*>(image.data()));
  cv::Mat homography(3, 3, CV_64F), out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) homography.at<double>(r, c) = picture_from_rectified(r, c);
  }
  cv::warpPerspective(from, out, homography, {view.width, view.height},
                      interpolation | cv::WARP_INVERSE_MAP);
  return out;
}

/// 255 where the surface seen in the picture is on the plane.
cv::Mat plane_mask(const cv::Mat& z_m, const Eigen::Matrix3f& color_from_view, float nearest_m,
                   const RectifiedFeatureOptions& options) {
  const float on_plane_m = options.on_plane_m, per_depth = options.on_plane_per_depth;
  cv::Mat mask(z_m.rows, z_m.cols, CV_8UC1);
  for (int y = 0; y < z_m.rows; ++y) {
    for (int x = 0; x < z_m.cols; ++x) {
      const float plane_z = color_from_view(2, 0) * static_cast<float>(x) +
                            color_from_view(2, 1) * static_cast<float>(y) + color_from_view(2, 2);
      const float z = z_m.at<float>(y, x);
      const bool on =
          z > 0 && plane_z > nearest_m && std::abs(z - plane_z) < on_plane_m + per_depth * plane_z;
      mask.at<std::uint8_t>(y, x) = on ? 255 : 0;
    }
  }
  cv::Mat closed;
  cv::morphologyEx(
      mask, closed, cv::MORPH_CLOSE,
      cv::getStructuringElement(cv::MORPH_RECT, {options.closing_px, options.closing_px}));
  return closed;
}

ImageView<const std::uint8_t> view_of(const cv::Mat& image) {
  return {image.ptr<std::uint8_t>(), image.cols, image.rows,
          static_cast<std::ptrdiff_t>(image.step[0])};
}

/// The point `height_m` above the plane on the camera's ray through a point of the plane.
Eigen::Vector3f raised(const Eigen::Vector3f& on_plane_m, float height_m, const Plane& plane,
                       const Eigen::Vector3f& eye_m) {
  return on_plane_m + height_m / plane.height_m(eye_m) * (eye_m - on_plane_m);
}

void add_features_of(const ColorPicture& picture, const DepthSurface& surface, const Plane& plane,
                     const Rectification& view, const RectifiedFeatureOptions& options,
                     FeatureSet& set) {
  const PlaneRelief relief(plane, surface.samples, options.relief);
  const Eigen::Vector3f eye_m =
      -(picture.color_from_depth_rotation.transpose() * picture.color_from_depth_m);
  const Eigen::Matrix3f color_from_view = color_from_rectified(picture, view);
  Eigen::Matrix3f camera;
  camera << picture.camera.fx, 0, picture.camera.cx, 0, picture.camera.fy, picture.camera.cy, 0, 0,
      1;
  const Eigen::Matrix3f picture_from_view = camera * color_from_view;
  const cv::Mat grey = warped(picture.grey, CV_8UC1, picture_from_view, view, cv::INTER_LINEAR);
  const cv::Mat z_m = warped(picture.z_m, CV_32FC1, picture_from_view, view, cv::INTER_NEAREST);
  const cv::Mat mask = plane_mask(z_m, color_from_view, picture.nearest_m, options);
  for (const SiftFeature& found : detect_sift(view_of(grey), view_of(mask), options.sift)) {
    const Eigen::Vector2f pixel = picture.pixel_of(picture.in_color_frame(view.at(found.pixel)));
    const auto height_m = relief.height_m(view.at(found.pixel));
    if (!height_m) continue;
    set.features.push_back(
        {raised(view.at(found.pixel), *height_m, plane, eye_m), pixel, found.size * view.scale_m});
    set.descriptors.push_back(found.descriptor);
  }
}

}  // namespace

FeatureSet rectified_features(const ColorPicture& picture, const DepthSurface& surface,
                              std::span<const Plane> planes,
                              const RectifiedFeatureOptions& options) {
  cv::setNumThreads(1);
  FeatureSet set;
  for (const Plane& plane : planes) {
    if (const auto view = rectification_of(picture, plane, options))
      add_features_of(picture, surface, plane, *view, options, set);
  }
  return set;
}

}  // namespace roomcast::alignment
