// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/rig/simulate_rig.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "roomcast/core/ordered_parallel.h"
#include "roomcast/core/parallel_rows.h"
#include "roomcast/recording/dataset/rig_writer.h"
#include "roomcast/simulator/rig/rig_truth.h"
#include "roomcast/simulator/rig/rig_views.h"
#include "roomcast/simulator/simulated_sensor.h"
#include "roomcast/simulator/simulated_source.h"
#include "roomcast/simulator/simulated_spec.h"

namespace roomcast::simulator {
namespace {

namespace fs = std::filesystem;

Error invalid(const char* sentence) {
  return {ErrorCode::kInvalidArgument, sentence};
}

Status check(const SimulateRigOptions& options) {
  if (!(options.seconds > 0 && options.seconds <= kMaxSimulatedSeconds))
    return invalid("A simulated recording lasts more than 0 and at most 3600 seconds.");
  if (!(options.fps > 0 && options.fps <= kMaxSimulatedFps))
    return invalid("A simulated recording has more than 0 and at most 120 frames per second.");
  if (!(options.speed >= 0 && options.speed <= kMaxSimulatedSpeed))
    return invalid("Things move at 0 to 10 times their natural speed.");
  if (!(options.timing.lost_share >= 0 && options.timing.lost_share <= 0.5))
    return invalid("At most half of the frames can be lost.");
  if (options.views < 0 || options.views > kMaxSimulatedViews)
    return invalid("There are 0 to 16 free viewpoints.");
  if (options.view_side_px < 16 || options.view_side_px > kMaxSimulatedViewSide)
    return invalid("Pictures from free viewpoints are 16 to 4096 pixels wide.");
  return {};
}

/// One sensor of the recording with its clock and its exposure.
struct Device {
  std::unique_ptr<SimulatedSensor> sensor;
  simulator::FrameClock clock;
  std::vector<float> exposures;  // by frame
};
using Devices = std::vector<Device>;

int frame_count(const SimulateRigOptions& options) {
  return std::max(1, static_cast<int>(std::lround(options.seconds * options.fps)));
}

void report(const SimulateWatcher& watcher, std::string_view doing, int done, int total) {
  if (watcher) watcher({doing, done, total});
}

Result<Devices> open_devices(const std::shared_ptr<const SimulatedRoom>& room,
                             const SimulateRigOptions& options, const SimulateWatcher& watcher,
                             const std::stop_token& stop) {
  Devices devices;
  const int count = std::max(options.sensor_count, 1);
  for (int i = 0; i < count; ++i) {
    report(watcher, "looking at the empty room", i, count);
    auto sensor = SimulatedSensor::open(room, {i,
                                               options.sensor_count,
                                               options.seed,
                                               options.speed,
                                               {options.threads, stop},
                                               options.sensing,
                                               {},
                                               options.fps,
                                               options.timing});
    if (!sensor) return std::move(sensor).error();
    const simulator::FrameClock clock(options.timing, options.fps, (*sensor)->unit().key);
    devices.push_back({*std::move(sensor), clock, {}});
  }
  return devices;
}

Status stopped_before_frames() {
  return Error{ErrorCode::kClosed, "stopped before the first frame"};
}

/// Exposure depends on the previous frames, so it is computed before frames are rendered in
/// parallel.
Status meter(Devices& devices, int frames, int threads, const std::stop_token& stop) {
  const auto meter_one = [&](int, int number) {
    Device& device = devices[static_cast<std::size_t>(number)];
    auto moment = device.sensor->make_moment();
    auto control = device.sensor->auto_exposure();
    for (int i = 0; i < frames && !stop.stop_requested(); ++i) {
      const nanoseconds time = device.clock.true_time(static_cast<std::uint64_t>(i));
      device.exposures.push_back(device.sensor->next_exposure(time, moment, control));
    }
    return Status();
  };
  return run_in_order(static_cast<int>(devices.size()), threads, meter_one, [&](int) {
    return stop.stop_requested() ? stopped_before_frames() : Status();
  });
}

enum class Calibration { kReported, kExact };

std::vector<recording::RigSensor> rig_sensors(const Devices& devices, Calibration which) {
  std::vector<recording::RigSensor> rig;
  for (const Device& device : devices) {
    const SimulatedSensor& sensor = *device.sensor;
    recording::RigSensor entry;
    entry.description.name = "s" + std::to_string(rig.size());
    entry.description.calibration =
        which == Calibration::kExact ? sensor.exact_calibration() : sensor.calibration();
    entry.description.world_from_depth = sensor.world_from_depth();
    entry.clock_offset_s = device.clock.clock_offset_s();
    entry.rate_ppm = device.clock.rate_ppm();
    rig.push_back(std::move(entry));
  }
  return rig;
}

std::string provenance(const SimulateRigOptions& options, const simulator::Room& room) {
  const simulator::Harshness harshness = options.sensing.harsh;
  const std::string camera = harshness == simulator::Harshness::kNone
                                 ? std::string(simulator::name_of(options.sensing.camera))
                                 : "harsh " + std::string(simulator::name_of(harshness));
  return "simulated by roomcast: scene " + room.name + ", seed " + std::to_string(options.seed) +
         ", camera " + camera + (options.sensing.noise ? "" : ", without noise");
}

/// Empty if the sensors are not harsh.
std::vector<HarshTruth> harsh_truth(const SimulateRigOptions& options, const Devices& devices) {
  std::vector<HarshTruth> harsh;
  if (options.sensing.harsh == simulator::Harshness::kNone) return harsh;
  for (const Device& device : devices) {
    const simulator::SensorUnit& unit = device.sensor->unit();
    harsh.push_back({unit.depth_scale, std::string(simulator::name_of(unit.profile.model)),
                     unit.registered_by.has_value()});
  }
  return harsh;
}

/// Renders and writes frames.
class FrameWriter {
 public:
  FrameWriter(const SimulateRigOptions& options, const Devices& devices, recording::RigWriter& rig,
              RigTruth& truth, int threads)
      : options_(options), devices_(devices), rig_(rig), truth_(truth) {
    buffers_.resize(static_cast<std::size_t>(threads));
  }

