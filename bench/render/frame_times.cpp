// SPDX-License-Identifier: Apache-2.0
#include "bench/render/frame_times.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "bench/render/rig_frames.h"
#include "bench/render/truth_view.h"
#include "roomcast/render/gl/gl_context.h"
#include "roomcast/render/room_renderer.h"
#include "roomcast/scene_flow/room_flow.h"

namespace roomcast::bench {
namespace {

constexpr int kPicturesPerFrameSet = 3;  // of a headset of 90 Hz, sensors of 30 frames/s
constexpr nanoseconds kPeriod = std::chrono::milliseconds(33);
constexpr std::size_t kKeptFrameSets = 10;
constexpr double kEyesApart_m = 0.064;
constexpr double kCopyBeside_m = 0.03;
// How the head moves: to each side, in so many pictures to and fro.
constexpr double kSway_m = 0.1, kTurn_rad = std::numbers::pi / 18;
constexpr int kPicturesOfSway = 180;

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// The frames of all sensors of the rig at about one time.
using FrameSet = std::vector<RegisteredFrame>;

Result<std::vector<FrameSet>> read_frame_sets(RigFrames& frames) {
  std::size_t shortest = kKeptFrameSets;
  for (const auto& sensor : frames.sensors())
    shortest = std::min(shortest, sensor.recording.frames.size());
  std::vector<FrameSet> sets(shortest, FrameSet(frames.sensors().size()));
  for (std::size_t i = 0; i < shortest; ++i) {
    for (std::size_t s = 0; s < frames.sensors().size(); ++s) {
      RigFrames::Sensor& sensor = frames.sensors()[s];
      auto status = frames.read(sensor, sensor.recording.frames[i].index, sets[i][s]);
      if (!status) return status.error();
    }
  }
  if (sets.empty()) return Error{ErrorCode::kInvalidArgument, "a sensor of the rig has no frame"};
  return sets;
}

/// The commands between creation and `ms` as the driver timed them.
class GpuTimer {
 public:
  GpuTimer() {
    glGenQueries(1, &query_);
    glBeginQuery(GL_TIME_ELAPSED, query_);
  }
  ~GpuTimer() { glDeleteQueries(1, &query_); }
  GpuTimer(const GpuTimer&) = delete;
  GpuTimer& operator=(const GpuTimer&) = delete;

  /// Once; waits for the commands.
  [[nodiscard]] double ms() const {
    glEndQuery(GL_TIME_ELAPSED);
    GLuint64 elapsed_ns = 0;
    glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &elapsed_ns);
    return 1e-6 * static_cast<double>(elapsed_ns);
  }

 private:
  GLuint query_ = 0;
};

class FrameTimes {
 public:
  FrameTimes(const std::vector<RigFrames::Sensor>& sensors, std::vector<FrameSet> sets,
             const render::ViewCamera& head, const FrameTimesOptions& options)
      : sensors_(sensors), sets_(std::move(sets)), head_(head), options_(options) {
    head_.width = head_.height = options.eye_pixels;
  }

  [[nodiscard]] Result<FrameTimesRow> measure(render::RenderMode mode, int sensors) const;

 private:
  [[nodiscard]] Result<render::RoomRenderer> room_of(render::RenderMode mode, int sensors) const;
  using Motions = std::vector<render::PictureMotion>;  // by sensor
  [[nodiscard]] Motions find_motion(scene_flow::RoomFlow& flow, int number, int sensors) const;
  Status show(render::RoomRenderer& room, int number, const Motions& motions) const;
  static SensorId id_of(std::size_t sensor) { return {static_cast<std::uint16_t>(sensor)}; }
  [[nodiscard]] render::Eyes eyes_at(int picture) const;

