// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/tracing/static_plate.h"

#include <array>
#include <cmath>
#include <cstdlib>

#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/sensing/depth_reading.h"
#include "roomcast/simulator/tracing/light_map.h"
#include "roomcast/simulator/tracing/multipath.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

/// Computes the light that reaches the camera along rays.
class ColorTracer {
 public:
  ColorTracer(const Room& room, const RayScene& scene, const PlacedCamera& camera,
              const Workers& workers)
      : room_(room), scene_(scene), camera_(camera), lights_(room, scene, camera, workers) {}

  struct Sample {
    Vector3f light = Vector3f::Zero();
    float z_m = 0.0F;
  };

  /// Samples pixel (x, y) plus `offset` pixels.
  [[nodiscard]] Sample sample(int x, int y, const Vector2f& offset, std::uint32_t dither) const {
    const Vector3f direction =
        camera_.direction(camera_.ray(x, y) + camera_.pixel_angle() * offset);
    const auto hit = scene_.first_hit(camera_.eye_m(), direction);
    if (!hit) return {};
    const Surface& surface = room_.surfaces[room_.mesh.surface[hit->triangle]];
    const LitPoint at{camera_.eye_m() + hit->t * direction, hit->normal};
    const float slant = std::max(0.15F, -hit->normal.dot(direction.normalized()));
    const Vector3f albedo = albedo_at(surface, hit->uv_m, hit->t * camera_.pixel_angle() / slant);
    if (surface.glow >= 1.0F) return {albedo, hit->t};
    return {light_leaving(surface, albedo, lights_.arriving(x, y, at, dither)), hit->t};
  }

 private:
  const Room& room_;
  const RayScene& scene_;
  const PlacedCamera& camera_;
  LightMap lights_;
};

Rgb8 rounded(const Vector3f& srgb) {
  const auto byte = [](float value) { return static_cast<std::uint8_t>(value + 0.5F); };
  return {byte(srgb.x()), byte(srgb.y()), byte(srgb.z())};
}

int contrast(const Rgb8& a, const Rgb8& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

bool has_contrast(ColorView picture, int x, int y) {
  constexpr int kVisible = 14;  // grey levels
  const Rgb8 here = picture.at(x, y);
  return (x > 0 && contrast(here, picture.at(x - 1, y)) > kVisible) ||
         (y > 0 && contrast(here, picture.at(x, y - 1)) > kVisible) ||
         (x + 1 < picture.width && contrast(here, picture.at(x + 1, y)) > kVisible) ||
         (y + 1 < picture.height && contrast(here, picture.at(x, y + 1)) > kVisible);
}

std::uint32_t dither_of(int x, int y, std::uint32_t sample) {
  return hash_of(hash_of(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)), sample);
}

/// Mean of samples spread over the pixel: a rotated grid.
Rgb8 smooth_pixel(const ColorTracer& tracer, int x, int y) {
  const std::array<Vector2f, 4> spread = {Vector2f(-0.125F, -0.375F), Vector2f(0.375F, -0.125F),
                                          Vector2f(-0.375F, 0.125F), Vector2f(0.125F, 0.375F)};
  Vector3f sum = Vector3f::Zero();
  std::uint32_t number = 1;
  for (const Vector2f& offset : spread) {
    sum += srgb_from_linear(tracer.sample(x, y, offset, dither_of(x, y, number++)).light);
  }
  return rounded(sum / static_cast<float>(spread.size()));
}

/// The surface at the centre of a depth pixel; z 0: none.
struct StillPoint {
  float z_m = 0, facing = 1, infrared = 0;
};

StillPoint still_point(const Room& room, const RayScene& scene, const PlacedCamera& camera, int x,
                       int y) {
  const Vector3f direction = camera.direction(x, y);
  const auto hit = scene.first_hit(camera.eye_m(), direction);
  if (!hit) return {};
  const float facing = -hit->normal.dot(direction.normalized());
  return {hit->t, facing,
          infrared_back(room.surfaces[room.mesh.surface[hit->triangle]], std::max(0.0F, facing))};
}

void trace_fine_samples(const Room& room, const RayScene& scene, const PlacedCamera& fine,
                        const Workers& workers, DepthPlate& plate) {
  plate.fine_z_m.resize(fine.width(), fine.height());
  plate.fine_strength.resize(fine.width(), fine.height());
  for_each_row(fine.height(), workers, [&](int y) {
    for (int x = 0; x < fine.width(); ++x) {
      const StillPoint point = still_point(room, scene, fine, x, y);
      plate.fine_z_m.at(x, y) = point.z_m;
      plate.fine_strength.at(x, y) = signal_strength(point.infrared, point.facing, point.z_m);
    }
  });
}

}  // namespace

DepthPlate trace_depth_plate(const Room& room, const RayScene& scene, const PlacedCamera& camera,
                             const PlacedCamera& fine, bool multipath, const Workers& workers) {
  const int width = camera.width();
  const int height = camera.height();
  DepthPlate plate;
  for (Image<float>* layer : {&plate.z_m, &plate.facing, &plate.infrared, &plate.detour_m})
    layer->resize(width, height);
  for_each_row(height, workers, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const StillPoint point = still_point(room, scene, camera, x, y);
      plate.z_m.at(x, y) = point.z_m;
      plate.facing.at(x, y) = point.facing;
      plate.infrared.at(x, y) = point.infrared;
    }
  });
  trace_fine_samples(room, scene, fine, workers, plate);
  if (multipath) plate.detour_m = trace_detours(room, scene, camera, plate.z_m.view(), workers);
  return plate;
}

ColorPlate trace_color_plate(const Room& room, const RayScene& scene, const PlacedCamera& camera,
                             const Workers& workers) {
  const int width = camera.width();
  const int height = camera.height();
  const ColorTracer tracer(room, scene, camera, workers);
  ColorPlate plate{Image<float>(width, height), ColorImage(width, height)};
  ColorImage first(width, height);
  for_each_row(height, workers, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const auto sample = tracer.sample(x, y, Vector2f::Zero(), dither_of(x, y, 0));
      plate.z_m.at(x, y) = sample.z_m;
      first.at(x, y) = rounded(srgb_from_linear(sample.light));
    }
  });
  for_each_row(height, workers, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const bool rough = has_contrast(first.view(), x, y);
      plate.color.at(x, y) = rough ? smooth_pixel(tracer, x, y) : first.at(x, y);
    }
  });
  return plate;
}

CameraIntrinsics resampled(CameraIntrinsics camera, double factor) {
  camera.width = static_cast<int>(std::lround(camera.width * factor));
  camera.height = static_cast<int>(std::lround(camera.height * factor));
  camera.fx *= factor;
  camera.fy *= factor;
  camera.cx = (camera.cx + 0.5) * factor - 0.5;  // pixel centres are at integer coordinates
  camera.cy = (camera.cy + 0.5) * factor - 0.5;
  return camera;
}

}  // namespace roomcast::simulator
