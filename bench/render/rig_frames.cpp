// SPDX-License-Identifier: Apache-2.0
#include "bench/render/rig_frames.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace roomcast::bench {

Result<RigFrames> RigFrames::open(const std::filesystem::path& folder,
                                  const recording::RigDescription& rig, int color_scale,
                                  bool fill_holes) {
  RigFrames frames(color_scale, fill_holes);
  for (const recording::RigSensorEntry& entry : rig.sensors) {
    if (!entry.world_from_depth) {
      return Error{ErrorCode::kInvalidArgument, "sensor " + entry.id + " of the rig has no pose"};
    }
    auto recording = recording::read_rig_recording(folder, entry.id);
    if (!recording) return recording.error();
    const io::DepthValues depth_values(recording->camera);
    frames.sensors_.push_back({*std::move(recording), *entry.world_from_depth, depth_values,
                               std::nullopt, std::nullopt, folder / "truth" / entry.id});
  }
  if (auto status = frames.restart(); !status) return status.error();
  return frames;
}

Status RigFrames::restart() {
  for (Sensor& sensor : sensors_) {
    const SensorCalibration& cameras = sensor.recording.camera.calibration;
    auto registration = HoleRegistration::create(cameras, {.color_scale = color_scale_});
    if (!registration) return registration.error();
    sensor.registration = *std::move(registration);
    if (fill_holes_) sensor.completion.emplace(cameras);
  }
  return {};
}

void RigFrames::scale_depth(Sensor& sensor, double factor) {
  io::RecordedCamera& camera = sensor.recording.camera;
  camera.depth_scale_to_metre *= factor;
  camera.depth_bias_m *= factor;
  sensor.depth_values = io::DepthValues(camera);
}

Status RigFrames::read(Sensor& sensor, std::uint64_t number, RegisteredFrame& out) {
  const auto& files = sensor.recording.frames;
  const auto file = std::ranges::find(files, number, &recording::RecordedFrame::index);
  if (file == files.end()) {
    return Error{ErrorCode::kNotFound, fmt::format("the recording lacks frame {}", number)};
  }
  const SensorCalibration& cameras = sensor.recording.camera.calibration;
  const io::ImageSize depth{cameras.depth.width, cameras.depth.height};
  if (auto status = reader_.read_depth(file->depth, depth, out.depth_mm); !status) return status;
  sensor.depth_values.to_mm(out.depth_mm);
  const io::ImageSize color{cameras.color.width, cameras.color.height};
  if (auto status = reader_.read_color(file->color, color, color_); !status) return status;
  if (sensor.completion) sensor.completion->complete(out.depth_mm, color_);
  return sensor.registration->run(out.depth_mm, color_, out.color);
}

std::vector<std::uint64_t> RigFrames::truth_numbers(const Sensor& sensor) {
  std::vector<std::uint64_t> numbers;
  std::error_code error;
  for (const auto& file : std::filesystem::directory_iterator(sensor.truth, error)) {
    const std::string name = file.path().stem().string();
    std::uint64_t number = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
    const bool is_number = read.ec == std::errc() && read.ptr == name.data() + name.size();
    if (is_number && file.path().extension() == ".png") numbers.push_back(number);
  }
  std::ranges::sort(numbers);
  return numbers;
}

Result<TrueSensor> RigFrames::truth(const Sensor& sensor, std::uint64_t number) {
  TrueSensor truth{sensor.recording.camera.calibration, sensor.world_from_depth, {}};
  const CameraIntrinsics& lens = truth.calibration.depth;
  const auto path = sensor.truth / fmt::format("{:06}.png", number);
  if (auto status = reader_.read_depth(path, {lens.width, lens.height}, truth.depth_mm); !status) {
    return status.error();
  }
  return truth;
}

}  // namespace roomcast::bench
