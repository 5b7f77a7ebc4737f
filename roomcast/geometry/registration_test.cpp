// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/registration.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/geometry/registration_reference.h"

namespace roomcast {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr Rgb8 kRed{230, 20, 20};
constexpr Rgb8 kGreen{20, 230, 20};

/// Like a Kinect v2 with an eighth of its pixels and no lens distortion, so that expected values
/// can be computed by hand.
SensorCalibration small_kinect() {
  SensorCalibration calibration;
  calibration.depth = {180, 150, 130, 130, 89.5, 74.5};
  calibration.color = {640, 360, 355, 355, 319.5, 179.5};
  calibration.color_from_depth.translation_m = Vector3d(-0.052, 0, 0);
  return calibration;
}

SensorCalibration distorted_kinect() {
  SensorCalibration calibration = small_kinect();
  calibration.depth.k1 = 0.0868;
  calibration.depth.k2 = -0.2606;
  calibration.depth.k3 = 0.1003;
  calibration.color.k1 = 0.0179;
  calibration.color.k2 = -0.0332;
  calibration.color.p1 = 0.0004;
  calibration.color_from_depth.rotation =
      Eigen::AngleAxisd(0.01, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  calibration.color_from_depth.translation_m = Vector3d(-0.052, 0.002, -0.001);
  return calibration;
}

/// A background plane at z = far_m and a square card in front of it, both facing the depth camera.
struct CardScene {
  double near_m = 1.0, far_m = 3.0, half_side_m = 0.2;

  [[nodiscard]] bool hits_card(const Vector3d& origin, const Vector3d& ray) const {
    const Vector3d at = origin + ray * ((near_m - origin.z()) / ray.z());
    return std::abs(at.x()) <= half_side_m && std::abs(at.y()) <= half_side_m;
  }
  /// Renders the ray through each pixel of a camera, traced in the depth camera's frame.
  template <class T>
  void render(const CameraIntrinsics& camera, const RigidTransform& depth_from_camera, T& image,
              const std::function<typename std::remove_reference_t<decltype(image.at(0, 0))>(bool)>&
                  value) const {
    for (int v = 0; v < camera.height; ++v) {
      for (int u = 0; u < camera.width; ++u) {
        const auto ray = unproject(camera, Vector2d(u, v), 1);
        ASSERT_TRUE(ray);
        image.at(u, v) =
            value(hits_card(depth_from_camera.translation_m, depth_from_camera.rotation * *ray));
      }
    }
  }
  [[nodiscard]] DepthImage depth_mm(const SensorCalibration& calibration) const {
    DepthImage image(calibration.depth.width, calibration.depth.height);
    render(calibration.depth, {}, image, [this](bool card) {
      return static_cast<std::uint16_t>(1000 * (card ? near_m : far_m));
    });
    return image;
  }
  [[nodiscard]] ColorImage color(const SensorCalibration& calibration) const {
    ColorImage image(calibration.color.width, calibration.color.height);
    render(calibration.color, calibration.color_from_depth.inverse(), image,
           [](bool card) { return card ? kRed : kGreen; });
    return image;
  }
};

RegisteredColor register_or_die(const SensorCalibration& calibration, DepthView depth,
                                ColorView color) {
  auto registration = Registration::create(calibration);
  EXPECT_TRUE(registration.ok());
  RegisteredColor out;
  EXPECT_TRUE(registration->run(depth, color, out).ok());
  return out;
}

TEST(Registration, background_beside_an_object_never_takes_the_colour_of_the_object) {
  for (const SensorCalibration& calibration : {small_kinect(), distorted_kinect()}) {
    const CardScene scene;
    const DepthImage depth = scene.depth_mm(calibration);
    const RegisteredColor out = register_or_die(calibration, depth, scene.color(calibration));
    int seen = 0;
    for (int y = 0; y < depth.height(); ++y) {
      for (int x = 0; x < depth.width(); ++x) {
        if (depth.at(x, y) != 3000 || out.seen.at(x, y) == 0) continue;
        ++seen;
        ASSERT_LE(out.color.at(x, y).r, kGreen.r + 2) << x << ',' << y;
      }
    }
    EXPECT_GT(seen, 10000);
  }
}

TEST(Registration, background_hidden_from_the_colour_camera_is_not_seen) {
  const SensorCalibration calibration = small_kinect();
  const CardScene scene;
  const DepthImage depth = scene.depth_mm(calibration);
  const RegisteredColor out = register_or_die(calibration, depth, scene.color(calibration));
  // The colour camera is 52 mm to the right, so the card's left side hides background that the
  // depth camera sees: 52 mm * (3 - 1) of shift at 3 m is 130 px * 0.104 / 3 = 4.5 depth pixels.
  int hidden = 0;
  for (int x = 0; x < depth.width(); ++x) {
    const bool background = depth.at(x, 75) == 3000;
    if (background && out.seen.at(x, 75) == 0) ++hidden;
  }
  EXPECT_GE(hidden, 4);
  EXPECT_LE(hidden, 4 + 2 * 4);  // the grid's reach on both sides of the card
}

TEST(Registration, an_object_keeps_its_own_colour_up_to_its_edge) {
  const SensorCalibration calibration = small_kinect();
  const CardScene scene;
  const DepthImage depth = scene.depth_mm(calibration);
  const RegisteredColor out = register_or_die(calibration, depth, scene.color(calibration));
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      if (depth.at(x, y) != 1000) continue;
      ASSERT_EQ(out.seen.at(x, y), 255) << x << ',' << y;
      // At the outermost pixel up to half of the averaged square may be off the card, in both axes.
      ASSERT_GE(out.color.at(x, y).r, kGreen.r + (kRed.r - kGreen.r) / 4 - 2) << x << ',' << y;
      const bool inside = depth.at(x - 1, y) == 1000 && depth.at(x + 1, y) == 1000 &&
                          depth.at(x, y - 1) == 1000 && depth.at(x, y + 1) == 1000;
      if (inside) {
        ASSERT_EQ(out.color.at(x, y), kRed) << x << ',' << y;
      }
    }
  }
}

