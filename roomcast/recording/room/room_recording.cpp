// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/room/room_recording.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "roomcast/recording/room/recording_summary.h"
#include "roomcast/recording/room_channels.h"
#include "roomcast/wire/control_check.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/parse_message.h"

namespace roomcast::recording {
namespace {

/// Applies the wire format's validation: the file's contents are untrusted.
std::optional<wire::pb::Roster> parse_roster(std::span<const std::uint8_t> bytes) {
  wire::pb::Control control;
  const bool parsed = wire::parse_message(bytes, *control.mutable_roster());
  if (!parsed || !wire::check_control(control)) return std::nullopt;
  return std::move(*control.mutable_roster());
}

bool holds(const recording::mcap::ChunkIndex& chunk, recording::mcap::ChannelId channel) {
  return chunk.message_index_offsets.empty() || chunk.message_index_offsets.contains(channel);
}

}  // namespace

Error export_is_not_allowed() {
  return {ErrorCode::kUnavailable,
          "this room did not let viewers export when it was recorded; ask its owner for that right "
          "and record it again"};
}

Status check_may_be_exported(const RoomRecording& recording) {
  return recording.may_be_exported() ? Status() : Status(export_is_not_allowed());
}

Result<RoomRecording> RoomRecording::open(const std::filesystem::path& path) {
  auto file = recording::mcap::Reader::open(path);
  if (!file) return file.error();
  return from(std::move(*file));
}

Result<RoomRecording> RoomRecording::from(recording::mcap::Reader file) {
  RoomRecording recording(std::move(file));
  if (auto status = recording.read_about(); !status) return status.error();
  if (auto status = check_recorded_times(recording.file_); !status) return status.error();
  if (auto status = recording.read_rosters(); !status) return status.error();
  recording.find_origin();
  recording.find_sensors();
  recording.place_from_the_beginning();
  return recording;
}

Status RoomRecording::read_about() {
  auto about = about_recording(file_);
  if (!about) return about.error();
  room_ = std::move(about->room);
  may_be_exported_ = about->may_be_exported;
  return {};
}

void RoomRecording::find_origin() {
  constexpr nanoseconds kLongestWay = std::chrono::seconds(10);  // from a sensor to the recorder
  origin_ = start();
  const auto first = file_.summary().chunks.empty()
                         ? Result<recording::mcap::ChunkContents>(Error())
                         : file_.chunk(0);
  if (!first) return;
  for (const recording::mcap::Message& message : first->messages) {
    if (kind_of(message.channel) == MessageKind::kFrame && is_plausible(message.publish_time))
      origin_ = std::min(origin_, message.publish_time);
  }
  origin_ = std::max(origin_, start() - kLongestWay);
}

MessageKind RoomRecording::kind_of(recording::mcap::ChannelId id) const {
  const auto found = file_.summary().channels.find(id);
  if (found == file_.summary().channels.end()) return MessageKind::kOther;
  const recording::mcap::Channel& channel = found->second;
  if (channel.topic == kRosterTopic) return MessageKind::kRoster;
  if (channel.topic == kPosesTopic) return MessageKind::kPoses;
  if (channel.topic == kMarksTopic) return MessageKind::kMarks;
  if (channel.topic == kVoicesTopic) return MessageKind::kVoice;
  if (channel.topic == kClockTopic) return MessageKind::kClock;
  if (!channel.topic.starts_with(kSensorPrefix)) return MessageKind::kOther;
  if (channel.message_encoding == kFrameEncoding) return MessageKind::kFrame;
  return channel.topic.ends_with(kBundleSuffix) ? MessageKind::kBundle : MessageKind::kOther;
}

Status RoomRecording::read_rosters() {
  std::set<recording::mcap::ChannelId> channels;
  for (const auto& [id, channel] : file_.summary().channels) {
    if (kind_of(id) == MessageKind::kRoster) channels.insert(id);
  }
  const auto has_roster = [&](const recording::mcap::ChunkIndex& chunk) {
    return std::ranges::any_of(channels,
                               [&](recording::mcap::ChannelId id) { return holds(chunk, id); });
  };
  for (std::size_t i = 0; i < file_.summary().chunks.size(); ++i) {
    if (!has_roster(file_.summary().chunks[i])) continue;
    const auto chunk = file_.chunk(i);
    if (!chunk) continue;  // damaged: RecordingCursor reports it on playback
    for (const recording::mcap::Message& message : chunk->messages) {
      if (!channels.contains(message.channel)) continue;
      if (auto roster = parse_roster(message.data))
        rosters_.push_back({message.log_time, std::move(*roster)});
    }
  }
  if (!rosters_.empty()) return {};
  if (has_frames())
    return Error{ErrorCode::kMalformed, "the recording has frames but no list of sensors"};
  rosters_.push_back({start(), {}});  // it ended before the hub had sent its first list
  return {};
}

bool RoomRecording::has_frames() const {
  return std::ranges::any_of(file_.summary().channels, [this](const auto& channel) {
    return kind_of(channel.first) == MessageKind::kFrame;
  });
}

void RoomRecording::find_sensors() {
  for (const auto& [id, channel] : file_.summary().channels) {
    if (kind_of(id) != MessageKind::kFrame) continue;
    const auto name = channel.metadata.find(std::string(kSensorKey));
    const auto& counts = file_.summary().statistics.channel_message_counts;
    const auto count = counts.find(id);
    if (name == channel.metadata.end() || count == counts.end()) continue;
    RecordedSensor sensor{name->second, id, count->second, {}};
    bool in_roster = false;
    for (const RecordedRoster& moment : rosters_) {
      for (const auto& entry : moment.roster.sensors()) {
        if (entry.name() != sensor.name) continue;
        sensor.entry = entry;
        in_roster = true;
      }
    }
    if (in_roster) sensors_.push_back(std::move(sensor));
  }
  std::ranges::sort(sensors_, {}, &RecordedSensor::name);
}

/// A sensor is placed some seconds after it joins, but its pose was the same from the start.
void RoomRecording::place_from_the_beginning() {
  std::map<std::string, wire::pb::SensorEntry> later;
  for (auto moment = rosters_.rbegin(); moment != rosters_.rend(); ++moment) {
    for (auto& entry : *moment->roster.mutable_sensors()) {
      if (entry.placement() != wire::pb::PLACEMENT_UNPLACED) {
        later[entry.name()] = entry;
      } else if (const auto placed = later.find(entry.name()); placed != later.end()) {
        *entry.mutable_world_from_depth() = placed->second.world_from_depth();
        entry.set_placement(placed->second.placement());
        entry.set_expected_error_mm(placed->second.expected_error_mm());
      }
    }
  }
}

const RecordedSensor* RoomRecording::sensor(const std::string& name) const {
  const auto found = std::ranges::find(sensors_, name, &RecordedSensor::name);
  return found == sensors_.end() ? nullptr : &*found;
}

const wire::pb::Roster& RoomRecording::roster_at(nanoseconds time) const {
  const auto after = std::ranges::upper_bound(rosters_, time, {}, &RecordedRoster::time);
  return (after == rosters_.begin() ? after : after - 1)->roster;
}

std::size_t RoomRecording::chunk_to_decode_from(nanoseconds time,
                                                std::span<const RecordedSensor> sensors) const {
  const auto& chunks = file_.summary().chunks;
  std::set<recording::mcap::ChannelId> without_key;
  for (const RecordedSensor& sensor : sensors) without_key.insert(sensor.frames_channel);
  for (std::size_t i = chunks.size(); i-- > 0;) {
    if (chunks[i].start_time > time) continue;
    const auto chunk = file_.chunk(i);
    if (!chunk) continue;
    for (const recording::mcap::Message& message : chunk->messages) {
      if (message.publish_time > time || !without_key.contains(message.channel)) continue;
      const auto header = wire::parse_frame(message.data);
      if (header && header->key) without_key.erase(message.channel);
    }
    if (without_key.empty()) return i;
  }
  return 0;
}

}  // namespace roomcast::recording
