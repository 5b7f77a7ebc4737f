// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/frames_rig.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <system_error>
#include <utility>

#include "roomcast/alignment/bundle/bundle_capture.h"
#include "roomcast/io/json_fields.h"
#include "roomcast/recording/dataset/recording.h"
#include "roomcast/recording/playback/recording_source.h"

namespace roomcast::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFramesOfBundle = 120;  // bounds memory
constexpr const char* kBallFile = "ball.json";

Result<alignment::CalibrationBundle> bundle_of(const recording::Recording& recording,
                                               const bench::FrameWindow& window) {
  recording::Recording part = recording;
  std::erase_if(part.frames, [&](const recording::RecordedFrame& frame) {
    return frame.index < window.first || frame.index - window.first >= window.count;
  });
  if (part.frames.size() > kMaxFramesOfBundle) part.frames.resize(kMaxFramesOfBundle);
  if (part.frames.empty())
    return Error{ErrorCode::kUnavailable, "the recording has no frames of that window"};
  alignment::BundleCaptureOptions options;
  options.frames = part.frames.size();
  alignment::BundleCapture capture(part.description.name, part.description.calibration, options);
  const std::size_t count = part.frames.size();
  recording::RecordingSource source(std::move(part), {source::Pace::kAsFastAsPossible, false}, {});
  source::CapturedFrame frame;
  for (std::size_t i = 0; i < count; ++i) {
    const auto more = source.next(frame, {});
    if (!more) return more.error();
    if (!*more) break;
    const double time_s =
        std::chrono::duration<double>(frame.capture_time.time_since_epoch()).count();
    if (const auto added = capture.add(frame.depth_mm, frame.color, time_s); !added)
      return added.error();
  }
  return capture.finish();
}

std::vector<bench::BallSighting> sightings_in(const io::JsonFields& fields,
                                              const std::vector<std::string>& sensors) {
  std::vector<bench::BallSighting> ball;
  for (const io::JsonFields& entry : fields.objects("ball")) {
    const auto sensor = std::ranges::find(sensors, entry.text("sensor"));
    const double frame = entry.number("frame");
    const std::vector<double> center_mm = entry.numbers("center_in_depth_camera_mm");
    if (sensor == sensors.end()) entry.reject("sensor", "is not a sensor of the rig");
    if (!(frame >= 0 && frame < 1e9)) entry.reject("frame", "must be a frame number");
    if (center_mm.size() != 3) {
      entry.reject("center_in_depth_camera_mm", "must be three numbers");
      continue;
    }
    ball.push_back({static_cast<std::size_t>(sensor - sensors.begin()),
                    frame >= 0 && frame < 1e9 ? static_cast<std::uint64_t>(frame) : 0,
                    Eigen::Vector3d(center_mm[0], center_mm[1], center_mm[2]) / 1000});
  }
  if (ball.size() > kMaxBallSightings) fields.reject("ball", "has too many entries");
  return ball;
}

Result<std::vector<bench::BallSighting>> read_ball(const fs::path& path,
                                                   const std::vector<std::string>& sensors) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return std::vector<bench::BallSighting>();
  const auto json = io::read_json_object(path);
  if (!json) return json.error();
  io::JsonProblems problems(path);
  auto ball = sightings_in(io::JsonFields(*json, "", problems), sensors);
  if (const Status legal = problems.status(); !legal) return legal.error();
  return ball;
}

}  // namespace

Result<bench::FramesRig> read_frames_rig(const fs::path& directory) {
  const auto names = recording::rig_sensor_names(directory.string());
  if (!names) return names.error();
  bench::FramesRig rig;
  rig.name = directory.filename().string();
  rig.sensors = *names;
  auto recordings = std::make_shared<std::vector<recording::Recording>>();
  for (const std::string& name : *names) {
    auto recording = recording::read_rig_recording(directory, name);
    if (!recording) return recording.error();
    rig.world_from_depth.push_back(recording->description.world_from_depth);
    for (const auto& frame : recording->frames) rig.frames = std::max(rig.frames, frame.index + 1);
    recordings->push_back(*std::move(recording));
  }
  auto ball = read_ball(directory / kBallFile, rig.sensors);
  if (!ball) return ball.error();
  rig.ball = *std::move(ball);
  rig.bundle = [recordings](std::size_t sensor, const bench::FrameWindow& window) {
    return bundle_of((*recordings)[sensor], window);
  };
  return rig;
}

}  // namespace roomcast::cli
