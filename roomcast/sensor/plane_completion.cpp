// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/plane_completion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace roomcast::sensor {
namespace {

// Frames from plan to plan: often while the room is new, for a plan takes tens of milliseconds.
constexpr int kFirstPlan = 8, kFirstGap = 15, kMaxGap = 150;
constexpr double kMinOpen = 0.02;  // share of the picture without readings that deserves a plan
constexpr std::uint16_t kForgotten = 300;              // frames without a reading
constexpr std::size_t kMinHole = 30, kMinBorder = 20;  // pixels
constexpr float kMaxBehind = 0.03F;   // share of a hole's border seen behind a plane
constexpr float kMinSupport = 0.15F;  // share of a hole's border on a plane
constexpr float kOfBest = 0.5F;   // of the support of the best plane; others cut across by chance
constexpr float kPane = 0.92F;    // support of a window's, picture's or screen's hole by its wall
constexpr float kBeyond = 1.25F;  // times the farthest usual reading
constexpr float kNearest_m = 0.3F;
constexpr int kMaxColorChange = 60;  // sum over the three channels
constexpr std::uint32_t kNoPixel = std::numeric_limits<std::uint32_t>::max();

int difference(const Rgb8& a, const std::uint8_t* b) {
  return std::abs(a.r - b[0]) + std::abs(a.g - b[1]) + std::abs(a.b - b[2]);
}

/// As registered colour is where it is unknown.
bool is_black(const Rgb8& color) {
  return color.r + color.g + color.b == 0;
}

}  // namespace

/// How often colours occur on a plane, in 8 x 8 x 8 cells.
class PlaneCompletion::ColorModel {
 public:
  void add(const Rgb8& color) {
    ++cells_[cell(color.r >> 5, color.g >> 5, color.b >> 5)];
    ++all_;
  }
  /// Whether the colour and those next to it make up a visible part of the plane.
  [[nodiscard]] bool knows(const Rgb8& color) const {
    constexpr int kMinSamples = 50;
    constexpr float kMinPart = 0.01F;
    int near = 0;
    for (int r = std::max(0, (color.r - 16) >> 5); r <= std::min(7, (color.r + 16) >> 5); ++r) {
      for (int g = std::max(0, (color.g - 16) >> 5); g <= std::min(7, (color.g + 16) >> 5); ++g) {
        for (int b = std::max(0, (color.b - 16) >> 5); b <= std::min(7, (color.b + 16) >> 5); ++b)
          near += cells_[cell(r, g, b)];
      }
    }
    return all_ >= kMinSamples && static_cast<float>(near) >= kMinPart * static_cast<float>(all_);
  }

 private:
  static std::size_t cell(int r, int g, int b) {
    return static_cast<std::size_t>(r << 6 | g << 3 | b);
  }
  std::array<int, 512> cells_{};
  int all_ = 0;
};

PlaneCompletion::PlaneCompletion(const SensorCalibration& calibration)
    : calibration_(calibration),
      rays_(ray_table(calibration.depth)),
      history_(calibration.depth.width, calibration.depth.height),
      next_plan_(kFirstPlan),
      gap_(kFirstGap),
      visited_(calibration.depth.width, calibration.depth.height) {}

void PlaneCompletion::complete(DepthImage& depth_mm, ColorView color) {
  filled_ = 0;
  if (!same_size(depth_mm.view(), calibration_.depth)) return;
  remember(depth_mm);
  if (!same_size(color, calibration_.color) || !color.contiguous()) return;
  ++frames_;
  if (frames_ == next_plan_) {
    next_plan_ += gap_;
    gap_ = std::min(2 * gap_, kMaxGap);
    plan(depth_mm, color);
  }
  fill(depth_mm, color);
}

void PlaneCompletion::remember(DepthView depth_mm) {
  for (int y = 0; y < depth_mm.height; ++y) {
    const std::uint16_t* readings = depth_mm.row(y);
    History* history = history_.view().row(y);
    for (int x = 0; x < depth_mm.width; ++x) {
      if (readings[x] != 0) {
        history[x] = {readings[x], 0};
      } else if (history[x].last_mm != 0 && ++history[x].frames_since >= kForgotten) {
        history[x] = {};
      }
    }
  }
}

/// Whether a pixel has no reading of the last moments.
bool PlaneCompletion::is_open(std::uint32_t pixel) const {
  constexpr std::uint16_t kRecent = 8;
  const History& history = history_.data()[pixel];
  return (history.last_mm == 0 || history.frames_since >= kRecent) &&
         rays_.data()[pixel].allFinite();
}

double PlaneCompletion::open_share() const {
  const auto pixels = static_cast<std::uint32_t>(history_.view().pixel_count());
  std::uint32_t open = 0;
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) open += is_open(pixel);
  return static_cast<double>(open) / pixels;
}

