// SPDX-License-Identifier: Apache-2.0
// Quality of live depth: no worse than the sensor on static, moving and slowly moving surfaces, no
// change shown late, no reading off by more than the bound. Simulated scenes.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/codec/live/live_depth_encoder.h"
#include "roomcast/codec/live/surface_coder.h"
#include "roomcast/codec/payload/layer_schedule.h"
#include "roomcast/codec/testing/rough_sensor.h"
#include "roomcast/codec/testing/synthetic_motion.h"

namespace roomcast::codec {
namespace {

/// Root mean square errors over pixels that are off by 20 mm at most, as everywhere in the project.
struct ErrorRatio {
  double shown = 0, raw = 0;
  [[nodiscard]] double value() const { return std::sqrt(shown / raw); }
};

using Counts = std::function<bool(const DepthImage& truth, const DepthImage& before, int x, int y)>;

/// Error of the shown picture against the truth, relative to the sensor's own, over the pixels
/// selected by `counts`.
double error_ratio(const SyntheticMotion& scene, int frames, const Counts& counts) {
  constexpr int kOutlier_mm = 20, kSettled = 20;
  LiveDepthEncoder encoder({scene.width, scene.height});
  LayerSchedule schedule(2, 120);
  ErrorRatio ratio;
  for (int i = 0; i < frames; ++i) {
    std::vector<std::uint8_t> bytes;
    const DepthImage reading = scene.reading(i);
    encoder.encode(reading, schedule.next(false), bytes);
    if (i < kSettled) continue;
    const DepthImage truth = scene.truth(i), before = scene.truth(i - 1);
    for (int y = 0; y < scene.height; ++y) {
      for (int x = 0; x < scene.width; ++x) {
        const int raw = std::abs(reading.at(x, y) - truth.at(x, y));
        const int shown = std::abs(encoder.shown_mm().at(x, y) - truth.at(x, y));
        if (raw > kOutlier_mm || shown > kOutlier_mm || !counts(truth, before, x, y)) continue;
        ratio.raw += raw * raw;
        ratio.shown += shown * shown;
      }
    }
  }
  return ratio.value();
}

TEST(LiveQuality, static_surfaces_are_better_than_the_sensors_readings) {
  const auto still = [](const DepthImage& truth, const DepthImage& before, int x, int y) {
    return truth.at(x, y) == before.at(x, y);
  };
  EXPECT_LT(error_ratio({}, 60, still), 0.6);
}

TEST(LiveQuality, noise_that_neighbours_share_is_neither_shown_nor_sent) {
  constexpr int kFrames = 90, kLearnt = 45;
  RoughSensor sensor;
  const DepthImage truth = sensor.truth();
  LiveDepthEncoder encoder({sensor.width, sensor.height});
  LayerSchedule schedule(2, 1000);
  ErrorRatio ratio;
  std::size_t sent = 0;
  for (int i = 0; i < kFrames; ++i) {
    std::vector<std::uint8_t> bytes;
    const DepthImage reading = sensor.reading();
    encoder.encode(reading, schedule.next(false), bytes);
    if (i < kLearnt) continue;
    sent += bytes.size();
    for (std::size_t k = 0; k < truth.view().pixel_count(); ++k) {
      const int raw = reading.data()[k] - truth.data()[k];
      const int shown = encoder.shown_mm().data[k] - truth.data()[k];
      ratio.raw += raw * raw;
      ratio.shown += shown * shown;
    }
  }
  EXPECT_LT(ratio.value(), 0.6);
  EXPECT_LT(sent / (kFrames - kLearnt), 600u);
}

TEST(LiveQuality, moving_surfaces_are_no_worse_than_the_sensors_readings) {
  const auto moves = [](const DepthImage& truth, const DepthImage& before, int x, int y) {
    return std::abs(truth.at(x, y) - before.at(x, y)) > 1;
  };
  EXPECT_LT(error_ratio({}, 40, moves), 1.0);
}

TEST(LiveQuality, a_slowly_approaching_surface_is_followed) {
  SyntheticMotion scene;
  scene.ball_speed = 0;
  scene.ball_approach_mm = 0.4;  // per frame: far less than the noise
  const auto ball = [](const DepthImage& truth, const DepthImage&, int x, int y) {
    // Not the rim, where a pixel's depth is ambiguous.
    return truth.at(x, y) < 1700 && std::abs(truth.at(x + 1, y) - truth.at(x, y)) < 8;
  };
  EXPECT_LT(error_ratio(scene, 80, ball), 1.0);
}

TEST(LiveQuality, a_change_of_any_size_is_shown_within_half_a_second) {
  constexpr int kHalfSecond = 15, kLearnt = 40;
  for (const int side : {1, 2, 3, 8, 20}) {
    LiveDepthEncoder encoder({128, 96});
    LayerSchedule schedule(2, 1000);
    DepthImage room = SyntheticMotion{.ball_speed = 0, .noise = false}.truth(0);
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < kLearnt; ++i) encoder.encode(room, schedule.next(false), bytes);
    for (int y = 70; y < 70 + side; ++y) {
      for (int x = 60; x < 60 + side; ++x) room.at(x, y) = 2000;
    }
    // An isolated pixel would be dropped as a flying one: give it a neighbourhood.
    if (side == 1) {
      room.at(61, 70) = room.at(60, 71) = 2000;
    }
    int frames = 0;
    while (frames < 60 && std::abs(encoder.shown_mm().at(60, 70) - 2000) > 20) {
      encoder.encode(room, schedule.next(false), bytes);
      ++frames;
    }
    EXPECT_LE(frames, kHalfSecond) << "a square of " << side << " pixels";
  }
}

TEST(LiveQuality, a_vanished_surface_is_gone_within_half_a_second) {
  constexpr int kHalfSecond = 15;
  LiveDepthEncoder encoder({128, 96});
  LayerSchedule schedule(2, 1000);
  DepthImage room = SyntheticMotion{.ball_speed = 0, .noise = false}.truth(0);
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 40; ++i) encoder.encode(room, schedule.next(false), bytes);
  for (int y = 60; y < 80; ++y) {
    for (int x = 60; x < 80; ++x) room.at(x, y) = 0;
  }
  for (int i = 0; i < kHalfSecond; ++i) encoder.encode(room, schedule.next(false), bytes);
  for (int y = 62; y < 78; ++y) {
    for (int x = 62; x < 78; ++x) ASSERT_EQ(encoder.shown_mm().at(x, y), 0) << x << "," << y;
  }
}

