// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/depth_sensing.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/scene/surface.h"
#include "roomcast/simulator/sensing/axial_noise.h"
#include "roomcast/simulator/sensing/unit_noise.h"

namespace roomcast::simulator {
namespace {

constexpr int kSide = 64;
constexpr int kFrames = 40;

struct Readings {
  double mean_mm = 0, sigma_mm = 0, missing = 0;
};

/// Successive frames of a wall that looks the same to every pixel.
class Wall {
 public:
  Wall(CameraModel model, const DepthReading& reading)
      : sensing_(profile_of(model, false), DepthBias()),
        expected_(kSide, kSide, sensing_.expect(reading, 0, 0)),
        still_(expected_.view()) {
    noise_.unit.resize(kSide, kSide);
  }

  const DepthImage& read(int frame) {
    noise_.key = hash_of(77, static_cast<std::uint32_t>(frame));
    fill_unit_noise(sensing_.profile().principle, noise_.key, gaussians_, noise_.unit.view());
    picture_.resize(kSide, kSide);
    still_.read(sensing_, noise_, picture_.view());
    return picture_;
  }

  Readings statistics() {
    double sum = 0, squares = 0, count = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
      const DepthImage& picture = read(frame);
      for (std::size_t i = 0; i < picture.view().pixel_count(); ++i) {
        const double value = picture.data()[i];
        if (value == 0) continue;
        sum += value;
        squares += value * value;
        ++count;
      }
    }
    const double mean = sum / count;
    return {mean, std::sqrt(squares / count - mean * mean),
            1.0 - count / (double{kSide} * kSide * kFrames)};
  }

  void disturb(const InterferenceBurst& burst) { noise_.burst = burst; }

