// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/measure/distance.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "roomcast/geometry/dense_solvers.h"
#include "roomcast/recording/export/depth_points.h"

namespace roomcast::recording {
namespace {

constexpr int kAround_px = 3;  // window half-size around a place, pixels
constexpr std::size_t kFewestAround = 6;
constexpr double kBias_m = 0.002, kBiasPerMetre = 0.002;  // not reduced by averaging

Error not_found(const std::string& what) {
  return {ErrorCode::kNotFound, what};
}

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  while (at < end) {
    double number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    if (next < end && (*next != ',' || next + 1 == end)) return {};
    at = next + (next < end ? 1 : 0);
  }
  return numbers;
}

/// The plane through the points around a place.
struct Surroundings {
  Eigen::Vector3d middle_m, normal;
  std::size_t count = 0;
};

/// Fits the points around `pixel` that belong to its surface: within one step of the median depth.
std::optional<Surroundings> surroundings_of(const StaticSensor& sensor,
                                            const Eigen::Vector2d& pixel) {
  const int cx = static_cast<int>(std::lround(pixel.x()));
  const int cy = static_cast<int>(std::lround(pixel.y()));
  std::vector<Eigen::Vector3d> points_m;
  for (int y = std::max(0, cy - kAround_px);
       y <= std::min(sensor.depth_mm.height() - 1, cy + kAround_px); ++y) {
    for (int x = std::max(0, cx - kAround_px);
         x <= std::min(sensor.depth_mm.width() - 1, cx + kAround_px); ++x) {
      const double z_m = 0.001 * sensor.depth_mm.at(x, y);
      const auto point_m = z_m > 0 ? unproject(sensor.depth, {x, y}, z_m) : std::nullopt;
      if (point_m) points_m.push_back(*point_m);
    }
  }
  if (points_m.size() < kFewestAround) return std::nullopt;
  const auto middle = points_m.begin() + static_cast<std::ptrdiff_t>(points_m.size() / 2);
  std::ranges::nth_element(points_m, middle, {}, [](const auto& p) { return p.z(); });
  const double z_m = middle->z();
  std::erase_if(points_m, [&](const auto& p) {
    return std::abs(p.z() - z_m) > largest_step_m(static_cast<float>(z_m));
  });
  Surroundings around{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), points_m.size()};
  for (const auto& p : points_m) around.middle_m += p / static_cast<double>(points_m.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& p : points_m)
    scatter += (p - around.middle_m) * (p - around.middle_m).transpose();
  around.normal = thinnest_direction(scatter);
  return around;
}

/// Intersects the ray of a pixel with the plane around it.
std::optional<Eigen::Vector3d> on_plane(const StaticSensor& sensor, const Eigen::Vector2d& pixel,
                                        const Surroundings& around) {
  const auto ray = unproject(sensor.depth, pixel, 1);
  if (!ray) return std::nullopt;
  const double slant = around.normal.dot(*ray);
  // At grazing incidence the intersection is ill-conditioned: use the centre's depth instead.
  if (std::abs(slant) < 0.2 * ray->norm()) return *ray * around.middle_m.z();
  return *ray * (around.normal.dot(around.middle_m) / slant);
}

double expected_error_m(const StaticSensor& sensor, double z_m, std::size_t readings) {
  const double noise = reading_sigma_m(static_cast<float>(z_m)) /
                       std::sqrt(static_cast<double>(readings * sensor.frame_count));
  const double bias = kBias_m + kBiasPerMetre * z_m;
  const double half_pixel = 0.5 * z_m / sensor.depth.fx;
  return std::sqrt(noise * noise + bias * bias + half_pixel * half_pixel);
}

std::optional<MeasuredPlace> place_at(const StaticSensor& sensor, const Eigen::Vector2d& pixel) {
  const auto around = surroundings_of(sensor, pixel);
  if (!around) return std::nullopt;
  const auto point_m = on_plane(sensor, pixel, *around);
  if (!point_m) return std::nullopt;
  return MeasuredPlace{sensor.world_from_depth * *point_m, sensor.name,
                       expected_error_m(sensor, point_m->z(), around->count)};
}

Result<MeasuredPlace> place_of_pixel(std::span<const StaticSensor> room,
                                     const PickedPlace& picked) {
  const auto sensor = std::ranges::find(room, picked.sensor, &StaticSensor::name);
  if (sensor == room.end()) {
    std::string names;
    for (const auto& known : room) names += (names.empty() ? "" : ", ") + known.name;
    return not_found("there is no placed sensor \"" + picked.sensor + "\"; there is " + names);
  }
  if (auto place = place_at(*sensor, picked.pixel)) return *place;
  return not_found("sensor " + picked.sensor + " has no depth at that pixel; choose one beside it");
}

/// Of the surfaces near a point, the one with the smallest expected error.
Result<MeasuredPlace> place_near(std::span<const StaticSensor> room,
                                 const Eigen::Vector3d& world_m) {
  std::optional<MeasuredPlace> best;
  for (const StaticSensor& sensor : room) {
    const auto pixel = project(sensor.depth, sensor.world_from_depth.inverse() * world_m);
    if (!pixel) continue;
    const auto place = place_at(sensor, *pixel);
    if (!place || (place->world_m - world_m).norm() > kNearSurface_m) continue;
    if (!best || place->expected_error_m < best->expected_error_m) best = place;
  }
  if (best) return *best;
  return not_found(
      "no sensor sees a surface within 5 cm of that point; choose a point on a surface");
}

}  // namespace

Result<PickedPlace> parse_place(const std::string& text) {
  PickedPlace place;
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) {
    const auto numbers = numbers_in(text);
    if (numbers.size() == 3) {
      place.world_m = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
      return place;
    }
  } else {
    const auto numbers = numbers_in(text.substr(colon + 1));
    place.sensor = text.substr(0, colon);
    if (numbers.size() == 2 && !place.sensor.empty()) {
      place.pixel = {numbers[0], numbers[1]};
      return place;
    }
  }
  return Error{ErrorCode::kInvalidArgument,
               "\"" + text + "\" is not a place; write SENSOR:x,y (a pixel) or x,y,z (metres)"};
}

Result<MeasuredPlace> measure_place(std::span<const StaticSensor> room, const PickedPlace& place) {
  return place.world_m ? place_near(room, *place.world_m) : place_of_pixel(room, place);
}

Result<MeasuredDistance> measure_distance(std::span<const StaticSensor> room,
                                          const PickedPlace& from, const PickedPlace& to) {
  const auto a = measure_place(room, from);
  if (!a) return a.error();
  const auto b = measure_place(room, to);
  if (!b) return b.error();
  MeasuredDistance measured{*a, *b, (a->world_m - b->world_m).norm(), 0, 0};
  double variance =
      a->expected_error_m * a->expected_error_m + b->expected_error_m * b->expected_error_m;
  if (a->sensor != b->sensor) {
    for (const StaticSensor& sensor : room) {
      const bool used = sensor.name == a->sensor || sensor.name == b->sensor;
      if (used) variance += sensor.expected_error_m * sensor.expected_error_m;
    }
  }
  for (const StaticSensor& sensor : room) {
    if (sensor.name == a->sensor) measured.by_scale_m = sensor.scale_error * measured.distance_m;
  }
  measured.expected_error_m = std::hypot(std::sqrt(variance), measured.by_scale_m);
  return measured;
}

}  // namespace roomcast::recording