  const std::vector<RigFrames::Sensor>& sensors_;
  std::vector<FrameSet> sets_;
  render::ViewCamera head_;
  const FrameTimesOptions& options_;
};

Result<render::RoomRenderer> FrameTimes::room_of(render::RenderMode mode, int sensors) const {
  auto room = render::RoomRenderer::create();
  if (!room) return room;
  render::RenderOptions look;
  look.update_background = render::uses_background_model(mode);
  if (auto status = room->set_options(look); !status) return status.error();
  const std::size_t count = sensors_.size();
  for (std::size_t s = 0; s < static_cast<std::size_t>(sensors); ++s) {
    const RigFrames::Sensor& sensor = sensors_[s % count];
    RigidTransform pose = sensor.world_from_depth;
    pose.translation_m += kCopyBeside_m * static_cast<double>(s / count) * pose.rotation.col(0);
    auto status = room->set_sensor(id_of(s), sensor.recording.camera.calibration.depth, pose);
    if (!status) return status.error();
  }
  return room;
}

/// Valid until the next. The sensors take their pictures one after the other, at even distances.
FrameTimes::Motions FrameTimes::find_motion(scene_flow::RoomFlow& flow, int number,
                                            int sensors) const {
  const FrameSet& set = sets_[static_cast<std::size_t>(number) % sets_.size()];
  Motions motions;
  for (std::size_t s = 0; s < static_cast<std::size_t>(sensors); ++s) {
    const RoomTime time(kPeriod * number + kPeriod * static_cast<int>(s) / sensors);
    const CameraIntrinsics& lens = sensors_[s % sensors_.size()].recording.camera.calibration.depth;
    motions.push_back({time, flow.take(id_of(s), lens, set[s % set.size()].depth_mm, time)});
  }
  return motions;
}

Status FrameTimes::show(render::RoomRenderer& room, int number, const Motions& motions) const {
  const FrameSet& set = sets_[static_cast<std::size_t>(number) % sets_.size()];
  for (std::size_t s = 0; s < motions.size(); ++s) {
    const RegisteredFrame& frame = set[s % set.size()];
    auto status =
        room.upload(id_of(s), frame.depth_mm, frame.color.color, frame.color.seen, motions[s]);
    if (!status) return status;
  }
  return {};
}

/// A head that sways 10 cm and turns 10 degrees to each side in two seconds.
render::Eyes FrameTimes::eyes_at(int picture) const {
  const double phase = std::sin(2 * std::numbers::pi * picture / kPicturesOfSway);
  render::ViewCamera left = head_, right = head_;
  const Eigen::Vector3d aside = head_.world_from_view.rotation.col(0);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(phase * kTurn_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
  for (render::ViewCamera* eye : {&left, &right}) {
    eye->world_from_view.rotation = turn * head_.world_from_view.rotation;
    eye->world_from_view.translation_m += kSway_m * phase * aside;
  }
  left.world_from_view.translation_m -= kEyesApart_m / 2 * (turn * aside);
  right.world_from_view.translation_m += kEyesApart_m / 2 * (turn * aside);
  return {left, right};
}

Result<FrameTimesRow> FrameTimes::measure(render::RenderMode mode, int sensors) const {
  auto room = room_of(mode, sensors);
  if (!room) return room.error();
  const auto target = render::OffscreenTarget::create(head_.width, head_.height, 2);
  if (!target) return target.error();
  scene_flow::RoomFlow flow;
  const auto kept = static_cast<int>(sets_.size());
  for (int i = 0; i < kept; ++i) {  // the background is learnt, and buffers reach their size
    const Motions motions = find_motion(flow, i, sensors);
    if (auto status = show(*room, i, motions); !status) return status.error();
    if (auto status = room->draw(eyes_at(0), *target, mode); !status) return status.error();
  }
  std::vector<double> with_new, without, gpu;
  int picture = 0;
  for (int i = 0; i < options_.frame_sets; ++i) {
    const Motions motions =
        find_motion(flow, kept + i, sensors);  // in the window: on another thread
    for (int j = 0; j < kPicturesPerFrameSet; ++j, ++picture) {
      glFinish();
      const auto begin = Clock::now();
      Status status;
      if (j == 0) status = show(*room, kept + i, motions);
      if (!status) return status.error();
      const GpuTimer timer;
      status = room->draw(eyes_at(picture), *target, mode);
      const double gpu_ms = timer.ms();
      glFinish();
      if (!status) return status.error();
      (j == 0 ? with_new : without).push_back(ms_since(begin));
      if (j > 0) gpu.push_back(gpu_ms);
    }
  }
  return FrameTimesRow{std::string(name_of(mode)), sensors, spread_of(with_new), spread_of(without),
                       spread_of(gpu)};
}

}  // namespace

Status FrameTimesOptions::check() const {
  const auto wrong = [](std::string why) -> Status {
    return Error{ErrorCode::kInvalidArgument, std::move(why)};
  };
  if (sensors.empty()) return wrong("no number of sensors is given");
  for (const int count : sensors) {
    if (count < 1 || count > static_cast<int>(render::kMaxRenderedSensors)) {
      return wrong(
          fmt::format("{} sensors: a room draws 1 to {}", count, render::kMaxRenderedSensors));
    }
  }
  if (!render::is_legal_side(eye_pixels))
    return wrong(fmt::format("an eye cannot be {} pixels wide", eye_pixels));
  if (frame_sets < 1) return wrong("there must be frames to draw");
  return {};
}

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
  };
  return {at(0.5), at(0.95)};
}

Result<FrameTimesReport> run_frame_times(const FrameTimesOptions& options,
                                         const std::function<void(const std::string&)>& progress) {
  if (auto status = options.check(); !status) return status.error();
  auto views = read_truth_views(options.rig);
  if (!views) return views.error();
  if (views->entries.empty()) {
    return Error{ErrorCode::kInvalidArgument, options.rig.string() + " has no true views"};
  }
  auto frames = RigFrames::open(options.rig, views->rig, 1);
  if (!frames) return frames.error();
  auto sets = read_frame_sets(*frames);
  if (!sets) return sets.error();
  auto context = render::EglContext::create();
  if (!context) return context.error();

  FrameTimesReport report;
  report.rig = options.rig.filename().string();
  report.driver = context->driver_name();
  report.eye_pixels = options.eye_pixels;
  FrameTimes times(frames->sensors(), *std::move(sets), views->entries.front().camera, options);
  std::vector<render::RenderMode> modes = options.modes;
  if (modes.empty()) modes.assign(render::kRenderModes.begin(), render::kRenderModes.end());
  for (const int sensors : options.sensors) {
    for (const render::RenderMode mode : modes) {
      if (progress) progress(fmt::format("{} sensors, {}", sensors, name_of(mode)));
      auto row = times.measure(mode, sensors);
      if (!row) return row.error();
      report.rows.push_back(*std::move(row));
    }
  }
  return report;
}

}  // namespace roomcast::bench