/// A thing of 20 x 20 pixels goes, somebody passes before its place, and then a key frame is
/// encoded. Returns the depth that this key frame shows. `behind_mm`: the reading of the surface
/// behind the thing, in every fourth frame; 0: it gives none.
DepthImage shown_where_a_thing_has_gone(std::uint16_t behind_mm) {
  constexpr FrameRole kKey{true, 0}, kOther{false, 0};
  constexpr std::uint16_t kThing_mm = 3000, kSomebody_mm = 1000;
  DepthImage room(128, 96);
  std::ranges::fill_n(room.data(), room.view().pixel_count(), std::uint16_t{5000});
  LiveDepthEncoder encoder({room.width(), room.height()});
  std::vector<std::uint8_t> bytes;
  const auto encode = [&](FrameRole role, std::uint16_t reading_mm) {
    for (int y = 60; y < 80; ++y) {
      for (int x = 60; x < 80; ++x) room.at(x, y) = reading_mm;
    }
    encoder.encode(room, role, bytes);
  };
  encode(kKey, kThing_mm);
  for (int i = 0; i < 30; ++i) encode(kOther, kThing_mm);
  for (int i = 1; i <= 12; ++i) encode(kOther, i % 4 == 0 ? behind_mm : std::uint16_t{0});
  encode(kKey, 0);
  for (int i = 0; i < 5; ++i) encode(kOther, kSomebody_mm);
  encode(kKey, 0);
  for (int y = 0; y < room.height(); ++y)
    std::copy_n(encoder.shown_mm().row(y), room.width(), room.view().row(y));
  return room;
}

TEST(LiveQuality, a_key_frame_does_not_bring_back_what_has_gone) {
  for (const int behind_mm : {0, 5000}) {
    const DepthImage shown = shown_where_a_thing_has_gone(static_cast<std::uint16_t>(behind_mm));
    for (int y = 62; y < 78; ++y) {
      for (int x = 62; x < 78; ++x)
        ASSERT_GT(std::abs(shown.at(x, y) - 3000), 200) << x << "," << y << " of " << behind_mm;
    }
  }
}

TEST(LiveQuality, a_reading_that_is_lost_for_a_moment_is_kept) {
  LiveDepthEncoder encoder({128, 96});
  LayerSchedule schedule(1, 1000);
  const DepthImage room = SyntheticMotion{.ball_speed = 0, .noise = false}.truth(0);
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 10; ++i) encoder.encode(room, schedule.next(false), bytes);
  DepthImage holed = room;
  holed.at(70, 70) = holed.at(71, 70) = 0;
  encoder.encode(holed, schedule.next(false), bytes);
  EXPECT_NE(encoder.shown_mm().at(70, 70), 0);
}

// In any scene: after half a second without change, every reading that is no flying pixel is within
// the bound.
TEST(LiveQuality, no_reading_is_off_by_more_than_the_bound) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 4; ++trial) {
    DepthImage room(96, 80);
    for (int y = 0; y < 80; ++y) {
      for (int x = 0; x < 96; ++x) {
        const int patch = (x / (2 + trial)) * 7919 + (y / (2 + trial)) * 104729;
        room.at(x, y) = static_cast<std::uint16_t>(700 + patch % 5000 + random() % 3);
      }
    }
    LiveDepthEncoder encoder({96, 80});
    LayerSchedule schedule(2, 1000);
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 32; ++i) encoder.encode(room, schedule.next(false), bytes);
    const DepthDomain& domain = encoder.state().domain;
    for (int y = 2; y < 78; ++y) {
      for (int x = 2; x < 94; ++x) {
        const int reading = domain.level_of(room.at(x, y));
        const int shown = encoder.state().picture[static_cast<std::size_t>(y * 96 + x)];
        int support = 0;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            support += std::abs(domain.level_of(room.at(x + dx, y + dy)) - reading) < 32;
          }
        }
        if (support < 4) continue;
        ASSERT_LE(std::abs(shown - reading), kErrorBound) << x << "," << y << " of " << trial;
      }
    }
  }
}

}  // namespace
}  // namespace roomcast::codec
