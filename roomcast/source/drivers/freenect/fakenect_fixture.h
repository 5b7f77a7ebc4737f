// SPDX-License-Identifier: Apache-2.0
// For tests: a recording of a Kinect v1 in the format of fakenect: INDEX.txt lists the pictures in
// order; a picture's name contains the time in seconds and the camera's ticks. Depth is 16-bit PGM
// with little-endian values (unlike PGM), colour is PPM. Repeated pictures are links.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::source {

inline constexpr int kRecordedWidth = 640, kRecordedHeight = 480;
inline constexpr double kRecordedFps = 30;

/// Raw value of a pixel: no reading in the left tenth, else a slanted wall.
inline std::uint16_t recorded_raw(int x, int y) {
  if (x < kRecordedWidth / 10) return 2047;
  return static_cast<std::uint16_t>(600 + x / 8 + y / 4);
}
inline Rgb8 recorded_color(int x, int y) {
  return {static_cast<std::uint8_t>(x / 3), static_cast<std::uint8_t>(y / 2), 77};
}

inline void write_recorded_depth(const std::filesystem::path& file) {
  std::string bytes = "P5 640 480 65535\n";
  for (int y = 0; y < kRecordedHeight; ++y) {
    for (int x = 0; x < kRecordedWidth; ++x) {
      const std::uint16_t raw = recorded_raw(x, y);
      bytes += static_cast<char>(raw & 0xFF);
      bytes += static_cast<char>(raw >> 8);
    }
  }
  std::ofstream(file, std::ios::binary) << bytes;
}

inline void write_recorded_color(const std::filesystem::path& file) {
  std::string bytes = "P6 640 480 255\n";
  for (int y = 0; y < kRecordedHeight; ++y) {
    for (int x = 0; x < kRecordedWidth; ++x) {
      const Rgb8 pixel = recorded_color(x, y);
      bytes += {static_cast<char>(pixel.r), static_cast<char>(pixel.g), static_cast<char>(pixel.b)};
    }
  }
  std::ofstream(file, std::ios::binary) << bytes;
}

/// Writes `frames` pairs of depth and colour, 2 ms apart, at 30 frames/s.
inline void write_fakenect_recording(const std::filesystem::path& folder, int frames) {
  std::filesystem::create_directories(folder);
  write_recorded_depth(folder / "depth.pgm");
  write_recorded_color(folder / "color.ppm");
  std::ofstream index(folder / "INDEX.txt");
  constexpr double kTicksPerSecond = 60e6, kColorLater_s = 0.002;
  const auto add = [&](char kind, double time_s, const char* file, const char* extension) {
    std::array<char, 64> name{};
    std::snprintf(name.data(), name.size(), "%c-%.6f-%u.%s", kind, time_s,
                  static_cast<unsigned>(time_s * kTicksPerSecond), extension);
    std::filesystem::create_hard_link(folder / file, folder / name.data());
    index << name.data() << '\n';
  };
  for (int i = 0; i < frames; ++i) {
    const double time_s = 1 + i / kRecordedFps;
    add('d', time_s, "depth.pgm", "pgm");
    add('r', time_s + kColorLater_s, "color.ppm", "ppm");
  }
}

}  // namespace roomcast::source
