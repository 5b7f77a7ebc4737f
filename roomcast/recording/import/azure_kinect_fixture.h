// SPDX-License-Identifier: Apache-2.0
// For tests: recordings as k4arecorder writes them, by its format's documentation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/io/jpeg_codec.h"
#include "roomcast/recording/matroska/matroska_fixture.h"

namespace roomcast::recording {

/// A calibration of the size of a real one.
inline const std::string kAzureCalibration = R"({"CalibrationInformation": {"Cameras": [
 {"Intrinsics": {"ModelParameterCount": 14, "ModelType": "CALIBRATION_LensDistortionModelBrownConrady",
   "ModelParameters": [0.51, 0.52, 0.49, 0.49, 0.55, -0.021, -0.0027, 0.89, 0.086, -0.014, 0, 0, -7e-05, 2e-05]},
  "Location": "CALIBRATION_CameraLocationD0", "SensorWidth": 1024, "SensorHeight": 1024,
  "Rt": {"Rotation": [1, 0, 0, 0, 1, 0, 0, 0, 1], "Translation": [0, 0, 0]}},
 {"Intrinsics": {"ModelParameterCount": 14, "ModelType": "CALIBRATION_LensDistortionModelBrownConrady",
   "ModelParameters": [0.5, 0.51, 0.48, 0.64, 0.33, -2.5, 1.46, 0.21, -2.31, 1.38, 0, 0, -1e-04, -2e-04]},
  "Location": "CALIBRATION_CameraLocationPV0", "SensorWidth": 4096, "SensorHeight": 3072,
  "Rt": {"Rotation": [1, 0, 0, 0, 0.9962, 0.0871, 0, -0.0871, 0.9962], "Translation": [-0.032, -0.002, 0.004]}}
]}})";

struct AzureFixture {
  std::string serial = "000123";
  std::string sync = "STANDALONE";
  std::string color = "MJPG";  // or "NV12", "YUY2"; empty: none
  std::string calibration = kAzureCalibration;
  std::int64_t start_offset_us = 500'000;
  std::int64_t depth_delay_us = 0;
  std::int64_t date_s = 600'000'000;  // since 2001
  std::int64_t first_us = 100'000;    // time of the first picture in the file
  int frames = 3;                     // 30 a second
};

constexpr int kAzureDepthWidth = 320, kAzureDepthHeight = 288;  // NFOV_2X2BINNED
constexpr int kAzureColorWidth = 1280, kAzureColorHeight = 720;

inline std::uint16_t azure_depth_mm(int frame, int x, int y) {
  return static_cast<std::uint16_t>(1000 + 300 * frame + 3 * x + y);
}

/// Big-endian depth of a frame.
inline matroska::FixtureBytes azure_depth(int frame) {
  matroska::FixtureBytes bytes;
  for (int y = 0; y < kAzureDepthHeight; ++y) {
    for (int x = 0; x < kAzureDepthWidth; ++x)
      matroska::append_big(bytes, azure_depth_mm(frame, x, y), 2);
  }
  return bytes;
}

/// A grey picture whose brightness is 40 + 30 * frame.
inline matroska::FixtureBytes azure_color(const std::string& format, int frame) {
  const auto grey = static_cast<std::uint8_t>(40 + 30 * frame);
  const std::size_t pixels = std::size_t{kAzureColorWidth} * kAzureColorHeight;
  // BT.601: brightness from 16 to 235.
  const auto luma = static_cast<std::uint8_t>(16 + grey * 219 / 255);
  matroska::FixtureBytes bytes;
  if (format == "NV12") {
    bytes.assign(pixels, luma);
    bytes.resize(pixels * 3 / 2, 128);
  } else if (format == "YUY2") {
    bytes.assign(pixels * 2, 128);
    for (std::size_t i = 0; i < pixels; ++i) bytes[2 * i] = luma;
  } else {
    io::JpegCodec jpeg;
    (void)jpeg.encode(ColorImage(kAzureColorWidth, kAzureColorHeight, {grey, grey, grey}), 90,
                      bytes);
  }
  return bytes;
}

inline matroska::FixtureBytes azure_recording(const AzureFixture& made) {
  using namespace matroska;
  std::vector<FixtureBytes> tracks = {
      video_track(2, "DEPTH", "b16g", kAzureDepthWidth, kAzureDepthHeight),
      video_track(3, "IR", "b16g", kAzureDepthWidth, kAzureDepthHeight)};
  std::vector<FixtureBytes> tags = {
      tag("K4A_DEPTH_MODE", "NFOV_2X2BINNED"), tag("K4A_WIRED_SYNC_MODE", made.sync),
      tag("K4A_DEVICE_SERIAL_NUMBER", made.serial),
      tag("K4A_DEPTH_DELAY_NS", std::to_string(1000 * made.depth_delay_us)),
      tag("K4A_START_OFFSET_NS", std::to_string(1000 * made.start_offset_us))};
  if (!made.color.empty()) {
    tracks.push_back(video_track(1, "COLOR", made.color, kAzureColorWidth, kAzureColorHeight));
    tags.push_back(tag("K4A_COLOR_MODE", made.color + "_720P"));
  }
  std::vector<FixtureBytes> parts = {
      info(made.date_s * 1'000'000'000), element(0x1654AE6B, joined(tracks)),
      element(0x1941A469, attachment("calibration.json", made.calibration)),
      element(0x1254C367, joined(tags))};
  for (int i = 0; i < made.frames; ++i) {
    const std::int64_t time = made.first_us + 33'333 * i;
    std::vector<FixtureBytes> blocks = {
        simple_block(2, static_cast<std::int16_t>(made.depth_delay_us), azure_depth(i)),
        simple_block(3, 0, FixtureBytes(100))};
    if (!made.color.empty()) blocks.push_back(simple_block(1, 0, azure_color(made.color, i)));
    parts.push_back(cluster(static_cast<std::uint64_t>(time), blocks));
  }
  return file_of(parts);
}

}  // namespace roomcast::recording
