// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulate_rig.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "roomcast/source/image_file.h"
#include "roomcast/source/rig_writer.h"
#include "roomcast/source/simulator/simulated_sensor.h"
#include "roomcast/source/simulator/simulated_source.h"

namespace roomcast {
namespace {

namespace fs = std::filesystem;

using Sensors = std::vector<std::unique_ptr<SimulatedSensor>>;

Status check(const SimulateRigOptions& options) {
  if (!(options.seconds > 0 && options.seconds <= kMaxSimulatedSeconds)) {
    return Error{ErrorCode::kInvalidArgument,
                 "A simulated recording lasts more than 0 and at most 3600 seconds."};
  }
  if (!(options.fps > 0 && options.fps <= kMaxSimulatedFps)) {
    return Error{ErrorCode::kInvalidArgument,
                 "A simulated recording has more than 0 and at most 120 frames per second."};
  }
  if (!(options.speed >= 0 && options.speed <= kMaxSimulatedSpeed)) {
    return Error{ErrorCode::kInvalidArgument, "Things move at 0 to 10 times their natural speed."};
  }
  return {};
}

Result<Sensors> open_sensors(const SimulateRigOptions& options) {
  Sensors sensors;
  for (int i = 0; i < options.sensor_count || i == 0; ++i) {
    auto sensor = SimulatedSensor::open(
        {options.scene, i, options.sensor_count, options.seed, options.speed});
    if (!sensor) return std::move(sensor).error();
    sensors.push_back(*std::move(sensor));
  }
  return sensors;
}

std::vector<RigSensor> rig_sensors(const Sensors& sensors) {
  std::vector<RigSensor> rig;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    RigSensor sensor;
    sensor.description.name = "s" + std::to_string(i);
    sensor.description.calibration = sensors[i]->calibration();
    sensor.description.world_from_depth = sensors[i]->world_from_depth();
    rig.push_back(std::move(sensor));
  }
  return rig;
}

std::string provenance(const SimulateRigOptions& options, const SimulatedSensor& sensor) {
  return "simulated (roomcast simulate, scene " + sensor.room().name + ", seed " +
         std::to_string(options.seed) + (options.clean ? ", without noise)" : ")");
}

/// The noise-free pictures of one sensor and when they were.
class TruthFolder {
 public:
  static Result<TruthFolder> create(const fs::path& folder, bool with_color) {
    std::error_code error;
    for (const char* name : {"moving", "color"}) {
      if (name == std::string_view("color") && !with_color) continue;
      fs::create_directories(folder / name, error);
      if (error) return cannot_write(folder / name);
    }
    TruthFolder truth(folder);
    truth.times_ << "# frame true_time_s\n";
    if (!truth.times_) return cannot_write(folder / "times.txt");
    return truth;
  }

  Status add(std::uint64_t index, nanoseconds time, DepthView depth_mm, MaskView moving) {
    const std::string name = numbered(index, ".png");
    if (Status written = write_depth_png(folder_ / name, depth_mm); !written) return written;
    if (Status written = write_mask_png(folder_ / "moving" / name, moving); !written)
      return written;
    char line[64];
    std::snprintf(line, sizeof(line), "%llu %.9f\n", static_cast<unsigned long long>(index),
                  static_cast<double>(time.count()) * 1e-9);
    times_ << line << std::flush;
    if (!times_) return cannot_write(folder_ / "times.txt");
    return {};
  }

  Status add_color(std::uint64_t index, ColorView color) {
    return write_color_jpeg(folder_ / "color" / numbered(index, ".jpg"), color, kTruthJpegQuality);
  }

 private:
  static std::string numbered(std::uint64_t index, const char* ending) {
    char name[32];
    std::snprintf(name, sizeof(name), "%06llu%s", static_cast<unsigned long long>(index), ending);
    return name;
  }
  explicit TruthFolder(const fs::path& folder) : folder_(folder), times_(folder / "times.txt") {}
  static Error cannot_write(const fs::path& path) {
    return {ErrorCode::kUnavailable, "Cannot write " + path.string() + "; is the disk full?"};
  }

  fs::path folder_;
  std::ofstream times_;
};

Result<std::vector<TruthFolder>> create_truth(const fs::path& directory, std::size_t count,
                                              bool with_color) {
  std::vector<TruthFolder> folders;
  for (std::size_t i = 0; i < count; ++i) {
    auto folder = TruthFolder::create(directory / "truth" / ("s" + std::to_string(i)), with_color);
    if (!folder) return std::move(folder).error();
    folders.push_back(*std::move(folder));
  }
  return folders;
}

/// Renders and writes one sensor's instant twice: as the sensor reads it, and as it is.
Status write_instant(SimulatedSensor& sensor, std::size_t number, const SimulateRigOptions& options,
                     CapturedFrame& frame, RigWriter& rig, TruthFolder& truth) {
  sensor.render(frame.device_time, frame.index, frame.depth_mm, frame.color, !options.clean);
  if (Status added = rig.add(number, frame, frame.device_time); !added) return added;
  sensor.render(frame.device_time, frame.index, frame.depth_mm, frame.color, false);
  if (options.truth_color) {
    if (Status added = truth.add_color(frame.index, frame.color); !added) return added;
  }
  MaskImage moving;
  sensor.render_moving(frame.device_time, moving);
  return truth.add(frame.index, frame.device_time, frame.depth_mm, moving);
}

}  // namespace

Status simulate_rig(const fs::path& directory, const SimulateRigOptions& options,
                    const std::function<void(int done, int total)>& progress) {
  if (Status legal = check(options); !legal) return legal;
  auto sensors = open_sensors(options);
  if (!sensors) return std::move(sensors).error();
  RigWriterOptions writing;
  writing.source = provenance(options, *sensors->front());
  auto rig = RigWriter::create(directory, options.fps, rig_sensors(*sensors), writing);
  if (!rig) return std::move(rig).error();
  auto truth = create_truth(directory, sensors->size(), options.truth_color);
  if (!truth) return std::move(truth).error();

  const int frames = std::max(1, static_cast<int>(std::lround(options.seconds * options.fps)));
  const int total = frames * static_cast<int>(sensors->size());
  int done = 0;
  CapturedFrame frame;
  for (int i = 0; i < frames; ++i) {
    frame.index = static_cast<std::uint64_t>(i);
    frame.device_time = nanoseconds(std::llround(i * 1e9 / options.fps));
    frame.capture_time = HostTime(frame.device_time);
    for (std::size_t number = 0; number < sensors->size(); ++number) {
      SimulatedSensor& sensor = *(*sensors)[number];
      const Status written = write_instant(sensor, number, options, frame, *rig, (*truth)[number]);
      if (!written) return written;
      if (progress) progress(++done, total);
    }
  }
  return rig->finish();
}

}  // namespace roomcast
