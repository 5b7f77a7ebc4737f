// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/depth_camera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "roomcast/simulator/people/moving_picture.h"
#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/sensing/depth_scale.h"
#include "roomcast/simulator/sensing/disparity_steps.h"
#include "roomcast/simulator/sensing/pattern_holes.h"
#include "roomcast/simulator/sensing/stereo_shadow.h"
#include "roomcast/simulator/sensing/unit_noise.h"

namespace roomcast::simulator {
namespace {

DepthImage rounded_mm(const Image<float>& z_m) {
  DepthImage depth_mm(z_m.width(), z_m.height());
  for (std::size_t i = 0; i < z_m.view().pixel_count(); ++i) {
    depth_mm.data()[i] = static_cast<std::uint16_t>(1000.0F * z_m.data()[i] + 0.5F);
  }
  return depth_mm;
}

template <class T>
void copy_into(const Image<T>& from, Image<T>& to) {
  if (from.width() != to.width() || from.height() != to.height())
    to.resize(from.width(), from.height());
  std::copy_n(from.data(), from.view().pixel_count(), to.data());
}

DepthBias bias_of(const SensorUnit& unit, bool noise) {
  return noise ? DepthBias(unit.profile, hash_of(unit.key, 4)) : DepthBias();
}

bool bounces_count(const SensorUnit& unit, bool noise) {
  return noise && unit.profile.principle == DepthPrinciple::kTimeOfFlight;
}

}  // namespace

DepthCamera::DepthCamera(const SimulatedRoom& room, const SensorUnit& unit,
                         const RigidTransform& world_from_depth, const SensingOptions& options,
                         const Workers& workers)
    : room_(room.room()),
      noise_(options.noise),
      depth_scale_(unit.depth_scale),
      patches_key_(hash_of(unit.key, 7)),
      camera_(unit.exact.depth, world_from_depth),
      fine_camera_(resampled(unit.exact.depth, 2.0), world_from_depth),
      plate_(trace_depth_plate(room_, room.rays(), camera_, fine_camera_,
                               bounces_count(unit, options.noise), workers)),
      still_mm_(rounded_mm(plate_.z_m)),
      sensing_(unit.profile, bias_of(unit, options.noise)),
      still_(expect_still().view()),
      interference_(options.interference_per_minute, hash_of(unit.key, 5)) {}

Image<ExpectedReading> DepthCamera::expect_still() const {
  Image<ExpectedReading> expected(camera_.width(), camera_.height());
  for (int y = 0; y < camera_.height(); ++y) {
    for (int x = 0; x < camera_.width(); ++x) {
      DepthReading reading{plate_.z_m.at(x, y),
                           plate_.facing.at(x, y),
                           plate_.infrared.at(x, y),
                           plate_.detour_m.at(x, y),
                           {}};
      std::array<FineSample, 4> samples;
      for (int i = 0; i < 4; ++i) {
        const int u = 2 * x + (i & 1), v = 2 * y + (i >> 1);
        samples[static_cast<std::size_t>(i)] = {plate_.fine_z_m.at(u, v),
                                                plate_.fine_strength.at(u, v)};
      }
      reading.other = other_surface(reading, samples);
      expected.at(x, y) = sensing_.expect(reading, x, y);
    }
  }
  return expected;
}

DepthCamera::Work DepthCamera::make_work() const {
  return {MovingLayer(camera_.width(), camera_.height()),
          MovingLayer(fine_camera_.width(), fine_camera_.height()),
          MovingOutline(camera_.width(), camera_.height()),
          {0, Image<float>(camera_.width(), camera_.height()), std::nullopt},
          still_mm_};
}

void DepthCamera::draw(const MovingThings& things, Work& work) const {
  work.layer.draw(things, camera_);
  if (noise_) {
    work.outline.find(work.layer, plate_.z_m);
    work.fine_layer.draw(things, fine_camera_, &work.outline.fine_tiles());
  }
  copy_into(still_mm_, work.clean_mm);
  put_moving_depth(work.layer, plate_, work.clean_mm.view());
}

void DepthCamera::mark_moving(const Work& work, MaskImage& moving) const {
  moving.resize(camera_.width(), camera_.height());
  const PixelBox& box = work.layer.box();
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x)
      moving.at(x, y) = is_in_front(work.layer, plate_.z_m, x, y) ? 255 : 0;
  }
}

bool DepthCamera::shows_moving(const Work& work, int x, int y) const {
  for (int i = 0; i < 4; ++i) {
    if (is_in_front(work.fine_layer, plate_.fine_z_m, 2 * x + (i & 1), 2 * y + (i >> 1)))
      return true;
  }
  return is_in_front(work.layer, plate_.z_m, x, y);
}