/// Whether the sensor has seen something else than this plane at a pixel.
bool PlaneCompletion::is_foreign(std::uint32_t pixel, float depth_m) const {
  const History& history = history_.data()[pixel];
  if (history.last_mm == 0) return false;
  const float last_m = 0.001F * static_cast<float>(history.last_mm);
  return std::abs(last_m - depth_m) > 2 * plane_tolerance_m(depth_m);
}

void PlaneCompletion::plan(DepthView depth_mm, ColorView color) {
  fills_.clear();
  if (open_share() < kMinOpen) return;
  planes_ = find_planes(depth_mm, rays_);
  std::vector<std::uint16_t> readings;
  for (int y = 0; y < depth_mm.height; y += 8) {
    for (int x = 0; x < depth_mm.width; x += 8) {
      if (depth_mm.at(x, y) != 0) readings.push_back(depth_mm.at(x, y));
    }
  }
  if (planes_.empty() || readings.empty()) return;
  const auto far =
      readings.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(readings.size()));
  std::ranges::nth_element(readings, far);
  farthest_m_ = kBeyond * 0.001F * static_cast<float>(*far);
  find_holes();
  refine_planes();
  std::vector<ColorModel> models;
  for (const Plane& plane : planes_) models.push_back(model_of(plane, color));
  for (const Hole& hole : holes_) plan_hole(hole, models, color);
}

void PlaneCompletion::find_holes() {
  holes_.clear();
  std::fill_n(visited_.data(), visited_.view().pixel_count(), std::uint8_t{0});
  for (int y = 0; y < history_.height(); ++y) {
    for (int x = 0; x < history_.width(); ++x) {
      const auto pixel = static_cast<std::uint32_t>(y * history_.width() + x);
      if (visited_.data()[pixel] == 0 && is_open(pixel)) collect_hole(x, y);
    }
  }
}

Eigen::Vector3f PlaneCompletion::last_point_m(std::uint32_t pixel) const {
  const Eigen::Vector2f& ray = rays_.data()[pixel];
  const float z_m = 0.001F * static_cast<float>(history_.data()[pixel].last_mm);
  return {z_m * ray.x(), z_m * ray.y(), z_m};
}

/// By the readings all over the picture and, with as much weight in all, by the borders of holes.
void PlaneCompletion::refine_planes() {
  constexpr int kEvery_px = 8;
  constexpr std::size_t kMaxBorders = 4000;
  constexpr float kReach = 3;
  std::vector<Eigen::Vector3f> points_m;
  for (int y = 0; y < history_.height(); y += kEvery_px) {
    for (int x = 0; x < history_.width(); x += kEvery_px) {
      const auto pixel = static_cast<std::uint32_t>(y * history_.width() + x);
      if (!is_open(pixel)) points_m.push_back(last_point_m(pixel));
    }
  }
  const std::size_t readings = points_m.size();
  std::size_t borders = 0;
  for (const Hole& hole : holes_) borders += hole.border.size();
  const std::size_t every = borders / kMaxBorders + 1;
  for (const Hole& hole : holes_) {
    for (std::size_t i = 0; i < hole.border.size(); i += every)
      points_m.push_back(last_point_m(hole.border[i]));
  }
  for (Plane& plane : planes_) {
    std::size_t near_readings = 0, near_borders = 0;
    for (std::size_t i = 0; i < points_m.size(); ++i) {
      if (is_near(plane, points_m[i], kReach)) ++(i < readings ? near_readings : near_borders);
    }
    if (near_borders == 0) continue;
    const float share = static_cast<float>(near_readings) / static_cast<float>(near_borders);
    std::vector<float> weights(points_m.size(), 1);
    std::fill(weights.begin() + static_cast<std::ptrdiff_t>(readings), weights.end(), share);
    plane = refined(plane, points_m, weights, kReach);
  }
}

PlaneCompletion::ColorModel PlaneCompletion::model_of(const Plane& plane, ColorView color) const {
  constexpr int kEvery_px = 6;
  ColorModel model;
  for (int y = 0; y < history_.height(); y += kEvery_px) {
    for (int x = 0; x < history_.width(); x += kEvery_px) {
      const auto pixel = static_cast<std::uint32_t>(y * history_.width() + x);
      const float depth_m = plane.depth_m(rays_.at(x, y));
      if (depth_m == 0.0F || is_open(pixel) || is_foreign(pixel, depth_m)) continue;
      const std::uint32_t at = color_pixel_of(pixel, depth_m);
      if (at != kNoPixel) model.add(color.data[at]);
    }
  }
  return model;
}

