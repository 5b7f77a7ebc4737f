// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/color_matching.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace roomcast::render {
namespace {

constexpr int kGridStep = 6;                    // pixels between compared points
constexpr std::size_t kEnoughPlaces = 60;       // per pair of sensors
constexpr int kDarkest = 20, kBrightest = 235;  // outside these levels a ratio is unreliable
constexpr double kSamePlace_m = 0.02, kSamePlacePer_m = 0.01;
constexpr double kPriorPlaces = 10;  // weight of the prior: a factor of 1
constexpr double kLargestLog = 0.5;
constexpr float kFollow = 0.5F;  // share of a change that one update applies

/// Copies every `step`-th pixel.
template <class T>
void copy(ImageView<const T> from, int step, Image<T>& to) {
  to.resize(from.width / step, from.height / step);
  for (int y = 0; y < to.height(); ++y) {
    for (int x = 0; x < to.width(); ++x) to.at(x, y) = from.at(step * x, step * y);
  }
}

bool is_telling(Rgb8 color) {
  const auto [least, most] = std::minmax({color.r, color.g, color.b});
  return least >= kDarkest && most <= kBrightest;
}

}  // namespace

void ColorMatching::offer(SensorId sensor, const CameraIntrinsics& lens, DepthView depth_mm,
                          ColorView color, MaskView seen) {
  if (color.pixel_count() == 0 || seen.pixel_count() == 0) return;
  Picture& picture = pictures_[sensor];
  if (++picture.skipped < kEvery && same_size(picture.lens, lens)) return;
  picture.skipped = 0;
  picture.lens = lens;
  copy(depth_mm, 1, picture.depth_mm);
  copy(color, color.width / depth_mm.width, picture.color);
  copy(seen, 1, picture.seen);
  is_news_ = true;
}

void ColorMatching::forget(SensorId sensor) {
  pictures_.erase(sensor);
}

std::optional<ColorRatio> ColorMatching::compare(const Picture& a, const Picture& b,
                                                 const RigidTransform& b_from_a) {
  ChannelLogs logs;
  for (int y = 0; y < a.lens.height; y += kGridStep) {
    for (int x = 0; x < a.lens.width; x += kGridStep) {
      const double z_m = 0.001 * a.depth_mm.at(x, y);
      if (z_m <= 0 || a.seen.at(x, y) == 0 || !is_telling(a.color.at(x, y))) continue;
      const auto point = unproject(a.lens, {x, y}, z_m);
      if (!point) continue;
      const Eigen::Vector3d in_b = b_from_a * *point;
      const auto pixel = project(b.lens, in_b);
      if (!pixel) continue;
      const int u = static_cast<int>(std::lround(pixel->x()));
      const int v = static_cast<int>(std::lround(pixel->y()));
      if (u < 0 || v < 0 || u >= b.lens.width || v >= b.lens.height) continue;
      const double apart_m = std::abs(0.001 * b.depth_mm.at(u, v) - in_b.z());
      if (apart_m > kSamePlace_m + kSamePlacePer_m * in_b.z()) continue;
      if (b.seen.at(u, v) == 0 || !is_telling(b.color.at(u, v))) continue;
      const Rgb8 ca = a.color.at(x, y), cb = b.color.at(u, v);
      logs[0].push_back(std::log(static_cast<double>(cb.r) / ca.r));
      logs[1].push_back(std::log(static_cast<double>(cb.g) / ca.g));
      logs[2].push_back(std::log(static_cast<double>(cb.b) / ca.b));
    }
  }
  if (logs[0].size() < kEnoughPlaces) return std::nullopt;
  return median_ratio(0, 0, logs);
}

void ColorMatching::update(const std::map<SensorId, RigidTransform>& world_from_depth) {
  if (!std::exchange(is_news_, false)) return;
  std::vector<std::pair<SensorId, Picture*>> known;
  for (auto& [id, picture] : pictures_) {
    if (world_from_depth.contains(id)) known.emplace_back(id, &picture);
  }
  std::vector<ColorRatio> ratios;
  for (std::size_t a = 0; a < known.size(); ++a) {
    for (std::size_t b = 0; b < known.size(); ++b) {
      if (a == b) continue;
      auto ratio = compare(
          *known[a].second, *known[b].second,
          world_from_depth.at(known[b].first).inverse() * world_from_depth.at(known[a].first));
      if (!ratio) continue;
      ratio->a = a;
      ratio->b = b;
      ratios.push_back(*ratio);
    }
  }
  const Eigen::MatrixXd logs =
      log_gains(ratios, known.size(), kPriorPlaces).cwiseMax(-kLargestLog).cwiseMin(kLargestLog);
  for (std::size_t i = 0; i < known.size(); ++i) {
    Eigen::Vector3f& log_gain = known[i].second->log_gain;
    const auto row = static_cast<Eigen::Index>(i);
    log_gain += kFollow * (logs.row(row).transpose().cast<float>() - log_gain);
  }
}

Eigen::Vector3f ColorMatching::gain(SensorId sensor) const {
  const auto picture = pictures_.find(sensor);
  if (picture == pictures_.end()) return Eigen::Vector3f::Ones();
  return picture->second.log_gain.array().exp().matrix();
}

}  // namespace roomcast::render