  /// Task order: all sensors of a frame, then the next frame.
  [[nodiscard]] std::size_t sensor_of(int task) const {
    return static_cast<std::size_t>(task) % devices_.size();
  }
  [[nodiscard]] std::uint64_t frame_of(int task) const {
    return static_cast<std::uint64_t>(task) / devices_.size();
  }

  Status write_pictures(int thread, int task) {
    Buffers& buffers = buffers_[static_cast<std::size_t>(thread)];
    while (buffers.moments.size() < devices_.size())
      buffers.moments.push_back(devices_[buffers.moments.size()].sensor->make_moment());
    const std::size_t number = sensor_of(task);
    const Device& device = devices_[number];
    SimulatedSensor::Moment& moment = buffers.moments[number];
    device.sensor->look(device.clock.true_time(frame_of(task)), moment);
    if (!device.clock.is_lost(frame_of(task))) {
      if (Status written = write_reported(number, frame_of(task), moment, buffers); !written)
        return written;
    }
    return write_truth(number, frame_of(task), moment, buffers);
  }

  Status list(int task) {
    const std::size_t number = sensor_of(task);
    const std::uint64_t frame = frame_of(task);
    const Device& device = devices_[number];
    const nanoseconds time = device.clock.true_time(frame);
    const auto gains = device.sensor->color_gains(device.exposures[frame], time);
    if (Status listed = truth_.list(number, frame, time, gains); !listed) return listed;
    if (device.clock.is_lost(frame)) return rig_.drop(number, frame);
    return rig_.list(number, frame, true, device.clock.stamp(frame));
  }

 private:
  /// The memory of one thread.
  struct Buffers {
    std::vector<SimulatedSensor::Moment> moments;  // by sensor
    source::CapturedFrame frame;
    MaskImage moving;
    ColorImage color;
  };

  Status write_reported(std::size_t number, std::uint64_t frame, SimulatedSensor::Moment& moment,
                        Buffers& buffers) {
    const Device& device = devices_[number];
    buffers.frame.index = frame;
    device.sensor->read_depth(frame, moment, buffers.frame.depth_mm);
    device.sensor->read_color(frame, device.exposures[frame], moment, buffers.frame.color);
    return rig_.write_pictures(number, buffers.frame);
  }

