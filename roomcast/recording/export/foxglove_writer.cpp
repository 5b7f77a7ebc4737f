// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/foxglove_writer.h"

#include <bit>
#include <cstring>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>

#include "roomcast/recording/export/foxglove.pb.h"

namespace roomcast::recording {
namespace {

constexpr const char* kWorld = "world";
constexpr std::uint32_t kPicturesPerKey = 60;
constexpr int kVideoKbitPerSecond = 4000;
constexpr std::size_t kPointBytes = 16;  // x, y, z, and blue, green, red, alpha

void write_time(nanoseconds time, google::protobuf::Timestamp& out) {
  out.set_seconds(time.count() / 1'000'000'000);
  out.set_nanos(static_cast<std::int32_t>(time.count() % 1'000'000'000));
}

void write_vector(const Eigen::Vector3d& vector, foxglove::Vector3& out) {
  out.set_x(vector.x());
  out.set_y(vector.y());
  out.set_z(vector.z());
}

void write_rotation(const Eigen::Matrix3d& rotation, foxglove::Quaternion& out) {
  const Eigen::Quaterniond quaternion(rotation);
  out.set_x(quaternion.x());
  out.set_y(quaternion.y());
  out.set_z(quaternion.z());
  out.set_w(quaternion.w());
}

/// Collects a message's file descriptor and its dependencies, dependencies first.
void collect(const google::protobuf::FileDescriptor& file,
             google::protobuf::FileDescriptorSet& out) {
  for (int i = 0; i < file.dependency_count(); ++i) collect(*file.dependency(i), out);
  for (const auto& known : out.file()) {
    if (known.name() == file.name()) return;
  }
  file.CopyTo(out.add_file());
}

template <class Message>
recording::mcap::SchemaId add_schema(recording::mcap::Writer& writer) {
  google::protobuf::FileDescriptorSet files;
  collect(*Message::descriptor()->file(), files);
  const std::string bytes = files.SerializeAsString();
  return writer.add_schema(Message::descriptor()->full_name(), "protobuf",
                           {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

foxglove::PointCloud cloud_message(const PointCloud& cloud, nanoseconds time) {
  using Field = foxglove::PackedElementField;
  foxglove::PointCloud message;
  write_time(time, *message.mutable_timestamp());
  message.set_frame_id(kWorld);
  message.mutable_pose()->mutable_position();
  message.mutable_pose()->mutable_orientation()->set_w(1);
  message.set_point_stride(kPointBytes);
  const auto add_field = [&](const char* name, std::uint32_t offset, Field::NumericType type) {
    Field& field = *message.add_fields();
    field.set_name(name);
    field.set_offset(offset);
    field.set_type(type);
  };
  add_field("x", 0, Field::FLOAT32);
  add_field("y", 4, Field::FLOAT32);
  add_field("z", 8, Field::FLOAT32);
  add_field("red", 14, Field::UINT8);
  add_field("green", 13, Field::UINT8);
  add_field("blue", 12, Field::UINT8);
  add_field("alpha", 15, Field::UINT8);
  std::string& data = *message.mutable_data();
  data.resize(kPointBytes * cloud.size());
  static_assert(std::endian::native == std::endian::little);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    char* const point = data.data() + kPointBytes * i;
    std::memcpy(point, cloud.points_m[i].data(), 12);
    const std::uint8_t color[] = {cloud.colors[i].b, cloud.colors[i].g, cloud.colors[i].r, 255};
    std::memcpy(point + 12, color, 4);
  }
  return message;
}

foxglove::CameraCalibration camera_message(const SetSensor& sensor, nanoseconds time) {
  const CameraIntrinsics& camera = sensor.depth;
  foxglove::CameraCalibration message;
  write_time(time, *message.mutable_timestamp());
  message.set_frame_id(sensor.name);
  message.set_width(static_cast<std::uint32_t>(camera.width));
  message.set_height(static_cast<std::uint32_t>(camera.height));
  message.set_distortion_model("plumb_bob");
  for (const double d : {camera.k1, camera.k2, camera.p1, camera.p2, camera.k3}) message.add_d(d);
  for (const double k : {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0})
    message.add_k(k);
  for (const double r : {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) message.add_r(r);
  for (const double p :
       {camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0})
    message.add_p(p);
  return message;
}

foxglove::FrameTransform transform_message(const std::string& sensor,
                                           const RigidTransform& world_from_depth,
                                           nanoseconds time) {
  foxglove::FrameTransform message;
  write_time(time, *message.mutable_timestamp());
  message.set_parent_frame_id(kWorld);
  message.set_child_frame_id(sensor);
  write_vector(world_from_depth.translation_m, *message.mutable_translation());
  write_rotation(world_from_depth.rotation, *message.mutable_rotation());
  return message;
}

}  // namespace

Result<FoxgloveWriter> FoxgloveWriter::create(const std::filesystem::path& path,
                                              const std::vector<SetSensor>& sensors,
                                              nanoseconds began_at) {
  auto writer = recording::mcap::Writer::create(path);
  if (!writer) return writer.error();
  FoxgloveWriter foxglove(std::move(*writer), began_at);
  foxglove.add_channels(sensors);
  return foxglove;
}

void FoxgloveWriter::add_channels(const std::vector<SetSensor>& sensors) {
  constexpr const char* kProtobuf = "protobuf";
  points_ = writer_.add_channel(add_schema<foxglove::PointCloud>(writer_), "/points", kProtobuf);
  transforms_ =
      writer_.add_channel(add_schema<foxglove::FrameTransform>(writer_), "/tf", kProtobuf);
  const auto video = add_schema<foxglove::CompressedVideo>(writer_);
  const auto camera = add_schema<foxglove::CameraCalibration>(writer_);
  for (const SetSensor& sensor : sensors) {
    SensorChannels channels;
    channels.sensor = sensor;
    channels.video = writer_.add_channel(video, "/" + sensor.name + "/color", kProtobuf);
    channels.camera = writer_.add_channel(camera, "/" + sensor.name + "/camera", kProtobuf);
    sensors_.push_back(std::move(channels));
  }
}

Status FoxgloveWriter::add(const FrameSet& set, const PointCloud& cloud) {
  for (const SetFrame& frame : set.frames) {
    if (auto status = add_sensor(frame); !status) return status;
  }
  const nanoseconds time = began_at_ + set.time;
  return write(points_, cloud_message(cloud, time), time);
}

Status FoxgloveWriter::add_sensor(const SetFrame& frame) {
  SensorChannels& channels = sensors_[frame.sensor];
  if (channels.last == frame.pictures) return {};  // frame repeated from an earlier set
  channels.last = frame.pictures;
  const std::string& name = channels.sensor.name;
  const nanoseconds time = began_at_ + frame.time;
  if (frame.world_from_depth) {
    auto status = write(transforms_, transform_message(name, *frame.world_from_depth, time), time);
    if (!status) return status;
  }
  auto status = write(channels.camera, camera_message(channels.sensor, time), time);
  return status && !frame.pictures->color.empty() ? add_video(channels, frame) : status;
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
  foxglove::CompressedVideo message;
  write_time(time, *message.mutable_timestamp());
  message.set_frame_id(channels.sensor.name);
  message.set_format("vp9");
  message.set_data(bytes.data(), bytes.size());
  return write(channels.video, message, time);
}

Status FoxgloveWriter::write(recording::mcap::ChannelId channel,
                             const google::protobuf::Message& message, nanoseconds time) {
  const std::string bytes = message.SerializeAsString();
  return writer_.add_message(
      {.channel = channel,
       .sequence = sequence_++,
       .log_time = time,
       .publish_time = time,
       .data = {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}});
}

}  // namespace roomcast::recording
