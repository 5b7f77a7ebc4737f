// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/rig_import.h"

#include <chrono>
#include <optional>
#include <utility>

#include "roomcast/core/assert.h"
#include "roomcast/recording/dataset/rig_writer.h"

namespace roomcast::recording {
namespace {

using Files = std::vector<std::unique_ptr<SensorFile>>;

std::vector<RigSensor> rig_sensors(const Files& files, const RoomTimeline& timeline,
                                   const std::vector<std::string>& names) {
  std::vector<RigSensor> sensors;
  for (std::size_t i = 0; i < files.size(); ++i) {
    RigSensor sensor;
    sensor.description = files[i]->info().description;
    sensor.description.name = names[i];
    sensor.has_color = files[i]->info().has_color;
    sensor.clock_offset_s = std::chrono::duration<double>(timeline.clock_offsets[i]).count();
    sensors.push_back(std::move(sensor));
  }
  return sensors;
}

class Importer {
 public:
  Importer(RigWriter writer, const Files& files, const RoomTimeline& timeline,
           const std::vector<std::string>& names)
      : writer_(std::move(writer)), files_(files), timeline_(timeline), next_(files.size(), 0) {
    for (const std::string& name : names) sensors_.push_back({.name = name});
  }

  [[nodiscard]] std::uint64_t frames_in_all() const {
    std::uint64_t frames = 0;
    for (const auto& file : files_) frames += file->info().times.size();
    return frames;
  }

  /// The sensor whose next frame is the earliest; nothing at the end.
  [[nodiscard]] std::optional<std::size_t> earliest() const {
    std::optional<std::size_t> best;
    nanoseconds best_time{};
    for (std::size_t i = 0; i < files_.size(); ++i) {
      const auto& times = files_[i]->info().times;
      if (next_[i] == times.size()) continue;
      const nanoseconds time = times[next_[i]] - timeline_.clock_offsets[i];
      if (!best || time < best_time) best = i, best_time = time;
    }
    return best;
  }

  /// Writes the next frame of a sensor. Only errors of writing are returned; damage is counted.
  [[nodiscard]] Status write_next(std::size_t sensor) {
    const std::size_t number = next_[sensor]++;
    SensorFile& file = *files_[sensor];
    ImportedSensor& imported = sensors_[sensor];
    frame_.index = number;
    if (Status read = file.read_depth(number, frame_.depth_mm); !read) {
      note_damage(imported, read.error());
      return {};
    }
    read_color(file, number, imported);
    const Status written = jpeg_.empty() ? writer_.write_pictures(sensor, frame_)
                                         : writer_.write_pictures(sensor, frame_, jpeg_);
    if (!written) return written;
    const bool has_color = !jpeg_.empty() || !frame_.color.empty();
    imported.frames += 1;
    imported.colors += has_color ? 1 : 0;
    return writer_.list(sensor, number, has_color, file.info().times[number]);
  }

  [[nodiscard]] Result<std::vector<ImportedSensor>> finish() {
    if (Status status = writer_.finish(); !status) return status.error();
    return std::move(sensors_);
  }

 private:
  static void note_damage(ImportedSensor& sensor, const Error& error) {
    if (sensor.damaged++ == 0) sensor.first_damage = error.message;
  }

  void read_color(SensorFile& file, std::size_t number, ImportedSensor& imported) {
    frame_.color = {};
    if (Status read = file.read_jpeg(number, jpeg_); !read) {
      jpeg_.clear();
      return note_damage(imported, read.error());
    }
    if (!jpeg_.empty()) return;
    if (Status read = file.read_color(number, frame_.color); !read) {
      frame_.color = {};
      note_damage(imported, read.error());
    }
  }

  RigWriter writer_;
  const Files& files_;
  const RoomTimeline& timeline_;
  std::vector<std::size_t> next_;
  std::vector<ImportedSensor> sensors_;
  source::CapturedFrame frame_;     // reused
  std::vector<std::uint8_t> jpeg_;  // reused
};

}  // namespace

Result<std::vector<ImportedSensor>> import_rig(const std::filesystem::path& directory,
                                               const Files& files, const RoomTimeline& timeline,
                                               const RigImportOptions& options,
                                               std::stop_token stop) {
  ROOMCAST_ASSERT(options.names.size() == files.size());
  const auto sensors = rig_sensors(files, timeline, options.names);
  auto writer =
      RigWriter::create(directory, timeline.fps, sensors, {options.source, options.jpeg_quality});
  if (!writer) return writer.error();
  Importer importer(*std::move(writer), files, timeline, options.names);
  const std::uint64_t total = importer.frames_in_all();
  for (std::uint64_t done = 0; const auto sensor = importer.earliest();) {
    if (stop.stop_requested())
      return Error{ErrorCode::kClosed, "interrupted; " + directory.string() +
                                           " ends here and can be played, but not continued"};
    if (Status status = importer.write_next(*sensor); !status) return status.error();
    if (options.progress) options.progress(++done, total);
  }
  return importer.finish();
}

}  // namespace roomcast::recording