  Status write_truth(std::size_t number, std::uint64_t frame, const SimulatedSensor::Moment& moment,
                     Buffers& buffers) {
    const Device& device = devices_[number];
    if (options_.truth_color) {
      device.sensor->clean_color(device.exposures[frame], moment, buffers.color);
      if (Status written = truth_.write_color(number, frame, buffers.color); !written)
        return written;
    }
    device.sensor->mark_moving(moment, buffers.moving);
    return truth_.write_depth(number, frame, device.sensor->clean_depth_mm(moment), buffers.moving);
  }

  const SimulateRigOptions& options_;
  const Devices& devices_;
  recording::RigWriter& rig_;
  RigTruth& truth_;
  std::vector<Buffers> buffers_;
};

Status write_frames(const SimulateRigOptions& options, const Devices& devices, int frames,
                    int threads, recording::RigWriter& rig, RigTruth& truth,
                    const SimulateWatcher& watcher, const std::stop_token& stop) {
  FrameWriter writer(options, devices, rig, truth, threads);
  const int tasks = frames * static_cast<int>(devices.size());
  return run_in_order(
      tasks, threads, [&](int thread, int task) { return writer.write_pictures(thread, task); },
      [&](int task) -> Status {
        if (Status listed = writer.list(task); !listed) return listed;
        report(watcher, "writing frames", task + 1, tasks);
        if (stop.stop_requested() && writer.sensor_of(task + 1) == 0)
          return Error{ErrorCode::kClosed, "stopped; what was written until then can be played"};
        return {};
      });
}

Status write_views(const fs::path& folder, const SimulateRigOptions& options,
                   const SimulatedRoom& room, const Devices& devices, int frames,
                   const SimulateWatcher& watcher, const std::stop_token& stop) {
  if (options.views == 0) return {};
  std::vector<const SimulatedSensor*> sensors;
  std::vector<simulator::FrameClock> clocks;
  for (const Device& device : devices) {
    sensors.push_back(device.sensor.get());
    clocks.push_back(device.clock);
  }
  return write_rig_views(
      folder, room, sensors, clocks,
      {options.views,
       options.view_side_px,
       options.seed,
       options.speed,
       frames,
       {options.threads, stop}},
      [&](int done, int total) { report(watcher, "drawing free views", done, total); });
}

/// Removes the files of a failed run; the folder was empty before.
void remove_contents(const fs::path& directory) {
  std::error_code ignored;
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(directory, ignored)) entries.push_back(entry);
  for (const fs::path& entry : entries) fs::remove_all(entry, ignored);
}

Status write_rig(const fs::path& directory, const SimulateRigOptions& options,
                 const SimulatedRoom& room, const Devices& devices, recording::RigWriter& rig,
                 const SimulateWatcher& watcher, const std::stop_token& stop) {
  const std::string source = provenance(options, room.room());
  const int threads = thread_count(options.threads);
  const int frames = frame_count(options);
  auto truth =
      RigTruth::create(directory / "truth", options.fps, rig_sensors(devices, Calibration::kExact),
                       source, options.truth_color, harsh_truth(options, devices));
  if (!truth) return std::move(truth).error();
  Status written = write_frames(options, devices, frames, threads, rig, *truth, watcher, stop);
  if (written)
    written = write_views(directory / "truth", options, room, devices, frames, watcher, stop);
  if (!written && written.error().code != ErrorCode::kClosed) return written;
  if (Status finished = rig.finish(); !finished) return finished;
  return written;
}

}  // namespace

Status simulate_rig(const fs::path& directory, const SimulateRigOptions& options,
                    const SimulateWatcher& watcher, std::stop_token stop) {
  if (Status legal = check(options); !legal) return legal;
  auto room = SimulatedRoom::build(options.scene, options.seed);
  if (!room) return std::move(room).error();
  auto devices = open_devices(*room, options, watcher, stop);
  if (!devices && stop.stop_requested()) return stopped_before_frames();
  if (!devices) return std::move(devices).error();
  Status metered = meter(*devices, frame_count(options), thread_count(options.threads), stop);
  if (!metered) return metered;
  auto rig = recording::RigWriter::create(
      directory, options.fps, rig_sensors(*devices, Calibration::kReported),
      {provenance(options, (*room)->room()), devices->front().sensor->unit().jpeg_quality});
  if (!rig) return std::move(rig).error();
  Status written = write_rig(directory, options, **room, *devices, *rig, watcher, stop);
  if (!written && written.error().code != ErrorCode::kClosed) remove_contents(directory);
  return written;
}

}  // namespace roomcast::simulator