 private:
  GaussianTable gaussians_;
  DepthSensing sensing_;
  Image<ExpectedReading> expected_;
  StillDepth still_;
  FrameNoise noise_;
  DepthImage picture_;
};

DepthReading wall_at(float z_m, float theta = 0.0F, float infrared = kReferenceReflectance) {
  return {z_m, std::cos(theta), infrared, 0.0F, {}};
}

/// The standard deviation after rounding to whole millimetres.
double with_rounding(double sigma_mm) {
  return std::sqrt(sigma_mm * sigma_mm + 1.0 / 12.0);
}

TEST(DepthSensing, noise_of_a_flat_wall_follows_the_published_formula_over_range) {
  for (const float z : {0.8F, 1.5F, 2.5F, 3.5F, 4.5F}) {
    EXPECT_NEAR(Wall(CameraModel::kKinect2, wall_at(z)).statistics().sigma_mm,
                with_rounding(kinect2_sigma_mm(z, 0)), 0.05 * kinect2_sigma_mm(z, 0));
    EXPECT_NEAR(Wall(CameraModel::kAzure, wall_at(z)).statistics().sigma_mm,
                with_rounding(azure_sigma_mm(z, 0)), 0.05 * azure_sigma_mm(z, 0));
    const double stereo = stereo_sigma_mm(z, 424.0F, 50.0F, 0.08F);
    EXPECT_NEAR(Wall(CameraModel::kD435, wall_at(z)).statistics().sigma_mm, with_rounding(stereo),
                0.05 * stereo);
  }
}

TEST(DepthSensing, noise_of_a_flat_wall_follows_the_published_formula_over_slant) {
  for (const float theta : {0.3F, 0.7F, 1.1F}) {
    const double published = kinect2_sigma_mm(2.0F, theta);
    EXPECT_NEAR(Wall(CameraModel::kKinect2, wall_at(2.0F, theta)).statistics().sigma_mm,
                with_rounding(published), 0.05 * published);
  }
}

TEST(DepthSensing, readings_of_a_wall_are_right_on_average_and_all_there) {
  const Readings readings = Wall(CameraModel::kKinect2, wall_at(3.0F)).statistics();
  EXPECT_NEAR(readings.mean_mm, 3000.0, 5.0 * readings.sigma_mm / (kSide * std::sqrt(kFrames)));
  EXPECT_EQ(readings.missing, 0.0);
}

TEST(DepthSensing, dark_surfaces_are_noisier_for_time_of_flight) {
  const double bright = Wall(CameraModel::kKinect2, wall_at(1.5F)).statistics().sigma_mm;
  const double dark =
      Wall(CameraModel::kKinect2, wall_at(1.5F, 0.0F, 0.125F)).statistics().sigma_mm;
  EXPECT_NEAR(dark / bright, 2.0, 0.1);  // a quarter of the light
}

TEST(DepthSensing, glass_over_black_is_lost_head_on_and_aslant_and_matt_surfaces_are_not) {
  const Surface matt = painted(Pattern::kPlain, 0x101114, 0, 0, 1, 0.5F);
  Surface screen = glazed(matt);
  screen.infrared = 0.015F;
  const DepthSensing sensing(profile_of(CameraModel::kKinect2, false), DepthBias());
  const auto lost = [&](const Surface& surface, float theta) {
    const float facing = std::cos(theta);
    return sensing.dropout_probability(wall_at(1.8F, theta, infrared_back(surface, facing)));
  };
  EXPECT_EQ(lost(screen, 0.0F), 1.0F);   // mirrors the emitter: the pixel saturates
  EXPECT_EQ(lost(screen, 0.02F), 0.0F);  // the rim of the highlight
  EXPECT_GT(lost(screen, 0.3F), 0.2F);   // mirrors the light away
  for (const float theta : {0.0F, 0.02F, 0.3F, 1.0F}) EXPECT_EQ(lost(matt, theta), 0.0F);
  // A picture behind glass gives no reading at normal incidence only.
  EXPECT_EQ(lost(glazed(matt), 0.0F), 1.0F);
  EXPECT_EQ(lost(glazed(matt), 0.3F), 0.0F);
}

TEST(DepthSensing, weak_signals_flicker_and_nothing_is_read_where_none_can_be) {
  const DepthSensing sensing(profile_of(CameraModel::kKinect2, false), DepthBias());
  const DepthReading weak = wall_at(3.0F, 0.0F, 0.004F * 9.0F);
  EXPECT_NEAR(sensing.dropout_probability(weak), 0.5, 1e-3);
  EXPECT_NEAR(Wall(CameraModel::kKinect2, weak).statistics().missing, 0.5,
              4.0 * 0.5 / (kSide * std::sqrt(kFrames)));
  EXPECT_EQ(sensing.dropout_probability(wall_at(2.0F, 1.47F)), 1.0F);
  EXPECT_EQ(sensing.dropout_probability(wall_at(0.4F)), 1.0F);
  EXPECT_EQ(sensing.dropout_probability(wall_at(8.5F, 0.0F, 5.0F)), 1.0F);
  EXPECT_EQ(sensing.dropout_probability(wall_at(2.0F, 0.0F, 0.0F)), 1.0F);
  EXPECT_EQ(sensing.dropout_probability(wall_at(2.0F)), 0.0F);
}

TEST(DepthSensing, light_that_went_a_longer_way_makes_the_wall_appear_further) {
  DepthReading corner = wall_at(2.0F);
  corner.detour_m = 0.02F;
  EXPECT_NEAR(Wall(CameraModel::kKinect2, corner).statistics().mean_mm, 2020.0, 0.2);
}

struct AtEdge {
  double lost = 0, between = 0, near = 0, far = 0;
};

AtEdge fates(CameraModel model, float share) {
  DepthReading edge = wall_at(2.0F);
  edge.other = {share, 3.0F, 0.5F};
  Wall wall(model, edge);
  AtEdge fates;
  for (int frame = 0; frame < kFrames; ++frame) {
    const DepthImage& picture = wall.read(frame);
    for (std::size_t i = 0; i < picture.view().pixel_count(); ++i) {
      const int value = picture.data()[i];
      ++(value == 0     ? fates.lost
         : value < 2100 ? fates.near
         : value > 2850 ? fates.far
                        : fates.between);
    }
  }
  const double all = double{kSide} * kSide * kFrames;
  return {fates.lost / all, fates.between / all, fates.near / all, fates.far / all};
}

TEST(DepthSensing, time_of_flight_mixes_the_two_surfaces_of_an_edge) {
  const AtEdge half = fates(CameraModel::kKinect2, 0.5F);
  // The lateral noise is 1.6 mm at 5.5 mm per pixel: off the edge in 9 % of the readings.
  EXPECT_NEAR(half.lost, 0.45 * 0.91, 0.02);
  EXPECT_GT(half.between, 0.40);
  const AtEdge sliver = fates(CameraModel::kKinect2, 0.25F);
  EXPECT_GT(sliver.near, half.near);  // the lateral noise sometimes moves the sample off the edge
}

TEST(DepthSensing, stereo_takes_one_surface_of_an_edge) {
  const AtEdge sliver = fates(CameraModel::kD435, 0.25F);
  // 2 mm at 4.7 mm per pixel: off the edge in 28 % on this side, in 4 % on the other.
  EXPECT_NEAR(sliver.lost, 0.30 * 0.68, 0.02);
  EXPECT_GT(sliver.near, 0.55);
  EXPECT_LT(sliver.between, 0.02);
}

TEST(DepthSensing, a_burst_of_interference_multiplies_the_noise) {
  Wall wall(CameraModel::kKinect2, wall_at(3.0F));
  const double calm = wall.statistics().sigma_mm;
  InterferenceBurst burst;
  burst.strength = 1.0F;
  wall.disturb(burst);
  EXPECT_GT(wall.statistics().sigma_mm, 2.5 * calm);
}

TEST(DepthSensing, the_same_key_gives_the_same_reading_alone_and_in_the_picture) {
  const DepthSensing sensing(profile_of(CameraModel::kKinect2, false), DepthBias());
  DepthReading edge = wall_at(2.0F);
  edge.other = {0.5F, 3.0F, 1.0F};
  const Image<ExpectedReading> expected(kSide, kSide, sensing.expect(edge, 0, 0));
  FrameNoise noise;
  noise.key = 5;
  noise.unit.resize(kSide, kSide);
  fill_unit_noise(DepthPrinciple::kTimeOfFlight, 5, GaussianTable(), noise.unit.view());
  DepthImage picture(kSide, kSide);
  StillDepth(expected.view()).read(sensing, noise, picture.view());
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x)
      EXPECT_EQ(picture.at(x, y), sensing.read(expected.at(x, y), x, y, noise));
  }
}

}  // namespace
}  // namespace roomcast::simulator
