// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/rectified_features.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "roomcast/alignment/feature/plane_relief.h"
#include "roomcast/alignment/feature/sift_detector.h"

namespace roomcast::alignment {
namespace {

constexpr float kFinest_m = 0.004F;   // smallest pixel of the rectified picture
constexpr float kOfAPixel = 0.7F;     // smallest pixel, as a share of the finest source pixel
constexpr float kNearest = 0.1F;      // share of the points that count as near
constexpr float kMargin_m = 0.05F;    // around the plane's points
constexpr float kOutermost = 0.005F;  // share of points cut off on every side
constexpr int kLargestSide = 1600, kSmallestSide = 60;
constexpr float kOnPlane_m = 0.05F, kOnPlanePerDepth = 0.01F;
constexpr int kClosing = 7;  // pixels: closes pinholes in the mask
constexpr SiftOptions kSift{2500, 0.012, 15};

/// A picture of the plane: pixel (x, y) shows origin + x * right + y * down (depth frame, metres).
struct Rectification {
  Eigen::Vector3f origin_m, right_m, down_m;
  float scale_m = kFinest_m;  // per pixel
  int width = 0, height = 0;

  [[nodiscard]] Eigen::Vector3f at(const Eigen::Vector2f& pixel) const {
    return origin_m + pixel.x() * right_m + pixel.y() * down_m;
  }
};

struct Interval {
  float low, high;
};

Interval most_of(std::vector<float> values) {
  const auto cut = static_cast<std::ptrdiff_t>(kOutermost * static_cast<float>(values.size()));
  std::nth_element(values.begin(), values.begin() + cut, values.end());
  const float low = values[static_cast<std::size_t>(cut)];
  std::nth_element(values.begin(), values.end() - 1 - cut, values.end());
  return {low - kMargin_m, *(values.end() - 1 - cut) + kMargin_m};
}

/// Metres covered by a pixel, across the optical axis, where the plane is near.
float finest_pixel_m(const ColorPicture& picture, const Plane& plane) {
  std::vector<float> z_m;
  for (const Eigen::Vector3f& point_m : plane.points_m)
    z_m.push_back(picture.in_color_frame(point_m).z());
  const auto near =
      z_m.begin() + static_cast<std::ptrdiff_t>(kNearest * static_cast<float>(z_m.size()));
  std::nth_element(z_m.begin(), near, z_m.end());
  return *near / picture.camera.fx;
}

std::optional<Rectification> rectification_of(const ColorPicture& picture, const Plane& plane) {
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
  const Interval across = most_of(std::move(x)), along = most_of(std::move(y));
  Rectification out;
  out.scale_m = std::max(kFinest_m, kOfAPixel * finest_pixel_m(picture, plane));
  out.width = std::min(kLargestSide, static_cast<int>((across.high - across.low) / out.scale_m));
  out.height = std::min(kLargestSide, static_cast<int>((along.high - along.low) / out.scale_m));
  if (out.width < kSmallestSide || out.height < kSmallestSide) return std::nullopt;
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
cv::Mat plane_mask(const cv::Mat& z_m, const Eigen::Matrix3f& color_from_view) {
  cv::Mat mask(z_m.rows, z_m.cols, CV_8UC1);
  for (int y = 0; y < z_m.rows; ++y) {
    for (int x = 0; x < z_m.cols; ++x) {
      const float plane_z = color_from_view(2, 0) * static_cast<float>(x) +
                            color_from_view(2, 1) * static_cast<float>(y) + color_from_view(2, 2);
      const float z = z_m.at<float>(y, x);
      const bool on = z > 0 && plane_z > kNearestSurface_m &&
                      std::abs(z - plane_z) < kOnPlane_m + kOnPlanePerDepth * plane_z;
      mask.at<std::uint8_t>(y, x) = on ? 255 : 0;
    }
  }
  cv::Mat closed;
  cv::morphologyEx(mask, closed, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_RECT, {kClosing, kClosing}));
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
                     const Rectification& view, FeatureSet& set) {
  const PlaneRelief relief(plane, surface.samples);
  const Eigen::Vector3f eye_m =
      -(picture.color_from_depth_rotation.transpose() * picture.color_from_depth_m);
  const Eigen::Matrix3f color_from_view = color_from_rectified(picture, view);
  Eigen::Matrix3f camera;
  camera << picture.camera.fx, 0, picture.camera.cx, 0, picture.camera.fy, picture.camera.cy, 0, 0,
      1;
  const Eigen::Matrix3f picture_from_view = camera * color_from_view;
  const cv::Mat grey = warped(picture.grey, CV_8UC1, picture_from_view, view, cv::INTER_LINEAR);
  const cv::Mat z_m = warped(picture.z_m, CV_32FC1, picture_from_view, view, cv::INTER_NEAREST);
  const cv::Mat mask = plane_mask(z_m, color_from_view);
  for (const SiftFeature& found : detect_sift(view_of(grey), view_of(mask), kSift)) {
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
                              std::span<const Plane> planes) {
  cv::setNumThreads(1);
  FeatureSet set;
  for (const Plane& plane : planes) {
    if (const auto view = rectification_of(picture, plane))
      add_features_of(picture, surface, plane, *view, set);
  }
  return set;
}

}  // namespace roomcast::alignment
