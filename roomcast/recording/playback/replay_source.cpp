// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/playback/replay_source.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "roomcast/client/room/calibration_message.h"
#include "roomcast/client/room/frame_chain.h"
#include "roomcast/codec/depth_grid_color.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/interruptible_wait.h"
#include "roomcast/recording/room/recording_cursor.h"
#include "roomcast/recording/room/room_recording.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::recording {
namespace {

using recording::RecordedMessage;
using recording::RecordedSensor;
using recording::RecordingCursor;
using recording::RoomRecording;

/// Recorded colour is in the depth grid, so the depth camera is described as the colour camera too.
Result<source::SensorDescription> describe(const RoomRecording& recording,
                                           const RecordedSensor& sensor) {
  auto calibration = client::calibration_from_message(sensor.entry.calibration());
  if (!calibration) return calibration.error();
  source::SensorDescription description;
  description.name = sensor.name;
  description.calibration = {calibration->depth, calibration->depth, {}, true};
  description.fps = sensor.entry.fps();
  for (const auto& entry : recording.roster_at(recording.start()).sensors()) {
    if (entry.name() != sensor.name || entry.placement() == wire::pb::PLACEMENT_UNPLACED) continue;
    auto pose = wire::read_transform(entry.world_from_depth());
    if (!pose) return pose.error();
    description.world_from_depth = *pose;
  }
  return description;
}

nanoseconds period_of(double fps) {
  return nanoseconds(static_cast<std::int64_t>(1e9 / fps));
}

/// Over all sensors: each source plays its sensor separately, and all must restart together.
nanoseconds longest_period(const RoomRecording& recording) {
  nanoseconds longest{};
  for (const RecordedSensor& sensor : recording.sensors()) {
    longest = std::max(longest, period_of(sensor.entry.fps()));
  }
  return longest;
}

class ReplaySource final : public source::FrameSource {
 public:
  ReplaySource(RoomRecording recording, const RecordedSensor& sensor,
               source::SensorDescription description, std::unique_ptr<codec::FrameDecoder> decoder,
               const source::PlaybackOptions& options)
      : recording_(std::move(recording)),
        sensor_(sensor),
        description_(std::move(description)),
        decoder_(std::move(decoder)),
        options_(options),
        period_(period_of(description_.fps)),
        length_(recording_.end() - recording_.origin() + longest_period(recording_)),
        cursor_(recording_) {
    begin();
  }

  const source::SensorDescription& description() const override { return description_; }

  Result<bool> next(source::CapturedFrame& frame, std::stop_token stop) override {
    while (!stop.stop_requested()) {
      RecordedMessage recorded;
      const auto more = cursor_.next(recorded);
      if (!more) return more.error();
      if (!*more) {
        if (!options_.loop) return false;
        start_again();
        continue;
      }
      if (recorded.message.channel != sensor_.frames_channel) continue;
      if (!decode(recorded.message.data, frame)) continue;
      frame.capture_time = due(recorded.message.publish_time);
      if (options_.pace == source::Pace::kAsFastAsPossible) return true;
      // Late frames are still decoded, because later frames need them, but only the due one is
      // returned.
      if (SteadyClock().now() - frame.capture_time > period_) continue;
      return wait_until(frame.capture_time, stop);
    }
    return false;
  }

 private:
  void begin() {
    if (options_.pace == source::Pace::kAsFastAsPossible) return;
    const HostTime now = SteadyClock().now();
    round_began_ = now;
    if (!options_.loop) return;
    const nanoseconds position = now.time_since_epoch() % length_;
    round_began_ = now - position;
    cursor_ = RecordingCursor(
        recording_, recording_.chunk_to_decode_from(recording_.origin() + position, {&sensor_, 1}));
  }

  void start_again() {
    cursor_ = RecordingCursor(recording_);
    round_began_ += length_;
    chain_.broke();
  }

  HostTime due(nanoseconds taken) const { return round_began_ + (taken - recording_.origin()); }

  /// False if the message cannot be decoded: after damage, until the next key frame.
  bool decode(std::span<const std::uint8_t> message, source::CapturedFrame& frame) {
    const auto header = wire::parse_frame(message);
    if (!header || !chain_.may_decode(*header)) return false;
    if (!decoder_->decode(message.subspan(header->header_length), decoded_)) {
      chain_.broke();
      return false;
    }
    chain_.decoded(*header);
    if (decoded_.color.empty() || same_size(decoded_.color.view(), decoded_.depth_mm.view())) {
      std::swap(frame.color, decoded_.color);
    } else {
      const auto& grid = description_.calibration.depth;
      frame.color = codec::color_in_depth_grid(decoded_.color, grid.width, grid.height);
    }
    std::swap(frame.depth_mm, decoded_.depth_mm);
    frame.index = index_++;
    frame.device_time = header->capture_time.time_since_epoch();
    return true;
  }

  const RoomRecording recording_;
  const RecordedSensor sensor_;
  const source::SensorDescription description_;
  const std::unique_ptr<codec::FrameDecoder> decoder_;
  const source::PlaybackOptions options_;
  const nanoseconds period_, length_;
  RecordingCursor cursor_;
  HostTime round_began_{};
  client::FrameChain chain_;
  codec::DecodedFrame decoded_;
  std::uint64_t index_ = 0;
};

Error no_such_sensor(const RoomRecording& recording, const std::string& sensor) {
  std::string names;
  for (const auto& known : recording.sensors()) names += (names.empty() ? "" : ", ") + known.name;
  return {ErrorCode::kNotFound, "the recording has no sensor \"" + sensor + "\"; it has " +
                                    (names.empty() ? "none" : names)};
}

}  // namespace

Result<std::unique_ptr<source::FrameSource>> open_replay_source(
    const std::filesystem::path& file, const std::string& sensor,
    const source::PlaybackOptions& options) {
  auto recording = RoomRecording::open(file);
  if (!recording) return recording.error();
  const auto& sensors = recording->sensors();
  const RecordedSensor* found = recording->sensor(sensor);
  if (sensor.empty() && !sensors.empty()) found = &sensors[0];
  if (!found) return no_such_sensor(*recording, sensor);
  auto description = describe(*recording, *found);
  if (!description) return description.error();
  const CameraIntrinsics& grid = description->calibration.depth;
  auto decoder = codec::FrameDecoder::create(grid.width, grid.height);
  if (!decoder) return decoder.error();
  const RecordedSensor chosen = *found;
  return std::unique_ptr<source::FrameSource>(std::make_unique<ReplaySource>(
      std::move(*recording), chosen, std::move(*description), std::move(*decoder), options));
}

Result<std::vector<std::string>> replay_sensor_names(const std::filesystem::path& file) {
  const auto recording = RoomRecording::open(file);
  if (!recording) return recording.error();
  std::vector<std::string> names;
  for (const auto& sensor : recording->sensors()) names.push_back(sensor.name);
  return names;
}

}  // namespace roomcast::recording
