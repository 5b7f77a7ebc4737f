// SPDX-License-Identifier: Apache-2.0
#include "bench/line/looped_source.h"

#include <algorithm>
#include <utility>

#include "roomcast/core/interruptible_wait.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::bench {
namespace {

nanoseconds interval_of(double fps) {
  return nanoseconds(static_cast<std::int64_t>(1e9 / fps));
}

nanoseconds phase_of(int index, int count, double fps) {
  return nanoseconds(static_cast<std::int64_t>(1e9 / fps * index / count));
}

}  // namespace

nanoseconds LoopedSource::scene_time(HostTime captured, int index, int count, double fps,
                                     int frame_count) {
  const nanoseconds since_phase = captured.time_since_epoch() - phase_of(index, count, fps);
  const std::int64_t tick = (since_phase + interval_of(fps) / 2) / interval_of(fps);
  return frame_at_place(tick, frame_count) * interval_of(fps);
}

nanoseconds LoopedSource::period(double fps, int frame_count) {
  return 2 * (frame_count - 1) * interval_of(fps);
}

Result<std::unique_ptr<LoopedSource>> LoopedSource::capture(const std::string& scene, int index,
                                                            int count, double fps,
                                                            int frame_count) {
  sensor::SourceOptions options;
  options.pace = source::Pace::kAsFastAsPossible;
  options.sim_fps = fps;
  options.sim_sensor_count = count;
  auto simulated = sensor::open_source("sim:" + scene + "#" + std::to_string(index), options);
  if (!simulated) return simulated.error();
  auto frames = FrameLoop::capture(**simulated, frame_count);
  if (!frames) return frames.error();
  return std::unique_ptr<LoopedSource>(new LoopedSource(
      (*simulated)->description(), *std::move(frames), phase_of(index, count, fps)));
}

Result<bool> LoopedSource::next(source::CapturedFrame& frame, std::stop_token stop) {
  const nanoseconds interval = interval_of(description_.fps);
  const nanoseconds now = SteadyClock().now().time_since_epoch() - phase_;
  last_tick_ = std::max(last_tick_ + 1, now / interval + 1);
  const HostTime due{last_tick_ * interval + phase_};
  if (!wait_until(due, stop)) return false;
  const source::CapturedFrame& captured = frames_.at(last_tick_);
  frame.depth_mm = captured.depth_mm;
  frame.color = captured.color;
  frame.index = static_cast<std::uint64_t>(last_tick_);
  frame.device_time = due.time_since_epoch();
  frame.capture_time = due;
  return true;
}

}  // namespace roomcast::bench
