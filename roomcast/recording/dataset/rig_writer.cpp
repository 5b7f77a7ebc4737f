// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/dataset/rig_writer.h"

#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <system_error>
#include <utility>

#include "roomcast/core/assert.h"
#include "roomcast/io/camera_json.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/rig_json.h"
#include "roomcast/recording/dataset/tum_list.h"

namespace roomcast::recording {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxGap = 100'000;  // frames in a row

Error invalid(std::string message) {
  return {ErrorCode::kInvalidArgument, std::move(message)};
}

Error cannot_make(const fs::path& path, const std::error_code& error) {
  return {ErrorCode::kUnavailable,
          "cannot make the folder " + path.string() + ": " + error.message()};
}

Status check_names(std::span<const RigSensor> sensors) {
  if (sensors.empty() || sensors.size() > kMaxRigSensors) {
    return invalid("a rig has 1 to " + std::to_string(kMaxRigSensors) + " sensors");
  }
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const std::string& name = sensors[i].description.name;
    const bool folder_name = is_sensor_name(name) && name.find('/') == std::string::npos &&
                             stays_inside(name) && name != ".";
    if (!folder_name) return invalid("the sensor name \"" + name + "\" cannot be a folder's name");
    for (std::size_t j = 0; j < i; ++j) {
      if (sensors[j].description.name == name) return invalid("two sensors are named " + name);
    }
  }
  return {};
}

Status check_cameras(std::span<const RigSensor> sensors) {
  for (const RigSensor& sensor : sensors) {
    const SensorCalibration& calibration = sensor.description.calibration;
    if (Status status = calibration.depth.check(); !status.ok()) return status;
    if (Status status = calibration.color.check(); !status.ok()) return status;
  }
  return {};
}

Status make_sensor_folders(const fs::path& folder) {
  std::error_code error;
  for (const char* name : {"depth", "rgb"}) {
    fs::create_directories(folder / name, error);
    if (error) return cannot_make(folder / name, error);
    const fs::path list = folder / (std::string(name) + ".txt");
    if (Status status = io::write_file(list, "# timestamp path\n"); !status.ok()) return status;
  }
  return {};
}

std::string numbered(std::uint64_t index, const char* folder, const char* ending) {
  char text[64];
  std::snprintf(text, sizeof(text), "%s/%06" PRIu64 "%s", folder, index, ending);
  return text;
}

std::string list_line(nanoseconds timestamp, const std::string& file) {
  return tum_seconds(timestamp) + " " + file;
}

template <class Picture>
bool has_size(const Picture& picture, const CameraIntrinsics& camera) {
  return picture.width() == camera.width && picture.height() == camera.height;
}

Status write_depth(const fs::path& folder, const CameraIntrinsics& camera,
                   const source::CapturedFrame& frame) {
  if (!has_size(frame.depth_mm, camera)) {
    return invalid("the depth picture differs in size from its calibration");
  }
  return io::write_depth_png(folder / numbered(frame.index, "depth", ".png"), frame.depth_mm);
}

}  // namespace

Status make_empty_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) return cannot_make(path, error);
  const bool empty = fs::is_empty(path, error);
  if (error) return cannot_make(path, error);
  if (!empty) {
    return Error{ErrorCode::kUnavailable,
                 path.string() + " is not empty, and nothing is overwritten; choose a new folder"};
  }
  return {};
}

RigWriter::RigWriter(fs::path directory, double fps, std::vector<RigSensor> sensors,
                     RigWriterOptions options)
    : directory_(std::move(directory)),
      fps_(fps),
      sensors_(std::move(sensors)),
      progress_(sensors_.size()),
      options_(std::move(options)) {}

Result<RigWriter> RigWriter::create(const fs::path& directory, double fps,
                                    std::span<const RigSensor> sensors,
                                    const RigWriterOptions& options) {
  if (!(fps > 0 && fps <= kMaxFps)) return invalid("a rig's fps must be above 0 and at most 240");
  if (options.jpeg_quality < 1 || options.jpeg_quality > 100) {
    return invalid("JPEG quality must be 1 to 100");
  }
  if (Status status = check_names(sensors); !status.ok()) return status.error();
  if (Status status = check_cameras(sensors); !status.ok()) return status.error();
  if (Status status = make_empty_folder(directory); !status.ok()) return status.error();
  RigWriter writer(directory, fps, {sensors.begin(), sensors.end()}, options);
  if (Status status = writer.write_cameras(); !status.ok()) return status.error();
  const std::string unfinished = options.source + " (not finished)";
  if (Status status = writer.write_rig_json(unfinished); !status.ok()) return status.error();
  return writer;
}

