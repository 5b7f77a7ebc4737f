// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/align/recorded_bundles.h"

#include <chrono>
#include <memory>
#include <utility>

#include "roomcast/recording/dataset/recording.h"
#include "roomcast/recording/playback/recording_source.h"

namespace roomcast::recording {
namespace {

constexpr source::PlaybackOptions kOnce{.pace = source::Pace::kAsFastAsPossible, .loop = false};

Result<RecordedBundle> read_sensor(const std::filesystem::path& rig, const std::string& name,
                                   const alignment::BundleCaptureOptions& options) {
  auto source = open_rig_source(rig.string(), name, kOnce);
  if (!source) return source.error();
  const source::SensorDescription& sensor = (*source)->description();
  alignment::BundleCapture capture(sensor.name, sensor.calibration, options);
  source::CapturedFrame frame;
  for (bool enough = false; !enough;) {
    const auto more = (*source)->next(frame, {});
    if (!more) return more.error();
    if (!*more) break;
    const auto added =
        capture.add(frame.depth_mm, frame.color,
                    std::chrono::duration<double>(frame.capture_time.time_since_epoch()).count());
    if (!added) return added.error();
    enough = *added;
  }
  return RecordedBundle{sensor.name, capture.finish()};
}

RecordedBundle bundle_of_frame(const source::SensorDescription& sensor,
                               const source::CapturedFrame& frame,
                               const alignment::BundleCaptureOptions& options) {
  const std::string name = std::to_string(frame.index);
  alignment::BundleCapture capture(name, sensor.calibration, options);
  const auto added = capture.add(frame.depth_mm, frame.color);
  if (!added) return {name, added.error()};
  return {name, capture.finish()};
}

}  // namespace

Result<std::vector<RecordedBundle>> read_rig_bundles(
    const std::filesystem::path& directory, const ReadProgress& progress,
    const alignment::BundleCaptureOptions& options) {
  const auto names = rig_sensor_names(directory.string());
  if (!names) return names.error();
  std::vector<RecordedBundle> bundles;
  for (const std::string& name : *names) {
    progress("reading " + name);
    auto bundle = read_sensor(directory, name, options);
    if (!bundle) return bundle.error();
    bundles.push_back(std::move(*bundle));
  }
  return bundles;
}

Result<std::map<std::uint64_t, RecordedBundle>> read_frame_bundles(
    const std::filesystem::path& directory, const std::set<std::uint64_t>& frames,
    const ReadProgress& progress, const alignment::BundleCaptureOptions& options) {
  auto source = open_tum_source(directory.string(), kOnce);
  if (!source) return source.error();
  std::map<std::uint64_t, RecordedBundle> bundles;
  source::CapturedFrame frame;
  for (;;) {
    const auto more = (*source)->next(frame, {});
    if (!more) return more.error();
    if (!*more || bundles.size() == frames.size()) break;
    if (frames.count(frame.index) == 0) continue;
    progress("reading frame " + std::to_string(frame.index));
    bundles.emplace(frame.index, bundle_of_frame((*source)->description(), frame, options));
  }
  for (const std::uint64_t wanted : frames) {
    if (bundles.count(wanted) != 0) continue;
    return Error{ErrorCode::kNotFound,
                 directory.string() + " has no frame " + std::to_string(wanted)};
  }
  return bundles;
}

}  // namespace roomcast::recording
