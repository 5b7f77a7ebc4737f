// SPDX-License-Identifier: Apache-2.0
// Registration accuracy on recordings of real Kinects. Colour mostly changes where depth jumps: the
// mean colour gradient under the depth edges, relative to that of the whole picture, is largest
// when the camera parameters are correct.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/io/camera_json.h"
#include "roomcast/io/image_file.h"
#include "roomcast/sensor/source_factory.h"
#include "roomcast/source/drivers/freenect/kinect_calibration.h"

namespace roomcast::tests {
namespace {

namespace fs = std::filesystem;

fs::path recording(const char* name) {
  const char* const data = std::getenv("ROOMCAST_DATA");
  return fs::path(data != nullptr ? data : ROOMCAST_SOURCE_DIR "/../shared/data") / name;
}

/// Every tenth frame of a recording, at most eight.
std::vector<source::CapturedFrame> frames_of(const fs::path& folder) {
  auto source = sensor::open_source("tum:" + folder.string(),
                                    {.pace = source::Pace::kAsFastAsPossible, .loop = false});
  EXPECT_TRUE(source.ok()) << (source.ok() ? "" : source.error().message);
  std::vector<source::CapturedFrame> frames;
  source::CapturedFrame frame;
  for (int i = 0; frames.size() < 8 && *(*source)->next(frame, {}); ++i)
    if (i % 10 == 0) frames.push_back(frame);
  return frames;
}

Image<float> gradient_of(ColorView color) {
  const auto grey = [&](int x, int y) {
    const Rgb8 p = color.at(x, y);
    return 0.30F * p.r + 0.59F * p.g + 0.11F * p.b;
  };
  Image<float> gradient(color.width, color.height);
  for (int y = 1; y + 1 < color.height; ++y) {
    for (int x = 1; x + 1 < color.width; ++x) {
      gradient.at(x, y) =
          std::hypot(grey(x + 1, y) - grey(x - 1, y), grey(x, y + 1) - grey(x, y - 1));
    }
  }
  return gradient;
}

/// True on the nearer side of a depth jump.
bool is_depth_edge(DepthView depth, int x, int y) {
  const int here = depth.at(x, y);
  const auto far_behind = [&](int there) { return there > here + 60 + here / 25; };
  return here > 0 && (far_behind(depth.at(x - 1, y)) || far_behind(depth.at(x + 1, y)) ||
                      far_behind(depth.at(x, y - 1)) || far_behind(depth.at(x, y + 1)));
}

struct Sums {
  double at_edges = 0, everywhere = 0;
  double edges = 0, pixels = 0;
  [[nodiscard]] double score() const { return (at_edges / edges) / (everywhere / pixels); }
};

void add(const source::CapturedFrame& frame, const SensorCalibration& cameras, int shift_px,
         Sums& sums) {
  const Image<float> gradient = gradient_of(frame.color);
  for (std::size_t i = 0; i < gradient.view().pixel_count(); ++i)
    sums.everywhere += static_cast<double>(gradient.data()[i]);
  sums.pixels += static_cast<double>(gradient.view().pixel_count());
  const DepthView depth = frame.depth_mm;
  for (int y = 1; y + 1 < depth.height; ++y) {
    for (int x = 1; x + 1 < depth.width; ++x) {
      if (!is_depth_edge(depth, x, y)) continue;
      const auto point = unproject(cameras.depth, Eigen::Vector2d(x, y), 0.001 * depth.at(x, y));
      const auto pixel = project(cameras.color, cameras.color_from_depth * *point);
      if (!pixel) continue;
      const long u = std::lround(pixel->x()) + shift_px, v = std::lround(pixel->y());
      if (u < 1 || v < 1 || u + 1 >= gradient.width() || v + 1 >= gradient.height()) continue;
      sums.at_edges += static_cast<double>(gradient.at(static_cast<int>(u), static_cast<int>(v)));
      sums.edges += 1;
    }
  }
}

double edge_score(const std::vector<source::CapturedFrame>& frames,
                  const SensorCalibration& cameras, int shift_px = 0) {
  Sums sums;
  for (const source::CapturedFrame& frame : frames) add(frame, cameras, shift_px, sums);
  EXPECT_GT(sums.edges, 1000);
  return sums.score();
}

// The recording's own camera parameters were measured on it, so they give the attainable accuracy.
TEST(KinectRegistration, a_typical_kinects_cameras_line_up_as_well_as_those_measured) {
  const fs::path folder = recording("redkitchen_moving");
  if (!fs::exists(folder))
    GTEST_SKIP() << "no recording at " << folder << "; set ROOMCAST_DATA to test with it";
  const auto frames = frames_of(folder);
  const auto measured = io::read_camera_json(folder / "camera.json");
  ASSERT_TRUE(measured.ok());
  const SensorCalibration typical = source::typical_kinect({});
  SensorCalibration ignorant = typical;
  ignorant.color = ignorant.depth;
  ignorant.color_from_depth = {};
  const double best = edge_score(frames, measured->calibration);
  const double ours = edge_score(frames, typical), none = edge_score(frames, ignorant);
  RecordProperty("measured_percent", static_cast<int>(100 * best));
  RecordProperty("typical_percent", static_cast<int>(100 * ours));
  RecordProperty("unregistered_percent", static_cast<int>(100 * none));
  EXPECT_GT(ours, 0.95 * best);
  EXPECT_GT(ours, 1.1 * none);
}

TEST(KinectRegistration, a_typical_kinects_cameras_are_better_than_shifted_ones) {
  const fs::path folder = recording("redkitchen_moving");
  if (!fs::exists(folder))
    GTEST_SKIP() << "no recording at " << folder << "; set ROOMCAST_DATA to test with it";
  const auto frames = frames_of(folder);
  const double right = edge_score(frames, source::typical_kinect({}));
  EXPECT_GT(right, edge_score(frames, source::typical_kinect({}), -8));
  EXPECT_GT(right, edge_score(frames, source::typical_kinect({}), 8));
}

TEST(KinectRegistration, depth_that_the_device_laid_over_colour_lines_up_without_a_shift) {
  const fs::path folder = recording("kinect1_oni_fixed");
  if (!fs::exists(folder))
    GTEST_SKIP() << "no recording at " << folder << "; set ROOMCAST_DATA to test with it";
  const auto frames = frames_of(folder);
  const auto camera = io::read_camera_json(folder / "camera.json");
  ASSERT_TRUE(camera.ok());
  ASSERT_TRUE(camera->calibration.color_is_registered);
  const double right = edge_score(frames, camera->calibration);
  RecordProperty("registered_percent", static_cast<int>(100 * right));
  EXPECT_GT(right, edge_score(frames, camera->calibration, -10));
  EXPECT_GT(right, edge_score(frames, camera->calibration, 10));
}

}  // namespace
}  // namespace roomcast::tests
