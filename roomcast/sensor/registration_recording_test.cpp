// SPDX-License-Identifier: Apache-2.0
// Registration against ground truth: a recording with noise-free pictures from other viewpoints
// (colour and depth) gives the true colour of every surface point. The test is in this folder
// because it needs recordings; registration is in geometry.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/geometry/registration.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::sensor {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kViewSide = 1000;
constexpr double kSameSurface_m = 0.03;  // three sigma of the recorded noise at 4 m
constexpr int kGrossError = 40;          // a different surface, not noise or interpolation

/// A picture from a free viewpoint, without noise.
struct TrueView {
  CameraIntrinsics camera;
  RigidTransform world_from_view;
  DepthImage depth_mm;
  ColorImage color;
};

TrueView read_view(const std::filesystem::path& truth, const nlohmann::json& views, std::size_t i) {
  TrueView view;
  view.camera = {kViewSide,
                 kViewSide,
                 views["fx"].get<double>(),
                 views["fy"].get<double>(),
                 views["cx"].get<double>(),
                 views["cy"].get<double>()};
  const auto& entry = views["views"][i];
  const auto numbers = entry["world_from_view"].get<std::vector<double>>();
  view.world_from_view = transform_from_row_major(numbers).value();
  io::ImageFileReader reader;
  const io::ImageSize size{kViewSide, kViewSide};
  EXPECT_TRUE(
      reader.read_depth(truth / entry["depth"].get<std::string>(), size, view.depth_mm).ok());
  EXPECT_TRUE(reader.read_color(truth / entry["color"].get<std::string>(), size, view.color).ok());
  return view;
}

/// Frame `index` of sensor s0, which has colour gain 1 and the clock of the ground truth.
source::CapturedFrame read_frame(source::FrameSource& source, std::uint64_t index) {
  source::CapturedFrame frame;
  while (frame.index != index || frame.depth_mm.empty()) {
    const auto more = source.next(frame, {});
    if (!more.ok() || !*more) break;
  }
  EXPECT_EQ(frame.index, index);
  return frame;
}

int difference(Rgb8 a, Rgb8 b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// Differences between registered and true colour at all surface points that both view and sensor
/// see.
std::vector<int> differences(const TrueView& view, const source::SensorDescription& sensor,
                             const source::CapturedFrame& frame,
                             const RegisteredColor& registered) {
  std::vector<int> all;
  const RigidTransform depth_from_view = sensor.world_from_depth->inverse() * view.world_from_view;
  for (int v = 0; v < kViewSide; ++v) {
    for (int u = 0; u < kViewSide; ++u) {
      const double z_m = 0.001 * view.depth_mm.at(u, v);
      if (z_m == 0) continue;
      const Vector3d point = depth_from_view * *unproject(view.camera, Vector2d(u, v), z_m);
      const auto pixel = project(sensor.calibration.depth, point);
      if (!pixel) continue;
      const long x = std::lround(pixel->x()), y = std::lround(pixel->y());
      if (x < 0 || y < 0 || x >= frame.depth_mm.width() || y >= frame.depth_mm.height()) continue;
      const int px = static_cast<int>(x), py = static_cast<int>(y);
      if (registered.seen.at(px, py) == 0) continue;
      if (std::abs(0.001 * frame.depth_mm.at(px, py) - point.z()) > kSameSurface_m) continue;
      all.push_back(difference(view.color.at(u, v), registered.color.at(px, py)));
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

struct Agreement {
  std::size_t compared = 0;
  int median = 0;
  double gross_share = 0;
};

Agreement agreement_of(const std::vector<int>& sorted) {
  if (sorted.empty()) return {};
  const auto gross = sorted.end() - std::upper_bound(sorted.begin(), sorted.end(), kGrossError);
  return {sorted.size(), sorted[sorted.size() / 2], double(gross) / double(sorted.size())};
}

class RegisteredHouse : public testing::Test {
 protected:
  void SetUp() override {
    const auto house = recording::shared_data() / "house3";
    if (!std::filesystem::exists(house / "truth/views.json")) {
      GTEST_SKIP() << "no recordings at " << recording::shared_data()
                   << "; set ROOMCAST_DATA to test with them";
    }
    const auto views = nlohmann::json::parse(recording::text_of(house / "truth/views.json"));
    view_ = read_view(house / "truth", views, 0);
    auto source = open_source("rig:" + house.string() + "#s0",
                              {.pace = source::Pace::kAsFastAsPossible, .loop = false});
    ASSERT_TRUE(source.ok()) << source.error().message;
    sensor_ = (*source)->description();
    frame_ = read_frame(**source, views["views"][0]["frame"]["s0"].get<std::uint64_t>());
  }

  Agreement agreement(const SensorCalibration& calibration, const RegistrationOptions& options) {
    auto registration = Registration::create(calibration, options);
    EXPECT_TRUE(registration.ok());
    RegisteredColor out;
    EXPECT_TRUE(registration->run(frame_.depth_mm, frame_.color, out).ok());
    const Agreement found = agreement_of(differences(view_, sensor_, frame_, out));
    RecordProperty("compared", static_cast<int>(found.compared));
    RecordProperty("median", found.median);
    RecordProperty("gross_per_mille", static_cast<int>(1000 * found.gross_share));
    return found;
  }

  TrueView view_;
  source::SensorDescription sensor_;
  source::CapturedFrame frame_;
};

// On the recording, the measured median difference is 2 grey levels, which is the recorded JPEG
// noise; gross errors are 1.2 % of the points.
TEST_F(RegisteredHouse, colours_are_those_of_the_surface_points) {
  const Agreement registered = agreement(sensor_.calibration, {});
  EXPECT_GT(registered.compared, 300000U);
  EXPECT_LE(registered.median, 3);
  EXPECT_LT(registered.gross_share, 0.02);
}

TEST_F(RegisteredHouse, ignoring_where_the_colour_camera_sits_is_far_worse) {
  SensorCalibration without_extrinsics = sensor_.calibration;
  without_extrinsics.color_from_depth = {};
  EXPECT_GT(agreement(without_extrinsics, {}).gross_share,
            3 * agreement(sensor_.calibration, {}).gross_share);
}

TEST_F(RegisteredHouse, the_occlusion_test_takes_out_gross_errors_and_little_else) {
  const Agreement with = agreement(sensor_.calibration, {});
  const Agreement without = agreement(sensor_.calibration, {.occlusion_margin_m = 100});
  EXPECT_LT(with.gross_share, without.gross_share);
  EXPECT_GT(double(with.compared), 0.98 * double(without.compared));
}

}  // namespace
}  // namespace roomcast::sensor
