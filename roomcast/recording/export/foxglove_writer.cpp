// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/foxglove_writer.h"

#include <array>
#include <charconv>
#include <utility>

namespace roomcast::recording {
namespace {

constexpr std::uint32_t kPicturesPerKey = 60;
constexpr int kVideoKbitPerSecond = 4000;
constexpr const char* kProtobuf = "protobuf";

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Reads again as the same number.
std::string shortest_text(double number) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), written.ptr};
}

recording::mcap::SchemaId add_schema(recording::mcap::Writer& writer, FoxgloveKind kind) {
  const FoxgloveSchema schema = foxglove_schema(kind);
  return writer.add_schema(schema.name, kProtobuf, bytes_of(schema.files));
}

}  // namespace

Result<FoxgloveWriter> FoxgloveWriter::create(const std::filesystem::path& path,
                                              const std::vector<SetSensor>& sensors,
                                              nanoseconds began_at, UpAxis up) {
  auto writer = recording::mcap::Writer::create(path);
  if (!writer) return writer.error();
  FoxgloveWriter foxglove(std::move(*writer), began_at, up);
  foxglove.add_channels(sensors);
  return foxglove;
}

void FoxgloveWriter::add_channels(const std::vector<SetSensor>& sensors) {
  points_ = writer_.add_channel(add_schema(writer_, FoxgloveKind::kPoints), "/points", kProtobuf);
  transforms_ = writer_.add_channel(add_schema(writer_, FoxgloveKind::kTransform), "/tf", kProtobuf,
                                    {{"up", up_ == UpAxis::kY ? "y" : "z"}});
  const auto video = add_schema(writer_, FoxgloveKind::kVideo);
  const auto depth = add_schema(writer_, FoxgloveKind::kDepth);
  const auto camera = add_schema(writer_, FoxgloveKind::kCamera);
  for (const SetSensor& sensor : sensors) {
    SensorChannels channels;
    channels.sensor = sensor;
    channels.video = writer_.add_channel(video, "/" + sensor.name + "/color", kProtobuf);
    channels.depth = writer_.add_channel(depth, "/" + sensor.name + "/depth", kProtobuf,
                                         {{"fps", shortest_text(sensor.fps)}});
    channels.camera = writer_.add_channel(camera, "/" + sensor.name + "/camera", kProtobuf);
    sensors_.push_back(std::move(channels));
  }
}

Status FoxgloveWriter::add(const FrameSet& set, const PointCloud& cloud) {
  for (const SetFrame& frame : set.frames) {
    if (auto status = add_sensor(frame); !status) return status;
  }
  const nanoseconds time = began_at_ + set.time;
  return write(points_, points_message(cloud, up_, time), time);
}

Status FoxgloveWriter::add_sensor(const SetFrame& frame) {
  SensorChannels& channels = sensors_[frame.sensor];
  if (channels.last == frame.pictures) return {};  // frame repeated from an earlier set
  channels.last = frame.pictures;
  const std::string& name = channels.sensor.name;
  const nanoseconds time = began_at_ + frame.time;
  if (frame.world_from_depth) {
    const std::string pose = transform_message(name, *frame.world_from_depth, up_, time);
    if (auto status = write(transforms_, pose, time); !status) return status;
  }
  if (auto status = write(channels.camera, camera_message(channels.sensor, time), time); !status)
    return status;
  const std::string depth = depth_message(name, frame.pictures->depth_mm, time);
  if (auto status = write(channels.depth, depth, time); !status) return status;
  return frame.pictures->color.empty() ? Status() : add_video(channels, frame);
}

Status FoxgloveWriter::add_video(SensorChannels& channels, const SetFrame& frame) {
  if (!channels.encoder) {
    codec::FrameEncoderOptions options;
    options.width = channels.sensor.depth.width;
    options.height = channels.sensor.depth.height;
    options.fps = channels.sensor.fps;
    options.color_kbit_per_s = kVideoKbitPerSecond;
    options.temporal_layers = 1;
    auto encoder = codec::Vp9ColorEncoder::create(options);
    if (!encoder) return encoder.error();
    channels.encoder = std::move(*encoder);
  }
  codec::FrameRole role;
  role.key = channels.pictures++ % kPicturesPerKey == 0;
  std::vector<std::uint8_t> bytes;
  auto status =
      channels.encoder->encode(frame.pictures->color, frame.pictures->color_seen, role, bytes);
  if (!status) return status;
  const nanoseconds time = began_at_ + frame.time;
  return write(channels.video, video_message(channels.sensor.name, bytes, time), time);
}

Status FoxgloveWriter::write(recording::mcap::ChannelId channel, const std::string& message,
                             nanoseconds time) {
  return writer_.add_message({.channel = channel,
                              .sequence = sequence_++,
                              .log_time = time,
                              .publish_time = time,
                              .data = bytes_of(message)});
}

}  // namespace roomcast::recording
