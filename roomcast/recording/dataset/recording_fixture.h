// SPDX-License-Identifier: Apache-2.0
// For tests: small recordings.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/rig_writer.h"

namespace roomcast::recording {

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void put_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

/// Truncates a file to the fraction `share` of its size.
inline void truncate_file(const std::filesystem::path& path, double share) {
  const auto size = static_cast<double>(std::filesystem::file_size(path));
  std::filesystem::resize_file(path, static_cast<std::uintmax_t>(share * size));
}

constexpr int kSmallWidth = 40, kSmallHeight = 30;

inline SensorCalibration small_calibration() {
  SensorCalibration calibration;
  calibration.depth = {kSmallWidth, kSmallHeight, 35, 35, 19.5, 14.5, 0.08, -0.2};
  calibration.color = {80, 60, 70, 70, 39.5, 29.5};
  calibration.color_from_depth.translation_m = {-0.05, 0, 0};
  return calibration;
}

/// Depth that encodes sensor, frame and pixel; one smooth colour per frame.
inline source::CapturedFrame small_frame(int sensor, std::uint64_t index) {
  source::CapturedFrame frame;
  frame.index = index;
  frame.depth_mm.resize(kSmallWidth, kSmallHeight);
  for (int y = 0; y < kSmallHeight; ++y) {
    for (int x = 0; x < kSmallWidth; ++x) {
      frame.depth_mm.at(x, y) =
          static_cast<std::uint16_t>(1000 * (sensor + 1) + 100 * int(index) + x + y);
    }
  }
  frame.color.resize(80, 60, {static_cast<std::uint8_t>(20 * index), 100, 50});
  return frame;
}

constexpr double kSmallFps = 50;

/// Two sensors, `frames` frames each. The second one's clock is 7.5 s ahead and its frames are 3 ms
/// later; its frame 2 is dropped.
inline std::filesystem::path write_small_rig(const TemporaryFolder& folder, int frames = 5) {
  std::vector<RigSensor> sensors(2);
  sensors[0].description = {"s0", small_calibration(), RigidTransform{}, kSmallFps};
  sensors[1].description = {"s1", small_calibration(), std::nullopt, kSmallFps};
  sensors[1].clock_offset_s = 7.5;
  const std::filesystem::path path = folder / "rig";
  auto writer = RigWriter::create(path, kSmallFps, sensors);
  EXPECT_TRUE(writer.ok()) << (writer.ok() ? "" : writer.error().message);
  const auto at = [](double seconds) { return nanoseconds(std::llround(seconds * 1e9)); };
  for (int i = 0; i < frames; ++i) {
    const auto index = static_cast<std::uint64_t>(i);
    EXPECT_TRUE(writer->add(0, small_frame(0, index), at(100 + i / kSmallFps)).ok());
    if (i == 2) continue;
    EXPECT_TRUE(writer->add(1, small_frame(1, index), at(107.503 + i / kSmallFps)).ok());
  }
  EXPECT_TRUE(writer->finish().ok());
  return path;
}

/// The folder of optional test recordings, if it exists: ROOMCAST_DATA, else ../shared/data.
inline std::filesystem::path shared_data() {
  const char* const given = std::getenv("ROOMCAST_DATA");
  if (given != nullptr) return given;
#ifdef ROOMCAST_SOURCE_DIR
  return std::filesystem::path(ROOMCAST_SOURCE_DIR) / "../shared/data";
#else
  return "../shared/data";
#endif
}

}  // namespace roomcast::recording