const Surface& DepthCamera::surface_at(const MovingThings& things, const MovingLayer& layer, int x,
                                       int y) const {
  return room_.surfaces[things.mesh().surface[layer.triangle().at(x, y)]];
}

FineSample DepthCamera::fine_sample(const MovingThings& things, const Work& work, int x,
                                    int y) const {
  if (!is_in_front(work.fine_layer, plate_.fine_z_m, x, y)) {
    return {plate_.fine_z_m.at(x, y), plate_.fine_strength.at(x, y)};
  }
  const float z_m = work.fine_layer.z_m().at(x, y);
  const float facing = facing_at(things, work.fine_layer, fine_camera_, x, y);
  const Surface& surface = surface_at(things, work.fine_layer, x, y);
  return {z_m, signal_strength(infrared_back(surface, facing), facing, z_m)};
}

DepthReading DepthCamera::centre_of(const MovingThings& things, const Work& work, int x,
                                    int y) const {
  if (!is_in_front(work.layer, plate_.z_m, x, y)) {
    return {plate_.z_m.at(x, y),
            plate_.facing.at(x, y),
            plate_.infrared.at(x, y),
            plate_.detour_m.at(x, y),
            {}};
  }
  const float facing = facing_at(things, work.layer, camera_, x, y);
  const Surface& surface = surface_at(things, work.layer, x, y);
  return {work.layer.z_m().at(x, y), facing, infrared_back(surface, facing), 0.0F, {}};
}

OtherSurface DepthCamera::beside(const DepthReading& centre, const MovingThings& things,
                                 const Work& work, int x, int y) const {
  std::array<FineSample, 4> samples;
  for (int i = 0; i < 4; ++i) {
    samples[static_cast<std::size_t>(i)] =
        fine_sample(things, work, 2 * x + (i & 1), 2 * y + (i >> 1));
  }
  return other_surface(centre, samples);
}

template <class Do>
void DepthCamera::for_each_moving(const Work& work, Do&& what) const {
  using Sees = MovingOutline::Sees;
  const PixelBox& box = work.outline.box();
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const Sees sees = work.outline.at(x, y);
      if (sees == Sees::kStill) continue;
      if (sees == Sees::kMaybeBoth && !shows_moving(work, x, y)) continue;
      what(x, y, sees);
    }
  }
}

void DepthCamera::read_moving(const MovingThings& things, Work& work,
                              ImageView<std::uint16_t> out) const {
  for_each_moving(work, [&](int x, int y, MovingOutline::Sees sees) {
    DepthReading reading = centre_of(things, work, x, y);
    if (sees == MovingOutline::Sees::kMaybeBoth)
      reading.other = beside(reading, things, work, x, y);
    out.at(x, y) = sensing_.read(sensing_.expect(reading, x, y), x, y, work.noise);
  });
}

void DepthCamera::expect(const MovingThings& things, const Work& work, DepthImage& depth_mm) const {
  copy_into(work.clean_mm, depth_mm);
  if (!noise_) return;
  still_.expect(depth_mm.view());
  for_each_moving(work, [&](int x, int y, MovingOutline::Sees) {
    depth_mm.at(x, y) = sensing_.expect(centre_of(things, work, x, y), x, y).rounded_mm();
  });
  if (depth_scale_ != 1.0) apply_depth_scale(depth_scale_, depth_mm.view());
}

void DepthCamera::read(const MovingThings& things, std::uint32_t key, nanoseconds scene_time,
                       Work& work, DepthImage& depth_mm) const {
  copy_into(work.clean_mm, depth_mm);
  if (!noise_) return;
  const SensorProfile& profile = sensing_.profile();
  work.noise.key = key;
  work.noise.burst = interference_.at(scene_time);
  fill_unit_noise(profile.principle, key, gaussians_, work.noise.unit.view());
  still_.read(sensing_, work.noise, depth_mm.view());
  read_moving(things, work, depth_mm.view());
  finish(work, scene_time, depth_mm.view());
}

void DepthCamera::finish(const Work& work, nanoseconds scene_time,
                         ImageView<std::uint16_t> depth_mm) const {
  const SensorProfile& profile = sensing_.profile();
  const auto focal_px = static_cast<float>(profile.nominal.depth.fx);
  if (profile.principle == DepthPrinciple::kStructuredLight)
    match_by_patches(patches_key_, depth_mm);
  others_.disturb(work.noise.key, scene_time, gaussians_, depth_mm);
  if (measures_disparity(profile.principle))
    take_stereo_shadow(work.clean_mm, focal_px, profile.baseline_mm, depth_mm);
  if (profile.disparity_step_px > 0.0F)
    round_to_disparity_steps({focal_px, profile.baseline_mm, profile.disparity_step_px}, depth_mm);
  if (depth_scale_ != 1.0) apply_depth_scale(depth_scale_, depth_mm);
}

}  // namespace roomcast::simulator
