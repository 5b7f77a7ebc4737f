// SPDX-License-Identifier: Apache-2.0
// For tests: a small rig with true views, of a wall that one sensor sees.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/rig_writer.h"
#include "roomcast/render/surface/sensor_pictures_fixture.h"

namespace roomcast::bench {

class StripedRigTest : public testing::Test {
 protected:
  /// A striped wall 2 m away. A sensor and an eye at the same position see the same picture. Four
  /// frames; nothing moves between the two times of the views.
  void write_rig() const {
    recording::RigSensor sensor;
    sensor.description.name = "s0";
    sensor.description.calibration.depth = sensor.description.calibration.color = kLens;
    sensor.description.calibration.color_is_registered = true;
    sensor.description.world_from_depth = RigidTransform{};
    auto writer = recording::RigWriter::create(folder / "rig", 30, std::vector{sensor});
    ASSERT_TRUE(writer.ok()) << writer.error().message;
    source::CapturedFrame frame;
    frame.depth_mm = DepthImage(kLens.width, kLens.height, 2000);
    frame.color = stripes();
    for (; frame.index < 4; ++frame.index) {
      const nanoseconds time(33'333'333 * static_cast<std::int64_t>(frame.index + 1));
      ASSERT_TRUE(writer->add(0, frame, time).ok());
    }
    ASSERT_TRUE(writer->finish().ok());
    write_truth();
  }

  void write_truth() const {
    const std::filesystem::path truth = folder / "rig" / "truth";
    std::filesystem::create_directories(truth / "s0");
    const DepthImage depth(kLens.width, kLens.height, 2000);
    nlohmann::json views = {{"width", kLens.width}, {"height", kLens.height}, {"fy", kLens.fy}};
    for (const int instant : {0, 1}) {
      const std::string name = "view_0_t" + std::to_string(instant);
      ASSERT_TRUE(io::write_color_png(truth / (name + ".png"), stripes()).ok());
      ASSERT_TRUE(io::write_depth_png(truth / (name + "_depth.png"), depth).ok());
      const MaskImage seen(kLens.width, kLens.height, 1);
      ASSERT_TRUE(io::write_mask_png(truth / (name + "_seen.png"), seen).ok());
      ASSERT_TRUE(
          io::write_depth_png(truth / "s0" / (instant ? "000002.png" : "000001.png"), depth).ok());
      views["views"].push_back(
          {{"view", 0},
           {"instant", instant},
           {"true_time_s", (instant + 2) / 30.0},
           {"color", name + ".png"},
           {"depth", name + "_depth.png"},
           {"seen", name + "_seen.png"},
           {"world_from_view", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
           {"frame", {{"s0", instant + 1}}}});
    }
    std::ofstream(truth / "views.json") << views.dump();
  }

  [[nodiscard]] ColorImage stripes() const {
    ColorImage image(kLens.width, kLens.height, render::kRed);
    for (int x = 0; x < kLens.width; x += 16)
      render::fill_box(image, x, 0, x + 8, kLens.height, render::kGreen);
    return image;
  }

  const CameraIntrinsics kLens = render::pinhole(96, 72, 80);
  const TemporaryFolder folder;
};

}  // namespace roomcast::bench
