// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/residual_pictures.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace roomcast::alignment::calibration {
namespace {

constexpr int kWidth = 960, kHeight = 640, kMargin = 60;
constexpr double kEnlarged = 100;
const cv::Scalar kInk(50, 50, 50), kFaint(215, 215, 215), kBefore(200, 130, 40),
    kAfter(30, 90, 200);

/// An OpenCV matrix over the pixels of the picture, red first.
class Canvas {
 public:
  Canvas(int width, int height) : picture_(width, height, Rgb8{255, 255, 255}) {
    matrix_ = cv::Mat(height, width, CV_8UC3, picture_.data());
  }
  void line(cv::Point2d a, cv::Point2d b, const cv::Scalar& color, int width = 1) {
    cv::line(matrix_, a, b, color, width, cv::LINE_AA);
  }
  void dot(cv::Point2d at, const cv::Scalar& color, int radius, bool filled = true) {
    cv::circle(matrix_, at, radius, color, filled ? cv::FILLED : 2, cv::LINE_AA);
  }
  void text(cv::Point at, const std::string& words, const cv::Scalar& color = kInk) {
    cv::putText(matrix_, words, at, cv::FONT_HERSHEY_SIMPLEX, 0.5, color, 1, cv::LINE_AA);
  }
  [[nodiscard]] ColorImage take() { return std::move(picture_); }

 private:
  ColorImage picture_;
  cv::Mat matrix_;
};

double round_up(double value, double step) {
  return std::max(step, step * std::ceil(value / step));
}

/// Axes of a diagram: distances to the right, errors up.
struct Axes {
  double farthest_m, largest_mm;
  [[nodiscard]] cv::Point2d at(double distance_m, double error_mm) const {
    return {kMargin + distance_m / farthest_m * (kWidth - 2 * kMargin),
            0.5 * kHeight - error_mm / largest_mm * (0.5 * kHeight - kMargin)};
  }
};

Axes axes_for(const std::vector<PlaneError>& views) {
  double farthest_m = 0, largest_mm = 0;
  for (const PlaneError& view : views) {
    farthest_m = std::max(farthest_m, view.distance_m);
    largest_mm =
        std::max({largest_mm, std::abs(view.mean_before_mm), std::abs(view.mean_after_mm)});
  }
  return {round_up(1.05 * farthest_m, 0.5), round_up(1.1 * largest_mm, 5)};
}

void draw_axes(const Axes& axes, Canvas& canvas) {
  for (int i = -4; i <= 4; ++i) {
    const double mm = axes.largest_mm * i / 4;
    canvas.line(axes.at(0, mm), axes.at(axes.farthest_m, mm), i == 0 ? kInk : kFaint);
    const cv::Point2d left = axes.at(0, mm);
    canvas.text({8, static_cast<int>(left.y) + 5}, fmt::format("{:+.1f}", mm));
  }
  for (double m = 0; m <= axes.farthest_m + 1e-6; m += 0.5) {
    const cv::Point2d bottom = axes.at(m, -axes.largest_mm);
    canvas.line(axes.at(m, axes.largest_mm), bottom, kFaint);
    canvas.text({static_cast<int>(bottom.x) - 18, kHeight - kMargin + 22},
                fmt::format("{:.1f} m", m));
  }
}

}  // namespace

ColorImage corner_error_picture(const LensFit& lens) {
  const double scale = (kWidth - 2.0 * kMargin) / lens.camera.width;
  const int height = static_cast<int>(scale * lens.camera.height) + 2 * kMargin;
  Canvas canvas(kWidth, height);
  const auto at = [&](const Eigen::Vector2d& pixel) {
    return cv::Point2d(kMargin + scale * (pixel.x() + 0.5), kMargin + scale * (pixel.y() + 0.5));
  };
  const Eigen::Vector2d first(-0.5, -0.5), last(lens.camera.width - 0.5, lens.camera.height - 0.5);
  for (int i = 0; i <= 4; ++i) {
    const Eigen::Vector2d on = first + (last - first) * i / 4;
    canvas.line(at({on.x(), first.y()}), at({on.x(), last.y()}), kFaint);
    canvas.line(at({first.x(), on.y()}), at({last.x(), on.y()}), kFaint);
  }
  for (const CornerError& corner : lens.errors) {
    canvas.line(at(corner.pixel), at(corner.pixel + kEnlarged * corner.error_px), kAfter);
    canvas.dot(at(corner.pixel), kInk, 2);
  }
  canvas.text({kMargin, kMargin - 20},
              fmt::format("{} corners, errors a hundredfold; root mean square {:.3f} px",
                          lens.errors.size(), lens.rms_px));
  return canvas.take();
}

ColorImage depth_error_picture(const DepthFit& depth) {
  Canvas canvas(kWidth, kHeight);
  const Axes axes = axes_for(depth.views);
  draw_axes(axes, canvas);
  for (const PlaneError& view : depth.views) {
    if (view.readings == 0) continue;
    const cv::Point2d before = axes.at(view.distance_m, view.mean_before_mm);
    const cv::Point2d after = axes.at(view.distance_m, view.mean_after_mm);
    canvas.line(before, after, kFaint);
    canvas.dot(before, kBefore, 5, false);
    canvas.dot(after, kAfter, 4);
  }
  canvas.text({kMargin, 24}, "depth behind the board (mm), mean of each view:");
  canvas.text({kMargin + 420, 24}, "o before", kBefore);
  canvas.text({kMargin + 510, 24}, "* after", kAfter);
  return canvas.take();
}

}  // namespace roomcast::alignment::calibration
