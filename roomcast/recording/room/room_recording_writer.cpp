// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/room/room_recording_writer.h"

#include <utility>

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>

#include "roomcast/recording/room/room_recording.h"
#include "roomcast/recording/room_channels.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::recording {
namespace {

/// Embeds the descriptors, so that any reader of Protobuf schemas understands the messages.
recording::mcap::SchemaId add_schema(recording::mcap::Writer& writer,
                                     const google::protobuf::Descriptor& message) {
  google::protobuf::FileDescriptorSet files;
  message.file()->CopyTo(files.add_file());
  const std::string bytes = files.SerializeAsString();
  return writer.add_schema(message.full_name(), kProtobuf,
                           {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

recording::mcap::SchemaId add_clock_schema(recording::mcap::Writer& writer) {
  constexpr std::string_view kText =
      R"({"type":"object","properties":{)"
      R"("unix_minus_room_ns":{"type":"string"},"error_ns":{"type":"string"}}})";
  return writer.add_schema("roomcast.Clock", "jsonschema",
                           {reinterpret_cast<const std::uint8_t*>(kText.data()), kText.size()});
}

/// No reader could place another message in time.
bool can_be_dated(RoomTime captured_at, const RoomClock& clock) {
  const nanoseconds captured = captured_at.time_since_epoch();
  return is_plausible(captured) && is_plausible(clock.unix_minus_room) &&
         is_plausible(captured + clock.unix_minus_room);
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

RoomRecordingWriter::RoomRecordingWriter(recording::mcap::Writer writer, std::string room,
                                         const std::string& by)
    : writer_(std::move(writer)),
      about_{{"version", std::string(kFormatVersion)}, {"room", std::move(room)}} {
  if (!by.empty()) about_.emplace(kByKey, by);
  schemas_.frame = writer_.add_schema("roomcast.Frame", "", {});
  schemas_.roster = add_schema(writer_, *wire::pb::Roster::descriptor());
  schemas_.poses = add_schema(writer_, *wire::pb::ViewerPoses::descriptor());
  schemas_.marks = add_schema(writer_, *wire::pb::Marks::descriptor());
  schemas_.voice = writer_.add_schema("roomcast.Audio", "", {});
  schemas_.bundle = add_schema(writer_, *wire::pb::CalibrationBundle::descriptor());
  schemas_.clock = add_clock_schema(writer_);
}

Result<RoomRecordingWriter> RoomRecordingWriter::create(const std::filesystem::path& path,
                                                        const std::string& room,
                                                        const std::string& by) {
  auto writer = recording::mcap::Writer::create(path);
  if (!writer) return writer.error();
  RoomRecordingWriter recording(std::move(*writer), room, by);
  if (auto status = recording.writer_.add_metadata(kMetadataName, recording.about_); !status)
    return status.error();
  return recording;
}

/// If there are several such records, the last one takes effect.
Status RoomRecordingWriter::forbid_export() {
  const auto [known, is_new] = about_.insert_or_assign(std::string(kExportKey), kForbidden);
  return is_new ? settle_chunk(writer_.add_metadata(kMetadataName, about_)) : Status();
}

RoomRecordingWriter::Stream& RoomRecordingWriter::stream(std::string_view topic,
                                                         recording::mcap::SchemaId schema,
                                                         std::string_view encoding,
                                                         recording::mcap::StringMap metadata) {
  const auto [found, is_new] = streams_.try_emplace(std::string(topic));
  if (is_new)
    found->second.channel = writer_.add_channel(schema, topic, encoding, std::move(metadata));
  return found->second;
}

Status RoomRecordingWriter::add(Stream& stream, std::span<const std::uint8_t> data,
                                nanoseconds log_time, nanoseconds publish_time) {
  if (writer_.chunk_is_empty()) chunk_began_ = log_time;
  auto status = writer_.add_message({.channel = stream.channel,
                                     .sequence = stream.next_sequence++,
                                     .log_time = log_time,
                                     .publish_time = publish_time,
                                     .data = data});
  status = settle_chunk(status);
  return status ? close_old_chunk(log_time) : status;
}

Status RoomRecordingWriter::add(Stream& stream, const google::protobuf::MessageLite& message,
                                nanoseconds log_time) {
  message.SerializeToString(&scratch_);
  return add(stream, bytes_of(scratch_), log_time, log_time);
}

Status RoomRecordingWriter::settle_chunk(Status status) {
  if (!writer_.chunk_is_empty()) return status;
  const Counts done = std::exchange(in_chunk_, {});
  if (!status) return status;
  written_.frames += done.frames;
  written_.bytes += done.bytes;
  written_.voices += done.voices;
  return status;
}

Status RoomRecordingWriter::close_old_chunk(nanoseconds now) {
  if (writer_.chunk_is_empty() || now - chunk_began_ < kLongestChunk) return {};
  return settle_chunk(writer_.close_chunk());
}

Status RoomRecordingWriter::add_clock(const RoomClock& clock, nanoseconds log_time) {
  clock_ = clock;
  scratch_ = "{\"unix_minus_room_ns\":\"" + std::to_string(clock.unix_minus_room.count()) +
             "\",\"error_ns\":\"" + std::to_string(clock.error.count()) + "\"}";
  return add(stream(kClockTopic, schemas_.clock, kJson), bytes_of(scratch_), log_time, log_time);
}

Status RoomRecordingWriter::add_roster(const wire::pb::Roster& roster, nanoseconds log_time) {
  sensors_.clear();
  frame_streams_.clear();
  for (const auto& sensor : roster.sensors()) {
    sensors_[sensor.id()] = sensor.name();
    frame_streams_[sensor.id()] =
        &stream(frame_topic(sensor.name()), schemas_.frame, kFrameEncoding,
                {{std::string(kSensorKey), sensor.name()}});
  }
  return add(stream(kRosterTopic, schemas_.roster, kProtobuf), roster, log_time);
}

Status RoomRecordingWriter::add_poses(const wire::pb::ViewerPoses& poses, nanoseconds log_time) {
  return add(stream(kPosesTopic, schemas_.poses, kProtobuf), poses, log_time);
}

Status RoomRecordingWriter::add_marks(const wire::pb::Marks& marks, nanoseconds log_time) {
  return add(stream(kMarksTopic, schemas_.marks, kProtobuf), marks, log_time);
}

Status RoomRecordingWriter::add_bundle(const wire::pb::CalibrationBundle& bundle,
                                       nanoseconds log_time) {
  const auto sensor = sensors_.find(bundle.sensor_id());
  if (sensor == sensors_.end()) return {};
  return add(stream(bundle_topic(sensor->second), schemas_.bundle, kProtobuf,
                    {{std::string(kSensorKey), sensor->second}}),
             bundle, log_time);
}

Status RoomRecordingWriter::add_frame(std::span<const std::uint8_t> message, nanoseconds log_time) {
  const auto header = wire::parse_frame(message);
  if (!header || !can_be_dated(header->capture_time, clock_)) return {};
  const auto sensor = frame_streams_.find(header->sensor.value);
  if (sensor == frame_streams_.end()) return {};
  ++in_chunk_.frames;
  in_chunk_.bytes += message.size();
  return add(*sensor->second, message, log_time,
             header->capture_time.time_since_epoch() + clock_.unix_minus_room);
}

Status RoomRecordingWriter::add_voice(std::span<const std::uint8_t> message, nanoseconds log_time) {
  const auto header = wire::parse_audio(message);
  if (!header || !can_be_dated(header->capture_time, clock_)) return {};
  ++in_chunk_.voices;
  return add(stream(kVoicesTopic, schemas_.voice, kVoiceEncoding), message, log_time,
             header->capture_time.time_since_epoch() + clock_.unix_minus_room);
}

Status RoomRecordingWriter::finish() {
  return settle_chunk(writer_.finish());
}

}  // namespace roomcast::recording