Status RigWriter::write_cameras() const {
  for (const RigSensor& sensor : sensors_) {
    const fs::path folder = directory_ / sensor.description.name;
    if (Status status = make_sensor_folders(folder); !status.ok()) return status;
    const std::string text = io::camera_json_text(io::RecordedCamera{
        .calibration = sensor.description.calibration, .has_color = sensor.has_color});
    if (Status status = io::write_file(folder / "camera.json", text); !status.ok()) return status;
  }
  return {};
}

Status RigWriter::write_rig_json(const std::string& source) const {
  RigDescription rig{fps_, source, {}};
  rig.scale_error = options_.scale_error;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const source::SensorDescription& description = sensors_[i].description;
    rig.sensors.push_back({description.name, description.name, description.world_from_depth,
                           sensors_[i].clock_offset_s, sensors_[i].rate_ppm, progress_[i].dropped});
    rig.sensors.back().expected_error_mm = sensors_[i].expected_error_mm;
  }
  return io::write_file(directory_ / "rig.json", rig_json_text(rig));
}

Status RigWriter::check_index(const Progress& progress, std::uint64_t index) {
  if (!progress.started) return {};
  if (index < progress.next_index) return invalid("frame numbers of a sensor must grow");
  if (index - progress.next_index > kMaxGap)
    return invalid("the gap is longer than the largest number of dropped frames in a rig");
  return {};
}

void RigWriter::note_written(Progress& progress, std::uint64_t index) {
  if (!progress.started) progress.next_index = index;
  progress.started = true;
  while (progress.next_index < index) progress.dropped.push_back(progress.next_index++);
  progress.next_index = index + 1;
}

Status RigWriter::write_pictures(std::size_t sensor, const source::CapturedFrame& frame) const {
  ROOMCAST_ASSERT(sensor < sensors_.size());
  const source::SensorDescription& description = sensors_[sensor].description;
  if (!frame.color.empty() && !has_size(frame.color, description.calibration.color)) {
    return invalid("the colour picture differs in size from its calibration");
  }
  const fs::path folder = directory_ / description.name;
  if (Status status = write_depth(folder, description.calibration.depth, frame); !status.ok())
    return status;
  if (frame.color.empty()) return {};
  const fs::path color = folder / numbered(frame.index, "rgb", ".jpg");
  return io::write_color_jpeg(color, frame.color, options_.jpeg_quality);
}

Status RigWriter::write_pictures(std::size_t sensor, const source::CapturedFrame& frame,
                                 std::span<const std::uint8_t> jpeg) const {
  ROOMCAST_ASSERT(sensor < sensors_.size());
  const source::SensorDescription& description = sensors_[sensor].description;
  const fs::path folder = directory_ / description.name;
  if (Status status = write_depth(folder, description.calibration.depth, frame); !status.ok())
    return status;
  return io::write_file(folder / numbered(frame.index, "rgb", ".jpg"), jpeg);
}

Status RigWriter::list(std::size_t sensor, std::uint64_t index, bool has_color,
                       nanoseconds timestamp) {
  ROOMCAST_ASSERT(sensor < sensors_.size());
  if (Status status = check_index(progress_[sensor], index); !status.ok()) return status;
  const fs::path folder = directory_ / sensors_[sensor].description.name;
  if (has_color) {
    const std::string line = list_line(timestamp, numbered(index, "rgb", ".jpg"));
    if (Status status = io::append_line(folder / "rgb.txt", line); !status.ok()) return status;
  }
  const std::string line = list_line(timestamp, numbered(index, "depth", ".png"));
  if (Status status = io::append_line(folder / "depth.txt", line); !status.ok()) return status;
  note_written(progress_[sensor], index);
  return {};
}

Status RigWriter::drop(std::size_t sensor, std::uint64_t index) {
  ROOMCAST_ASSERT(sensor < sensors_.size());
  if (Status status = check_index(progress_[sensor], index); !status.ok()) return status;
  note_written(progress_[sensor], index);
  progress_[sensor].dropped.push_back(index);
  return {};
}

Status RigWriter::add(std::size_t sensor, const source::CapturedFrame& frame,
                      nanoseconds timestamp) {
  ROOMCAST_ASSERT(sensor < sensors_.size());
  if (Status status = check_index(progress_[sensor], frame.index); !status.ok()) return status;
  if (Status status = write_pictures(sensor, frame); !status.ok()) return status;
  return list(sensor, frame.index, !frame.color.empty(), timestamp);
}

Status RigWriter::finish() {
  return write_rig_json(options_.source);
}

}  // namespace roomcast::recording