TEST(Registration, a_steep_floor_does_not_hide_itself) {
  SensorCalibration calibration = small_kinect();
  calibration.depth = {512, 424, 365, 365, 255.5, 211.5};
  calibration.color = {1920, 1080, 1065, 1065, 959.5, 539.5};
  DepthImage depth(calibration.depth.width, calibration.depth.height);
  const double camera_height_m = 0.6;
  const int horizon = 240;  // here the floor is 7.7 m away
  for (int y = horizon; y < depth.height(); ++y) {
    const double z_m = camera_height_m * calibration.depth.fy / (y - calibration.depth.cy);
    for (int x = 0; x < depth.width(); ++x) {
      depth.at(x, y) = static_cast<std::uint16_t>(std::lround(1000 * z_m));
    }
  }
  const ColorImage color(calibration.color.width, calibration.color.height, kGreen);
  const RegisteredColor out = register_or_die(calibration, depth, color);
  for (int y = horizon + 1; y < 380; ++y) {  // rows that the colour camera sees too
    for (int x = 40; x < 470; ++x) ASSERT_EQ(out.seen.at(x, y), 255) << x << ',' << y;
  }
}

TEST(Registration, rows_above_and_below_the_colour_picture_are_not_seen) {
  const SensorCalibration calibration = small_kinect();
  const DepthImage depth(calibration.depth.width, calibration.depth.height, 2000);
  const ColorImage color(calibration.color.width, calibration.color.height, kGreen);
  const RegisteredColor out = register_or_die(calibration, depth, color);
  // Depth row y projects to 179.5 + 355 * (y - 74.5) / 130: inside the picture for y from 9 to 140.
  for (int x = 40; x < 140; ++x) {
    EXPECT_EQ(out.seen.at(x, 8), 0);
    EXPECT_EQ(out.color.at(x, 8), Rgb8{});
    EXPECT_EQ(out.seen.at(x, 9), 255);
    EXPECT_EQ(out.seen.at(x, 140), 255);
    EXPECT_EQ(out.seen.at(x, 141), 0);
  }
}

TEST(Registration, without_depth_nothing_is_seen) {
  const SensorCalibration calibration = small_kinect();
  const DepthImage depth(calibration.depth.width, calibration.depth.height, 0);
  const ColorImage color(calibration.color.width, calibration.color.height, kGreen);
  const RegisteredColor out = register_or_die(calibration, depth, color);
  EXPECT_EQ(out.seen, MaskImage(180, 150, 0));
  EXPECT_EQ(out.color, ColorImage(180, 150));
}

/// A slanted plane, and a picture whose colour encodes its position.
struct SlantedPlane {
  explicit SlantedPlane(const SensorCalibration& of)
      : calibration(of),
        depth(of.depth.width, of.depth.height),
        color(of.color.width, of.color.height) {
    for (int y = 0; y < depth.height(); ++y) {
      for (int x = 0; x < depth.width(); ++x) {
        depth.at(x, y) = static_cast<std::uint16_t>(depth_mm_at(x, y));
      }
    }
    for (int v = 0; v < color.height(); ++v) {
      for (int u = 0; u < color.width(); ++u) {
        color.at(u, v) = {static_cast<std::uint8_t>(std::lround(u * 255 / 640.0)),
                          static_cast<std::uint8_t>(std::lround(v * 255 / 360.0)), 0};
      }
    }
  }
  static double depth_mm_at(double x, double y) { return 1500 + 3 * x + 2 * y; }

