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
constexpr int kTurn = 3;         // pictures between the turns of two sensors that begin together
constexpr float kFollow = 0.5F;  // share of a change that one update applies

/// Copies every `step`-th pixel.
template <class T>
void copy(ImageView<const T> from, int step, Image<T>& to) {
  to.resize(from.width / step, from.height / step);
  for (int y = 0; y < to.height(); ++y) {
    const T* source = &from.at(0, step * y);
    T* pixel = &to.at(0, y);
    if (step == 1) {
      std::copy_n(source, to.width(), pixel);
      continue;
    }
    for (int x = 0; x < to.width(); ++x) pixel[x] = source[step * x];
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
  const bool is_first = picture.version == 0;
  picture.skipped = is_first ? kTurn * static_cast<int>(pictures_.size()) % kEvery : 0;
  picture.lens = lens;
  copy(depth_mm, 1, picture.depth_mm);
  copy(color, color.width / depth_mm.width, picture.color);
  copy(seen, 1, picture.seen);
  picture.places = places_of(picture);
  ++picture.version;
}

void ColorMatching::forget(SensorId sensor) {
  pictures_.erase(sensor);
  std::erase_if(comparisons_, [&](const auto& known) {
    return known.first.first == sensor || known.first.second == sensor;
  });
}

std::vector<ColorMatching::Place> ColorMatching::places_of(const Picture& picture) {
  std::vector<Place> places;
  for (int y = 0; y < picture.lens.height; y += kGridStep) {
    for (int x = 0; x < picture.lens.width; x += kGridStep) {
      const double z_m = 0.001 * picture.depth_mm.at(x, y);
      const Rgb8 color = picture.color.at(x, y);
      if (z_m <= 0 || picture.seen.at(x, y) == 0 || !is_telling(color)) continue;
      const auto point = unproject(picture.lens, {x, y}, z_m);
      if (point) places.push_back({*point, color});
    }
  }
  return places;
}

std::optional<ColorRatio> ColorMatching::compare(const Picture& a, const Picture& b,
                                                 const RigidTransform& b_from_a) {
  ChannelLogs logs;
  for (const Place& place : a.places) {
    const Eigen::Vector3d in_b = b_from_a * place.point_m;
    const auto pixel = project(b.lens, in_b);
    if (!pixel) continue;
    const int u = static_cast<int>(std::lround(pixel->x()));
    const int v = static_cast<int>(std::lround(pixel->y()));
    if (u < 0 || v < 0 || u >= b.lens.width || v >= b.lens.height) continue;
    const double apart_m = std::abs(0.001 * b.depth_mm.at(u, v) - in_b.z());
    if (apart_m > kSamePlace_m + kSamePlacePer_m * in_b.z()) continue;
    const Rgb8 ca = place.color, cb = b.color.at(u, v);
    if (b.seen.at(u, v) == 0 || !is_telling(cb)) continue;
    logs[0].push_back(std::log(static_cast<double>(cb.r) / ca.r));
    logs[1].push_back(std::log(static_cast<double>(cb.g) / ca.g));
    logs[2].push_back(std::log(static_cast<double>(cb.b) / ca.b));
  }
  if (logs[0].size() < kEnoughPlaces) return std::nullopt;
  return median_ratio(0, 0, logs);
}

/// Pairs of placed sensors whose pictures or poses have changed since they were compared; those
/// that were compared longest ago come at the front.
std::vector<ColorMatching::Pair> ColorMatching::outdated(
    const std::map<SensorId, RigidTransform>& world_from_depth) {
  std::vector<Pair> pairs;
  for (const auto& [a, picture] : pictures_) {
    for (const auto& [b, other] : pictures_) {
      if (a == b || !world_from_depth.contains(a) || !world_from_depth.contains(b)) continue;
      Comparison& known = comparisons_[{a, b}];
      const RigidTransform b_from_a = world_from_depth.at(b).inverse() * world_from_depth.at(a);
      if (known.version == picture.version && known.other_version == other.version &&
          known.other_from_sensor == b_from_a) {
        continue;
      }
      known.other_from_sensor = b_from_a;
      pairs.emplace_back(a, b);
    }
  }
  std::ranges::stable_sort(pairs, {}, [&](Pair pair) { return comparisons_.at(pair).made_in; });
  return pairs;
}

void ColorMatching::update(const std::map<SensorId, RigidTransform>& world_from_depth) {
  std::vector<Pair> pairs = outdated(world_from_depth);
  if (pairs.empty()) return;
  if (pairs.size() > kMaxComparisons) pairs.resize(kMaxComparisons);
  ++updates_;
  for (const Pair& pair : pairs) {
    const Picture &a = pictures_.at(pair.first), &b = pictures_.at(pair.second);
    Comparison& known = comparisons_.at(pair);
    known.ratio = compare(a, b, known.other_from_sensor);
    known.version = a.version;
    known.other_version = b.version;
    known.made_in = updates_;
  }
  solve(world_from_depth);
}

/// Moves the factors towards those that fit all comparisons.
void ColorMatching::solve(const std::map<SensorId, RigidTransform>& world_from_depth) {
  std::map<SensorId, std::size_t> rows;
  for (const auto& [id, picture] : pictures_) {
    if (world_from_depth.contains(id)) rows.emplace(id, rows.size());
  }
  std::vector<ColorRatio> ratios;
  for (const auto& [pair, known] : comparisons_) {
    if (!known.ratio || !rows.contains(pair.first) || !rows.contains(pair.second)) continue;
    ColorRatio ratio = *known.ratio;
    ratio.a = rows.at(pair.first);
    ratio.b = rows.at(pair.second);
    ratios.push_back(ratio);
  }
  const Eigen::MatrixXd logs =
      log_gains(ratios, rows.size(), kPriorPlaces).cwiseMax(-kLargestLog).cwiseMin(kLargestLog);
  for (const auto& [id, row] : rows) {
    Eigen::Vector3f& log_gain = pictures_.at(id).log_gain;
    const auto wanted = logs.row(static_cast<Eigen::Index>(row)).transpose().cast<float>();
    log_gain += kFollow * (wanted - log_gain);
  }
}

Eigen::Vector3f ColorMatching::gain(SensorId sensor) const {
  const auto picture = pictures_.find(sensor);
  if (picture == pictures_.end()) return Eigen::Vector3f::Ones();
  return picture->second.log_gain.array().exp().matrix();
}

}  // namespace roomcast::render
