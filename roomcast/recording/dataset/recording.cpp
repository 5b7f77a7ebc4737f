// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/dataset/recording.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "roomcast/recording/dataset/rig_json.h"
#include "roomcast/recording/dataset/tum_list.h"

namespace roomcast::recording {
namespace {

namespace fs = std::filesystem;

constexpr double kSecond_ns = 1e9;
constexpr double kFpsOfOneFrame = 30;  // assumed: a single frame gives no rate

nanoseconds seconds(double s) {
  return nanoseconds(std::llround(s * kSecond_ns));
}

/// The number in a file's name: depth/000017.png -> 17.
std::optional<std::uint64_t> number_of(const fs::path& file) {
  const std::string stem = file.stem().string();
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(stem.data(), stem.data() + stem.size(), number);
  if (error != std::errc() || end != stem.data() + stem.size()) return std::nullopt;
  return number;
}

/// True if all file names are numbers in increasing order; these then number the frames.
bool numbered_by_name(const std::vector<ListedFile>& files) {
  std::optional<std::uint64_t> before;
  for (const ListedFile& listed : files) {
    const auto number = number_of(listed.file);
    if (!number || (before && *number <= *before)) return false;
    before = number;
  }
  return true;
}

Result<std::vector<ListedFile>> read_depth_list(const fs::path& folder) {
  auto files = read_tum_list(folder / "depth.txt");
  if (files.ok() && files->empty()) {
    return Error{ErrorCode::kMalformed,
                 (folder / "depth.txt").string() + " lists no frames; it must list at least one"};
  }
  return files;
}

/// The colour file of each depth file; empty if it has none.
Result<std::vector<std::string>> read_color_files(const fs::path& folder,
                                                  const std::vector<ListedFile>& depth_files,
                                                  double fps) {
  std::error_code error;
  if (fs::exists(folder / "associations.txt", error)) {
    auto color_of_depth = read_associations(folder / "associations.txt", depth_files);
    if (!color_of_depth.ok()) return color_of_depth.error();
    std::vector<std::string> files;
    for (const ListedFile& depth : depth_files) files.push_back((*color_of_depth)[depth.file]);
    return files;
  }
  if (!fs::exists(folder / "rgb.txt", error)) return std::vector<std::string>(depth_files.size());
  const auto color_files = read_tum_list(folder / "rgb.txt");
  if (!color_files.ok()) return color_files.error();
  return associate_by_time(depth_files, *color_files, seconds(0.5 / fps));
}

Result<std::vector<RecordedFrame>> read_frames(const fs::path& folder,
                                               const std::vector<ListedFile>& depth_files,
                                               double fps, bool has_color,
                                               nanoseconds clock_offset) {
  std::vector<std::string> color_files(depth_files.size());
  if (has_color) {
    auto listed = read_color_files(folder, depth_files, fps);
    if (!listed.ok()) return listed.error();
    color_files = std::move(*listed);
  }
  const bool by_name = numbered_by_name(depth_files);
  std::vector<RecordedFrame> frames;
  for (std::size_t i = 0; i < depth_files.size(); ++i) {
    RecordedFrame frame;
    frame.index = by_name ? *number_of(depth_files[i].file) : i;
    frame.device_time = depth_files[i].timestamp;
    frame.true_time = frame.device_time - clock_offset;
    frame.depth = folder / depth_files[i].file;
    if (!color_files[i].empty()) frame.color = folder / color_files[i];
    frames.push_back(std::move(frame));
  }
  return frames;
}

/// Rounds to a whole number of frame periods, so that a loop does not shift the frames relative to
/// the room's frame sets.
nanoseconds duration_of(nanoseconds first, nanoseconds last, double fps) {
  const double frames = std::round(double((last - first).count()) / kSecond_ns * fps);
  return seconds((frames + 1) / fps);
}

double median_fps(const std::vector<ListedFile>& files) {
  if (files.size() < 2) return kFpsOfOneFrame;
  std::vector<nanoseconds> gaps;
  for (std::size_t i = 1; i < files.size(); ++i) {
    gaps.push_back(files[i].timestamp - files[i - 1].timestamp);
  }
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return std::min(kSecond_ns / static_cast<double>(middle->count()), kMaxFps);
}

const RigSensorEntry* find_sensor(const RigDescription& rig, const std::string& id) {
  if (id.empty() && rig.sensors.size() == 1) return &rig.sensors.front();
  for (const RigSensorEntry& sensor : rig.sensors) {
    if (sensor.id == id) return &sensor;
  }
  return nullptr;
}

Error no_such_sensor(const fs::path& directory, const RigDescription& rig, const std::string& id) {
  std::string names;
  for (const RigSensorEntry& sensor : rig.sensors) names += (names.empty() ? "" : ", ") + sensor.id;
  const std::string what = id.empty() ? " has several sensors" : " has no sensor " + id;
  return {ErrorCode::kNotFound, directory.string() + what + "; choose one of " + names};
}

/// The interval that all sensors of a rig play, from the earliest first frame to the latest last
/// frame. No sensor restarts while another still plays its end; otherwise people would appear
/// twice.
struct Span {
  nanoseconds start{}, loop_duration{};
};

Result<Span> span_of(const fs::path& directory, const RigDescription& rig) {
  nanoseconds start = nanoseconds::max(), end = nanoseconds::min();
  for (const RigSensorEntry& sensor : rig.sensors) {
    const auto files = read_depth_list(directory / sensor.path);
    if (!files.ok()) return files.error();
    const nanoseconds offset = seconds(sensor.clock_offset_s);
    start = std::min(start, files->front().timestamp - offset);
    end = std::max(end, files->back().timestamp - offset);
  }
  return Span{start, duration_of(start, end, rig.fps)};
}

Result<Recording> read_recording(const fs::path& folder, std::string name, double fps,
                                 const std::vector<ListedFile>& depth_files,
                                 nanoseconds clock_offset) {
  auto camera = io::read_camera_json(folder / "camera.json");
  if (!camera.ok()) return camera.error();
  auto frames = read_frames(folder, depth_files, fps, camera->has_color, clock_offset);
  if (!frames.ok()) return frames.error();
  Recording recording;
  recording.description = {std::move(name), camera->calibration, std::nullopt, fps};
  recording.camera = std::move(*camera);
  recording.frames = std::move(*frames);
  return recording;
}

std::string name_of_folder(const fs::path& directory) {
  std::error_code error;
  const std::string name = fs::weakly_canonical(directory, error).filename().string();
  return is_sensor_name(name) ? name : "tum";
}

}  // namespace

Result<Recording> read_rig_recording(const fs::path& directory, const std::string& id) {
  const auto rig = read_rig_json(directory / "rig.json");
  if (!rig.ok()) return rig.error();
  const RigSensorEntry* const sensor = find_sensor(*rig, id);
  if (sensor == nullptr) return no_such_sensor(directory, *rig, id);
  const auto span = span_of(directory, *rig);
  if (!span.ok()) return span.error();
  const fs::path folder = directory / sensor->path;
  const auto depth_files = read_depth_list(folder);
  if (!depth_files.ok()) return depth_files.error();
  auto recording =
      read_recording(folder, sensor->id, rig->fps, *depth_files, seconds(sensor->clock_offset_s));
  if (!recording.ok()) return recording.error();
  recording->description.world_from_depth = sensor->world_from_depth;
  recording->camera.depth_scale_to_metre *= sensor->depth_scale;
  recording->start = span->start;
  recording->loop_duration = span->loop_duration;
  recording->expected_error_mm = sensor->expected_error_mm;
  recording->scale_error = rig->scale_error;
  return recording;
}

Result<Recording> read_tum_recording(const fs::path& directory) {
  const auto depth_files = read_depth_list(directory);
  if (!depth_files.ok()) return depth_files.error();
  const double fps = median_fps(*depth_files);
  auto recording =
      read_recording(directory, name_of_folder(directory), fps, *depth_files, nanoseconds(0));
  if (!recording.ok()) return recording.error();
  const nanoseconds last = recording->frames.back().true_time;
  recording->start = recording->frames.front().true_time;
  recording->loop_duration = duration_of(recording->start, last, fps);
  return recording;
}

Result<std::vector<std::string>> rig_sensor_names(const std::filesystem::path& directory) {
  const auto rig = read_rig_json(directory / "rig.json");
  if (!rig.ok()) return rig.error();
  std::vector<std::string> names;
  for (const RigSensorEntry& sensor : rig->sensors) names.push_back(sensor.id);
  return names;
}

}  // namespace roomcast::recording