/// Keeps the open pixels that are connected with this one if they are many.
void PlaneCompletion::collect_hole(int x, int y) {
  const int width = history_.width(), height = history_.height();
  Hole hole;
  hole.pixels.push_back(static_cast<std::uint32_t>(y * width + x));
  visited_.at(x, y) = 1;
  for (std::size_t i = 0; i < hole.pixels.size(); ++i) {
    const int px = static_cast<int>(hole.pixels[i]) % width;
    const int py = static_cast<int>(hole.pixels[i]) / width;
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      const int nx = px + dx, ny = py + dy;
      if (nx < 0 || ny < 0 || nx >= width || ny >= height) continue;
      const auto next = static_cast<std::uint32_t>(ny * width + nx);
      if (!is_open(next)) {
        if (history_.data()[next].last_mm != 0) hole.border.push_back(next);
      } else if (visited_.data()[next] == 0) {
        visited_.data()[next] = 1;
        hole.pixels.push_back(next);
      }
    }
  }
  if (hole.pixels.size() >= kMinHole && hole.border.size() >= kMinBorder)
    holes_.push_back(std::move(hole));
}

/// The share of the hole's border that lies on the plane; 0 if something there is seen behind it:
/// the plane ends before the hole then.
float PlaneCompletion::support_of(const Plane& plane, const Hole& hole) const {
  float on = 0, behind = 0;
  for (const std::uint32_t pixel : hole.border) {
    const float depth_m = plane.depth_m(rays_.data()[pixel]);
    if (depth_m == 0.0F) continue;
    if (!is_foreign(pixel, depth_m)) {
      ++on;
    } else {
      behind += 0.001F * static_cast<float>(history_.data()[pixel].last_mm) > depth_m ? 1.0F : 0.0F;
    }
  }
  const auto all = static_cast<float>(hole.border.size());
  return behind > kMaxBehind * all ? 0.0F : on / all;
}

std::uint32_t PlaneCompletion::color_pixel_of(std::uint32_t pixel, float depth_m) const {
  if (calibration_.color_is_registered) return pixel;
  const Eigen::Vector2f& ray = rays_.data()[pixel];
  const Eigen::Vector3d point =
      Eigen::Vector3f(depth_m * ray.x(), depth_m * ray.y(), depth_m).cast<double>();
  const auto at = project(calibration_.color, calibration_.color_from_depth * point);
  if (!at) return kNoPixel;
  const auto x = static_cast<int>(std::lround(at->x())), y = static_cast<int>(std::lround(at->y()));
  if (x < 0 || y < 0 || x >= calibration_.color.width || y >= calibration_.color.height)
    return kNoPixel;
  return static_cast<std::uint32_t>(y * calibration_.color.width + x);
}

/// Whether a pixel looks at a plane rather than along it.
bool PlaneCompletion::faces(const Plane& plane, std::uint32_t pixel) const {
  constexpr float kMinFacing = 0.5F;  // cosine
  const Eigen::Vector2f& ray = rays_.data()[pixel];
  return std::abs(plane.normal.dot(Eigen::Vector3f(ray.x(), ray.y(), 1).normalized())) > kMinFacing;
}

void PlaneCompletion::plan_hole(const Hole& hole, const std::vector<ColorModel>& models,
                                ColorView color) {
  std::vector<float> support;
  for (const Plane& plane : planes_) support.push_back(support_of(plane, hole));
  const float least = std::max(kMinSupport, kOfBest * *std::ranges::max_element(support));
  for (const std::uint32_t pixel : hole.pixels) {
    float depth_m = farthest_m_;
    std::size_t nearest = planes_.size();
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      const float at_m = planes_[i].depth_m(rays_.data()[pixel]);
      if (support[i] < least || at_m < kNearest_m || at_m >= depth_m) continue;
      depth_m = at_m;
      nearest = i;
    }
    if (nearest == planes_.size() || is_foreign(pixel, depth_m)) continue;
    const std::uint32_t at = color_pixel_of(pixel, depth_m);
    if (at == kNoPixel) continue;
    const Rgb8& seen = color.data[at];
    if (calibration_.color_is_registered && is_black(seen)) continue;
    const bool is_pane = support[nearest] >= kPane && faces(planes_[nearest], pixel) &&
                         history_.data()[pixel].last_mm == 0;
    if (!is_pane && !models[nearest].knows(seen)) continue;
    fills_.push_back({pixel,
                      at,
                      static_cast<std::uint16_t>(std::lround(1000 * depth_m)),
                      {seen.r, seen.g, seen.b}});
  }
}

void PlaneCompletion::fill(DepthImage& depth_mm, ColorView color) {
  for (Fill& fill : fills_) {
    std::uint16_t& reading = depth_mm.data()[fill.pixel];
    if (reading != 0) continue;
    const Rgb8& now = color.data[fill.color_pixel];
    if (difference(now, fill.mean) > kMaxColorChange) continue;
    reading = fill.depth_mm;
    ++filled_;
  }
}

}  // namespace roomcast::sensor
