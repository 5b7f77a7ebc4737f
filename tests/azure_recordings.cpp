// SPDX-License-Identifier: Apache-2.0
// For tests: writes the sensors of a rig by `roomcast simulate --camera azure` as k4arecorder
// writes recordings (NFOV_UNBINNED, MJPG_1080P): azure_recordings RIG FOLDER -> FOLDER/s0.mkv,
// s1.mkv, ...
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "roomcast/io/jpeg_codec.h"
#include "roomcast/recording/dataset/recording.h"
#include "roomcast/recording/matroska/matroska_fixture.h"
#include "roomcast/recording/playback/recording_source.h"

namespace {

using namespace roomcast;
using namespace roomcast::recording;
using matroska::FixtureBytes;

constexpr std::int64_t kDate_s = 600'000'000;  // since 2001

/// A camera as in calibration.json: in units of the sensor's whole picture, of which the mode shows
/// a part that begins at `crop_x`, `crop_y`.
nlohmann::json camera_json(const CameraIntrinsics& c, const RigidTransform& camera_from_depth,
                           const char* location, int width, int height, int crop_x, int crop_y,
                           int sensor_width, int sensor_height) {
  nlohmann::json rotation = nlohmann::json::array(), translation = nlohmann::json::array();
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) rotation.push_back(camera_from_depth.rotation(y, x));
    translation.push_back(camera_from_depth.translation_m[y]);
  }
  return {{"Intrinsics",
           {{"ModelParameterCount", 14},
            {"ModelType", "CALIBRATION_LensDistortionModelBrownConrady"},
            {"ModelParameters",
             {(c.cx + 0.5 + crop_x) / width, (c.cy + 0.5 + crop_y) / height, c.fx / width,
              c.fy / height, c.k1, c.k2, c.k3, 0, 0, 0, 0, 0, c.p2, c.p1}}}},
          {"Location", location},
          {"SensorWidth", sensor_width},
          {"SensorHeight", sensor_height},
          {"Rt", {{"Rotation", rotation}, {"Translation", translation}}}};
}

std::string calibration_json(const SensorCalibration& calibration) {
  const nlohmann::json cameras = {
      camera_json(calibration.depth, {}, "CALIBRATION_CameraLocationD0", 1024, 1024, 192, 180, 1024,
                  1024),
      camera_json(calibration.color, calibration.color_from_depth, "CALIBRATION_CameraLocationPV0",
                  1920, 1440, 0, 180, 4096, 3072)};
  return nlohmann::json{{"CalibrationInformation", {{"Cameras", cameras}}}}.dump();
}

FixtureBytes big_endian(const DepthImage& depth) {
  FixtureBytes bytes;
  bytes.reserve(2 * depth.view().pixel_count());
  for (std::size_t i = 0; i < depth.view().pixel_count(); ++i)
    matroska::append_big(bytes, depth.data()[i], 2);
  return bytes;
}

bool write_recording(const std::string& rig, const std::string& name,
                     const std::filesystem::path& file) {
  auto source = open_rig_source(rig, name, {source::Pace::kAsFastAsPossible, false});
  if (!source) return false;
  const SensorCalibration& calibration = (*source)->description().calibration;
  if (calibration.depth.width != 640 || calibration.color.width != 1920) return false;
  using namespace matroska;
  std::vector<FixtureBytes> parts = {
      info(kDate_s * 1'000'000'000),
      element(0x1654AE6B, joined({video_track(2, "DEPTH", "b16g", 640, 576),
                                  video_track(1, "COLOR", "MJPG", 1920, 1080)})),
      element(0x1941A469, attachment("calibration.json", calibration_json(calibration))),
      element(0x1254C367,
              joined({tag("K4A_DEPTH_MODE", "NFOV_UNBINNED"), tag("K4A_COLOR_MODE", "MJPG_1080P"),
                      tag("K4A_DEVICE_SERIAL_NUMBER", name), tag("K4A_DEPTH_DELAY_NS", "0"),
                      tag("K4A_WIRED_SYNC_MODE", name == "s0" ? "MASTER" : "SUBORDINATE"),
                      tag("K4A_START_OFFSET_NS", "0")}))};
  source::CapturedFrame frame;
  io::JpegCodec jpeg;
  for (;;) {
    const auto more = (*source)->next(frame, {});
    if (!more) return false;
    if (!*more) break;
    std::vector<FixtureBytes> blocks = {simple_block(2, 0, big_endian(frame.depth_mm))};
    FixtureBytes color;
    if (!frame.color.empty() && jpeg.encode(frame.color, 90, color).empty())
      blocks.push_back(simple_block(1, 0, color));
    const auto time_us = frame.device_time.count() / 1000;
    parts.push_back(cluster(static_cast<std::uint64_t>(time_us), blocks));
  }
  const FixtureBytes bytes = file_of(parts);
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  return out.good();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto names = rig_sensor_names(argv[1]);
  if (!names) {
    std::fprintf(stderr, "%s\n", names.error().message.c_str());
    return 1;
  }
  for (const std::string& name : *names) {
    const auto file = std::filesystem::path(argv[2]) / (name + ".mkv");
    if (!write_recording(argv[1], name, file)) {
      std::fprintf(stderr, "cannot write %s\n", file.c_str());
      return 1;
    }
    std::printf("%s\n", file.c_str());
  }
  return 0;
}
