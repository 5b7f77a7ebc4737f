// SPDX-License-Identifier: Apache-2.0
#include "bench/render/view_score.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "bench/render/depth_tolerance.h"
#include "bench/render/silhouette_score.h"

namespace roomcast::bench {
namespace {

cv::Mat grey_of(const ColorImage& image) {
  cv::Mat grey(image.height(), image.width(), CV_32F);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Rgb8 c = image.at(x, y);
      grey.at<float>(y, x) = 0.299F * static_cast<float>(c.r) + 0.587F * static_cast<float>(c.g) +
                             0.114F * static_cast<float>(c.b);
    }
  }
  return grey;
}

cv::Mat blurred(const cv::Mat& image) {
  cv::Mat out;
  cv::GaussianBlur(image, out, {11, 11}, 1.5);
  return out;
}

cv::Mat ssim_map(const ColorImage& a, const ColorImage& b) {
  constexpr float c1 = 0.01F * 255 * 0.01F * 255, c2 = 0.03F * 255 * 0.03F * 255;
  const cv::Mat x = grey_of(a), y = grey_of(b);
  const cv::Mat mean_x = blurred(x), mean_y = blurred(y);
  const cv::Mat var_x = blurred(x.mul(x)) - mean_x.mul(mean_x);
  const cv::Mat var_y = blurred(y.mul(y)) - mean_y.mul(mean_y);
  const cv::Mat covariance = blurred(x.mul(y)) - mean_x.mul(mean_y);
  const cv::Mat above = (2 * mean_x.mul(mean_y) + c1).mul(2 * covariance + c2);
  const cv::Mat below = (mean_x.mul(mean_x) + mean_y.mul(mean_y) + c1).mul(var_x + var_y + c2);
  return above / below;
}

struct Sum {
  double squared = 0, ssim = 0;
  double pixels = 0;

  void add(double squared_error, double similarity) {
    squared += squared_error;
    ssim += similarity;
    pixels += 1;
  }
  [[nodiscard]] double psnr_db() const {
    return 10 * std::log10(255.0 * 255.0 * std::max(pixels, 1.0) / std::max(squared, 1e-9));
  }
  [[nodiscard]] double mean_ssim() const { return ssim / std::max(pixels, 1.0); }
};

double squared_error(Rgb8 a, Rgb8 b) {
  const auto squared = [](int d) { return static_cast<double>(d * d); };
  return (squared(a.r - b.r) + squared(a.g - b.g) + squared(a.b - b.b)) / 3;
}

}  // namespace

ViewScore score(const DrawnView& drawn, const TruthView& truth, const ViewClasses& classes) {
  const cv::Mat ssim = ssim_map(drawn.color, truth.color);
  Sum picture, covered, visible, colored, moving;
  double holes = 0, floaters = 0, wrong = 0, judged = 0;
  for (int y = 0; y < truth.color.height(); ++y) {
    for (int x = 0; x < truth.color.width(); ++x) {
      const double error = squared_error(drawn.color.at(x, y), truth.color.at(x, y));
      const double similarity = static_cast<double>(ssim.at<float>(y, x));
      const float z_m = drawn.depth_m.at(x, y);
      const float true_m = 0.001F * static_cast<float>(truth.depth_mm.at(x, y));
      const bool is_visible = truth.seen.at(x, y) != 0;
      picture.add(error, similarity);
      if (z_m > 0) covered.add(error, similarity);
      if (!is_visible) continue;
      visible.add(error, similarity);
      if (classes.colored.at(x, y) != 0) colored.add(error, similarity);
      if (classes.moving.at(x, y) != 0) moving.add(error, similarity);
      if (z_m <= 0) {
        holes += 1;
        continue;
      }
      if (true_m <= 0) continue;
      const float tolerance = static_cast<float>(depth_tolerance_m(static_cast<double>(true_m)));
      judged += 1;
      floaters += z_m < true_m - tolerance;
      wrong += std::abs(z_m - true_m) > tolerance;
    }
  }
  const double psnr_moving =
      moving.pixels > 0 ? moving.psnr_db() : std::numeric_limits<double>::quiet_NaN();
  const SilhouetteErrors person = find_errors(drawn.depth_m, truth, classes.silhouette);
  const auto share = [](double of, double whole) { return whole > 0 ? of / whole : 0; };
  return {picture.psnr_db(),
          picture.mean_ssim(),
          covered.psnr_db(),
          covered.mean_ssim(),
          visible.psnr_db(),
          visible.mean_ssim(),
          colored.psnr_db(),
          colored.mean_ssim(),
          psnr_moving,
          share(holes, visible.pixels),
          share(floaters, judged),
          share(wrong, judged),
          share(covered.pixels, picture.pixels),
          person.missing_share,
          person.doubled_share};
}

ViewScore mean(const std::vector<ViewScore>& scores) {
  ViewScore sum;
  for (double ViewScore::*field :
       {&ViewScore::psnr_all, &ViewScore::ssim_all, &ViewScore::psnr_covered,
        &ViewScore::ssim_covered, &ViewScore::psnr_visible, &ViewScore::ssim_visible,
        &ViewScore::psnr_colored, &ViewScore::ssim_colored, &ViewScore::psnr_moving,
        &ViewScore::holes, &ViewScore::floaters, &ViewScore::wrong_depth, &ViewScore::covered,
        &ViewScore::silhouette_missing, &ViewScore::silhouette_doubled}) {
    double count = 0;
    for (const ViewScore& one : scores) {
      if (std::isnan(one.*field)) continue;
      sum.*field += one.*field;
      count += 1;
    }
    sum.*field /= count;
  }
  return sum;
}

double flicker(const DrawnView& a, const DrawnView& b, const TruthView& truth,
               const ViewClasses& classes) {
  double sum = 0, pixels = 0;
  for (int y = 0; y < truth.color.height(); ++y) {
    for (int x = 0; x < truth.color.width(); ++x) {
      if (truth.seen.at(x, y) == 0 || classes.moving.at(x, y) != 0) continue;
      if (a.depth_m.at(x, y) <= 0 || b.depth_m.at(x, y) <= 0) continue;
      const Rgb8 p = a.color.at(x, y), q = b.color.at(x, y);
      sum += (std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b)) / 3.0;
      pixels += 1;
    }
  }
  return pixels > 0 ? sum / pixels : 0;
}

}  // namespace roomcast::bench