  /// `color` should be that of the surface at this position in the depth grid.
  void expect_own_color(Rgb8 of, double x, double y) const {
    const auto point = unproject(calibration.depth, Vector2d(x, y), 0.001 * depth_mm_at(x, y));
    const auto pixel = project(calibration.color, calibration.color_from_depth * *point);
    EXPECT_NEAR(of.r, pixel->x() * 255 / 640, 1.1);  // both round to whole levels
    EXPECT_NEAR(of.g, pixel->y() * 255 / 360, 1.1);
  }

  SensorCalibration calibration;
  DepthImage depth;
  ColorImage color;
};

TEST(Registration, each_pixel_shows_the_colour_at_its_own_surface_point) {
  const SlantedPlane plane(distorted_kinect());
  const RegisteredColor out = register_or_die(plane.calibration, plane.depth, plane.color);
  for (int y = 15; y < 135; ++y) {
    for (int x = 15; x < 165; ++x) {
      ASSERT_EQ(out.seen.at(x, y), 255);
      plane.expect_own_color(out.color.at(x, y), x, y);
    }
  }
}

TEST(Registration, at_twice_the_resolution_each_quarter_shows_its_own_colour) {
  const SlantedPlane plane(distorted_kinect());
  auto registration = Registration::create(plane.calibration, {.color_scale = 2});
  ASSERT_TRUE(registration.ok()) << registration.error().message;
  RegisteredColor out;
  ASSERT_TRUE(registration->run(plane.depth, plane.color, out).ok());
  ASSERT_EQ(out.color.width(), 2 * plane.depth.width());
  ASSERT_EQ(out.color.height(), 2 * plane.depth.height());
  EXPECT_EQ(out.seen.width(), plane.depth.width());
  for (int y = 30; y < 270; ++y) {
    for (int x = 30; x < 330; ++x) {
      plane.expect_own_color(out.color.at(x, y), 0.5 * x - 0.25, 0.5 * y - 0.25);
    }
  }
}

/// Steps, slopes, holes and texture, from a deterministic recurrence.
struct RoughFrame {
  DepthImage depth_mm;
  ColorImage color;
};

RoughFrame rough_frame(const SensorCalibration& calibration) {
  RoughFrame frame{DepthImage(calibration.depth.width, calibration.depth.height),
                   ColorImage(calibration.color.width, calibration.color.height)};
  std::uint32_t state = 12345;
  const auto random = [&state] { return (state = state * 1664525U + 1013904223U) >> 20; };
  for (int y = 0; y < frame.depth_mm.height(); ++y) {
    for (int x = 0; x < frame.depth_mm.width(); ++x) {
      const unsigned base = (x / 23 + y / 31) % 3 == 0 ? 900 : 2500;
      const unsigned z = base + 4U * static_cast<unsigned>(y) + random() % 8;
      frame.depth_mm.at(x, y) = static_cast<std::uint16_t>(random() % 20 == 0 ? 0 : z);
    }
  }
  for (int v = 0; v < frame.color.height(); ++v) {
    for (int u = 0; u < frame.color.width(); ++u) {
      const auto level = static_cast<std::uint8_t>(random());
      frame.color.at(u, v) = {level, static_cast<std::uint8_t>(u), static_cast<std::uint8_t>(v)};
    }
  }
  return frame;
}

TEST(Registration, agrees_with_the_reference) {
  for (const SensorCalibration& calibration : {small_kinect(), distorted_kinect()}) {
    const RoughFrame frame = rough_frame(calibration);
    const RegisteredColor fast = register_or_die(calibration, frame.depth_mm, frame.color);
    const RegisteredColor plain =
        RegistrationReference(calibration, {}).run(frame.depth_mm, frame.color);
    int different_mask = 0, compared = 0;
    for (int y = 0; y < frame.depth_mm.height(); ++y) {
      for (int x = 0; x < frame.depth_mm.width(); ++x) {
        if (fast.seen.at(x, y) != plain.seen.at(x, y)) {
          ++different_mask;
          continue;
        }
        ++compared;
        // Positions rounded to 1/64 px move at most 1/128 of a full-range step per side of the
        // square.
        const Rgb8 a = fast.color.at(x, y), b = plain.color.at(x, y);
        ASSERT_NEAR(a.r, b.r, 4) << x << ',' << y;
        ASSERT_NEAR(a.g, b.g, 4) << x << ',' << y;
      }
    }
    EXPECT_LE(different_mask, 27);  // one in a thousand: single precision at the border of a cell
    EXPECT_GT(compared, 10000);
  }
}

