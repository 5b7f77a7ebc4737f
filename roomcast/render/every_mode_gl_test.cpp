// SPDX-License-Identifier: Apache-2.0
// Compares each render mode with the true scene and with its own earlier result. Two sensors see a
// wall and a board in front of it; an eye between the sensors looks at both.
#include <cmath>
#include <map>
#include <string>

#include "roomcast/render/scene_fixture.h"

namespace roomcast::render {
namespace {

using Eigen::Vector3d;

const CameraIntrinsics kLens = pinhole(128, 96, 100);
const CameraIntrinsics kEyeLens = pinhole(120, 90, 120);

RigidTransform looking_from(double x, double y) {
  return world_from_optical_looking_at(Vector3d(x, y, 0), Vector3d(0, 1.5, -2.4));
}

struct Likeness {
  double psnr_db = 0, drawn_share = 0;
};

/// Compares only the pixels that were drawn.
Likeness compare(const Picture& picture, const RigidTransform& eye) {
  double squared = 0, drawn = 0;
  for (int y = 0; y < kEyeLens.height; ++y) {
    for (int x = 0; x < kEyeLens.width; ++x) {
      if (picture.sensors.at(x, y) == kDrawnByNoSensor) continue;
      const Rgb8 is = picture.color.at(x, y), should = true_color(true_point(kEyeLens, eye, x, y));
      for (const int difference : {is.r - should.r, is.g - should.g, is.b - should.b}) {
        squared += difference * difference / 3.0;
      }
      drawn += 1;
    }
  }
  return {10 * std::log10(255.0 * 255.0 * drawn / squared),
          drawn / (kEyeLens.width * kEyeLens.height)};
}

class EveryModeOfTrueScene : public RoomTest, public ::testing::WithParamInterface<RenderMode> {
 protected:
  Picture draw_scene() {
    const RigidTransform left = looking_from(-0.3, 1.5), right = looking_from(0.4, 1.6);
    add(kFirst, kLens, left, true_pictures(kLens, left));
    add(kSecond, kLens, right, true_pictures(kLens, right));
    return draw(eye_of(kEyeLens, eye_), GetParam());
  }

  const RigidTransform eye_ = looking_from(0.05, 1.65);
};
INSTANTIATE_TEST_SUITE_P(Modes, EveryModeOfTrueScene, ::testing::ValuesIn(kRenderModes),
                         [](const auto& mode) { return std::string(name_of(mode.param)); });

TEST_P(EveryModeOfTrueScene, looks_like_what_is_there) {
  const Likeness like = compare(draw_scene(), eye_);
  const bool is_solid = GetParam() != RenderMode::kPoints;
  EXPECT_GT(like.psnr_db, is_solid ? 28.5 : 27);
  EXPECT_GT(like.drawn_share, is_solid ? 0.95 : 0.5);
}

// Detects every unintended change of a pixel.
TEST_P(EveryModeOfTrueScene, is_the_same_bit_by_bit_on_the_driver_it_was_kept_for) {
  const std::string kept_for = "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6";
  const Picture picture = draw_scene();
  if (context_->driver_name() != kept_for) GTEST_SKIP() << "kept for " << kept_for;
  const std::map<RenderMode, std::uint64_t> kept = {
      {RenderMode::kPoints, 0xcc86d2cf8f5ef616U}, {RenderMode::kSplats, 0x387e2961abb8788dU},
      {RenderMode::kMesh, 0xfc7e84d150267d53U},   {RenderMode::kAdaptive, 0x9930bf10f6802b88U},
      {RenderMode::kBlend, 0x0e4966694550b130U},
  };
  std::uint64_t hash = 0xcbf29ce484222325U;  // FNV-1a
  for (std::size_t i = 0; i < picture.color.view().pixel_count(); ++i) {
    const Rgb8 color = picture.color.data()[i];
    for (const std::uint8_t byte : {color.r, color.g, color.b}) {
      hash = (hash ^ byte) * 0x100000001b3U;
    }
  }
  EXPECT_EQ(hash, kept.at(GetParam())) << std::hex << "0x" << hash;
}

}  // namespace
}  // namespace roomcast::render
