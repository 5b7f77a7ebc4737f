// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/rig/rig_truth.h"

#include <cinttypes>
#include <cstdio>
#include <system_error>

#include <nlohmann/json.hpp>

#include "roomcast/io/camera_json.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/image_file.h"
#include "roomcast/io/new_folder.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::simulator {
namespace {

namespace fs = std::filesystem;

std::string numbered(std::uint64_t frame, const char* ending) {
  char name[40];
  std::snprintf(name, sizeof(name), "%06" PRIu64 "%s", frame, ending);
  return name;
}

std::string true_rig(double fps, std::span<const recording::RigSensor> sensors,
                     const std::string& source) {
  recording::RigDescription rig{fps, "truth of: " + source, {}};
  for (const recording::RigSensor& sensor : sensors) {
    const source::SensorDescription& description = sensor.description;
    rig.sensors.push_back({description.name,
                           description.name,
                           description.world_from_depth,
                           sensor.clock_offset_s,
                           sensor.rate_ppm,
                           {}});
  }
  return recording::rig_json_text(rig);
}

/// Adds to each sensor of a rig.json what is true of it as a harsh one.
std::string with_harsh_truth(const std::string& rig_json, std::span<const HarshTruth> harsh) {
  if (harsh.empty()) return rig_json;
  nlohmann::json rig = nlohmann::json::parse(rig_json);
  for (std::size_t i = 0; i < harsh.size(); ++i) {
    nlohmann::json& sensor = rig["sensors"][i];
    sensor["depth_scale"] = harsh[i].depth_scale;
    sensor["camera"] = harsh[i].camera;
    sensor["registers_color"] = harsh[i].registers_color;
  }
  return rig.dump(1) + "\n";
}

}  // namespace

RigTruth::RigTruth(const fs::path& directory, std::span<const recording::RigSensor> sensors) {
  for (const recording::RigSensor& sensor : sensors)
    folders_.push_back(directory / sensor.description.name);
}

Status RigTruth::make_folders(std::size_t sensor, const SensorCalibration& calibration,
                              bool with_color) const {
  const fs::path& folder = folders_[sensor];
  if (Status made = io::make_folder(folder / "moving"); !made) return made;
  if (with_color) {
    if (Status made = io::make_folder(folder / "color"); !made) return made;
  }
  for (const auto& [name, text] :
       {std::pair<const char*, std::string>{"camera.json", io::camera_json_text(calibration)},
        {"times.txt", "# frame true_time_s\n"},
        {"gains.txt", "# frame red green blue, of linear light\n"}}) {
    if (Status written = io::write_file(folder / name, text); !written) return written;
  }
  return {};
}

Result<RigTruth> RigTruth::create(const fs::path& directory, double fps,
                                  std::span<const recording::RigSensor> sensors,
                                  const std::string& source, bool with_color,
                                  std::span<const HarshTruth> harsh) {
  RigTruth truth(directory, sensors);
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    Status made = truth.make_folders(i, sensors[i].description.calibration, with_color);
    if (!made) return std::move(made).error();
  }
  Status written = io::write_file(directory / "rig.json",
                                  with_harsh_truth(true_rig(fps, sensors, source), harsh));
  if (!written) return std::move(written).error();
  return truth;
}

Status RigTruth::write_depth(std::size_t sensor, std::uint64_t frame, DepthView depth_mm,
                             MaskView moving) const {
  const std::string name = numbered(frame, ".png");
  const fs::path& folder = folders_[sensor];
  if (Status written = io::write_depth_png(folder / name, depth_mm); !written) return written;
  return io::write_mask_png(folder / "moving" / name, moving);
}

Status RigTruth::write_color(std::size_t sensor, std::uint64_t frame, ColorView color) const {
  const fs::path path = folders_[sensor] / "color" / numbered(frame, ".jpg");
  return io::write_color_jpeg(path, color, kTruthJpegQuality);
}

Status RigTruth::list(std::size_t sensor, std::uint64_t frame, nanoseconds true_time,
                      const std::array<float, 3>& gains) const {
  char line[96];
  std::snprintf(line, sizeof(line), "%" PRIu64 " %.9f", frame,
                static_cast<double>(true_time.count()) * 1e-9);
  if (Status written = io::append_line(folders_[sensor] / "times.txt", line); !written)
    return written;
  std::snprintf(line, sizeof(line), "%" PRIu64 " %.5f %.5f %.5f", frame,
                static_cast<double>(gains[0]), static_cast<double>(gains[1]),
                static_cast<double>(gains[2]));
  return io::append_line(folders_[sensor] / "gains.txt", line);
}

}  // namespace roomcast::simulator
