// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/source_factory.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "roomcast/recording/import/file_source.h"
#include "roomcast/recording/import/open_recording.h"
#include "roomcast/recording/playback/recording_source.h"
#include "roomcast/recording/playback/replay_source.h"
#include "roomcast/ros2/camera/topic_camera.h"
#include "roomcast/sensor/calibrated_source.h"
#include "roomcast/simulator/simulated_source.h"
#include "roomcast/source/camera/camera_source.h"
#include "roomcast/source/drivers/camera_kinds.h"

namespace roomcast::sensor {
namespace {

constexpr const char* kKinds =
    "a source is sim[:scene[,option...]][#sensor], rig:DIR#sensor, tum:DIR, mcap:FILE#sensor, a "
    "recording of another program: mkv:FILE, bag:FILE, ros2:FILE, foxglove:FILE, sens:FILE, "
    "r3d:FILE, cwipc:DIR or pictures:DIR, or a camera: freenect:0, openni2:[FILE.oni], "
    "realsense:[SERIAL], freenect2:[SERIAL], k4a:[SERIAL], or "
    "one of ROS 2: ros2-topic:/DEPTH[,/COLOR]; "
    "for example sim:office,camera=d435#0, rig:house3#s0, tum:kitchen or mcap:lab.mcap#s0";

/// kind[:place][#sensor]. The kind ends at the first ':' or '#'; the sensor's name follows the last
/// '#'.
struct Spec {
  std::string kind, place, sensor;
};

Spec split(const std::string& text) {
  const std::size_t kind_end = std::min(text.find_first_of(":#"), text.size());
  Spec spec{text.substr(0, kind_end), {}, {}};
  std::string rest = text.substr(kind_end);
  const bool has_sensors = spec.kind == "sim" || spec.kind == "rig" || spec.kind == "mcap" ||
                           recording::is_import_kind(spec.kind);
  const std::size_t hash = has_sensors ? rest.rfind('#') : std::string::npos;
  if (hash != std::string::npos) {
    spec.sensor = rest.substr(hash + 1);
    rest.resize(hash);
  }
  if (!rest.empty()) spec.place = rest.substr(1);
  return spec;
}

Error invalid(const std::string& text, const std::string& why) {
  return {ErrorCode::kInvalidArgument, "\"" + text + "\" " + why + ": " + kKinds};
}

std::optional<int> sensor_index(const std::string& text) {
  if (text.empty()) return 0;
  int index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

source::CameraSourceOptions camera_options(const SourceOptions& options) {
  source::CameraSourceOptions camera;
  camera.settings = options.camera;
  camera.settings.loop = options.loop;
  camera.log = options.log;
  return camera;
}

Result<std::unique_ptr<source::FrameSource>> open_kind(const source::CameraKind& kind,
                                                       const std::string& place,
                                                       const SourceOptions& options) {
  if (kind.make == nullptr) {
    return Error{ErrorCode::kUnsupported, "this roomcast was built without " +
                                              std::string(kind.library) + ", which is needed for " +
                                              std::string(kind.cameras) +
                                              "; install it and build again"};
  }
  return source::CameraSource::open(kind.make(), place, camera_options(options));
}

Result<std::unique_ptr<source::FrameSource>> open_ros2_topic(const std::string& place,
                                                             const SourceOptions& options) {
  source::CameraSourceOptions camera = camera_options(options);
  camera.name = ros2::camera_name_of_topic(place);
  return source::CameraSource::open(ros2::topic_camera_backend({.stop = options.stop}), place,
                                    camera);
}

simulator::SimulatedSourceOptions simulated(const SourceOptions& options) {
  return {.pace = options.pace,
          .fps = options.sim_fps,
          .sensor_count = options.sim_sensor_count,
          .seed = options.sim_seed,
          .workers = {0, options.stop}};
}

source::PlaybackOptions playback_of(const SourceOptions& options) {
  return {.pace = options.pace, .loop = options.loop};
}

Result<std::unique_ptr<source::FrameSource>> open_imported(
    const Spec& spec, const source::PlaybackOptions& playback) {
  auto file = recording::open_sensor(spec.kind, spec.place, spec.sensor);
  if (!file) return file.error();
  recording::SensorFiles files;
  files.push_back(*std::move(file));
  auto sources = recording::play_together(std::move(files), playback);
  if (!sources) return sources.error();
  return std::move(sources->sources.front());
}

Result<std::unique_ptr<source::FrameSource>> open_as_it_is(const std::string& text,
                                                           const SourceOptions& options) {
  const Spec spec = split(text);
  if (spec.kind == "sim") {
    const auto index = sensor_index(spec.sensor);
    if (!index) return invalid(text, "has an invalid sensor number");
    return simulator::open_simulated_source(spec.place, *index, simulated(options));
  }
  if (const source::CameraKind* kind = source::camera_kind(spec.kind))
    return open_kind(*kind, spec.place, options);
  if (spec.kind == "ros2-topic") return open_ros2_topic(spec.place, options);
  const bool is_import = recording::is_import_kind(spec.kind);
  const bool is_recording =
      spec.kind == "rig" || spec.kind == "tum" || spec.kind == "mcap" || is_import;
  if (!is_recording) return invalid(text, "is not a source");
  if (spec.place.empty()) return invalid(text, "lacks the name of a recording");
  const source::PlaybackOptions playback = playback_of(options);
  if (is_import) return open_imported(spec, playback);
  if (spec.kind == "mcap") return recording::open_replay_source(spec.place, spec.sensor, playback);
  if (spec.kind == "rig") return recording::open_rig_source(spec.place, spec.sensor, playback);
  return recording::open_tum_source(spec.place, playback);
}

}  // namespace

Result<std::unique_ptr<source::FrameSource>> open_source(const std::string& text,
                                                         const SourceOptions& options) {
  auto source = open_as_it_is(text, options);
  if (!source || options.calibration.empty()) return source;
  return with_calibration(*std::move(source), options.calibration);
}

Result<RecordedRoom> open_recorded_room(const std::vector<std::string>& specs,
                                        const SourceOptions& options,
                                        recording::JoiningClock clock) {
  RecordedRoom room;
  room.sources.resize(specs.size());
  recording::SensorFiles files;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const Spec spec = split(specs[i]);
    if (!recording::is_import_kind(spec.kind) || spec.place.empty()) continue;
    auto file = recording::open_sensor(spec.kind, spec.place, spec.sensor);
    if (!file) return file.error();
    for (const std::string& note : (*file)->info().notes)
      room.notes.push_back(spec.place + ": " + note);
    files.push_back(*std::move(file));
    places.push_back(i);
  }
  if (files.empty()) return room;
  auto played = recording::play_together(std::move(files), playback_of(options), clock);
  if (!played) return played.error();
  if (places.size() > 1) room.clock = std::move(played->clock);
  for (std::size_t i = 0; i < places.size(); ++i)
    room.sources[places[i]] = std::move(played->sources[i]);
  return room;
}

}  // namespace roomcast::sensor