TEST(Registration, a_second_frame_leaves_no_trace_of_the_first) {
  const SensorCalibration calibration = small_kinect();
  auto registration = Registration::create(calibration);
  ASSERT_TRUE(registration.ok());
  const CardScene scene;
  RegisteredColor out;
  const RoughFrame rough = rough_frame(calibration);
  ASSERT_TRUE(registration->run(rough.depth_mm, rough.color, out).ok());
  const Rgb8* const pixels = out.color.data();
  const DepthImage depth = scene.depth_mm(calibration);
  const ColorImage color = scene.color(calibration);
  ASSERT_TRUE(registration->run(depth, color, out).ok());
  EXPECT_EQ(out.color.data(), pixels);  // memory is reused
  const RegisteredColor fresh = register_or_die(calibration, depth, color);
  EXPECT_EQ(out.color, fresh.color);
  EXPECT_EQ(out.seen, fresh.seen);
}

TEST(Registration, registered_colour_is_copied_where_there_is_depth) {
  SensorCalibration calibration = small_kinect();
  calibration.color = calibration.depth;
  calibration.color_is_registered = true;
  const RoughFrame frame = rough_frame(calibration);
  const RegisteredColor out = register_or_die(calibration, frame.depth_mm, frame.color);
  for (int y = 0; y < frame.depth_mm.height(); ++y) {
    for (int x = 0; x < frame.depth_mm.width(); ++x) {
      const bool depth = frame.depth_mm.at(x, y) != 0;
      ASSERT_EQ(out.seen.at(x, y), depth ? 255 : 0);
      ASSERT_EQ(out.color.at(x, y), depth ? frame.color.at(x, y) : Rgb8{});
    }
  }
}

TEST(Registration, refuses_pictures_of_another_size) {
  const SensorCalibration calibration = small_kinect();
  auto registration = Registration::create(calibration);
  ASSERT_TRUE(registration.ok());
  RegisteredColor out;
  const DepthImage depth(180, 150);
  const ColorImage color(640, 360);
  const Status wrong_depth = registration->run(DepthImage(150, 180), color, out);
  ASSERT_FALSE(wrong_depth.ok());
  EXPECT_EQ(wrong_depth.error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(wrong_depth.error().message, "depth is 150x180 but the calibration is for 180x150");
  EXPECT_FALSE(registration->run(depth, ColorImage(640, 361), out).ok());
  EXPECT_FALSE(registration->run(depth, ColorView{}, out).ok());
}

TEST(Registration, refuses_calibrations_and_options_that_make_no_sense) {
  SensorCalibration calibration = small_kinect();
  calibration.color.fx = 0;
  EXPECT_FALSE(Registration::create(calibration).ok());
  calibration = small_kinect();
  calibration.depth.width = 1;
  EXPECT_FALSE(Registration::create(calibration).ok());
  calibration = small_kinect();
  calibration.color_is_registered = true;  // but of another size
  EXPECT_FALSE(Registration::create(calibration).ok());
  calibration.color = calibration.depth;
  EXPECT_TRUE(Registration::create(calibration).ok());
  EXPECT_FALSE(Registration::create(calibration, {.color_scale = 2}).ok());
  EXPECT_FALSE(Registration::create(small_kinect(), {.color_scale = 3}).ok());
  EXPECT_FALSE(Registration::create(small_kinect(), {.occlusion_margin_m = -1}).ok());
  EXPECT_FALSE(Registration::create(small_kinect(), {.occlusion_margin_per_m = NAN}).ok());
}

TEST(Registration, works_where_colour_has_fewer_pixels_than_depth) {
  SensorCalibration calibration;  // like a Kinect v1
  calibration.depth = {640, 480, 585, 585, 320, 240};
  calibration.color = {640, 480, 532, 532, 320, 240};
  calibration.color_from_depth.translation_m = Vector3d(-0.025, 0, 0);
  const DepthImage depth(640, 480, 2000);
  const ColorImage color(640, 480, kGreen);
  const RegisteredColor out = register_or_die(calibration, depth, color);
  EXPECT_EQ(out.seen.at(320, 240), 255);
  EXPECT_EQ(out.color.at(320, 240), kGreen);
}

}  // namespace
}  // namespace roomcast
