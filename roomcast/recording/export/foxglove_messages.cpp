// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/foxglove_messages.h"

#include <bit>
#include <cstring>

#include <Eigen/Geometry>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>

#include "roomcast/recording/foxglove/foxglove.pb.h"

namespace roomcast::recording {
namespace {

constexpr const char* kWorld = "world";
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

const google::protobuf::Descriptor& descriptor_of(FoxgloveKind kind) {
  switch (kind) {
    case FoxgloveKind::kPoints:
      return *foxglove::PointCloud::descriptor();
    case FoxgloveKind::kTransform:
      return *foxglove::FrameTransform::descriptor();
    case FoxgloveKind::kTransforms:
      return *foxglove::FrameTransforms::descriptor();
    case FoxgloveKind::kVideo:
      return *foxglove::CompressedVideo::descriptor();
    case FoxgloveKind::kImage:
      return *foxglove::CompressedImage::descriptor();
    case FoxgloveKind::kDepth:
      return *foxglove::RawImage::descriptor();
    case FoxgloveKind::kCamera:
      break;
  }
  return *foxglove::CameraCalibration::descriptor();
}

void describe_points(foxglove::PointCloud& message) {
  using Field = foxglove::PackedElementField;
  const auto add_field = [&](const char* name, std::uint32_t offset, Field::NumericType type) {
    Field& field = *message.add_fields();
    field.set_name(name);
    field.set_offset(offset);
    field.set_type(type);
  };
  message.set_point_stride(kPointBytes);
  add_field("x", 0, Field::FLOAT32);
  add_field("y", 4, Field::FLOAT32);
  add_field("z", 8, Field::FLOAT32);
  add_field("red", 14, Field::UINT8);
  add_field("green", 13, Field::UINT8);
  add_field("blue", 12, Field::UINT8);
  add_field("alpha", 15, Field::UINT8);
}

template <class Message>
Message stamped(const std::string& frame, nanoseconds time) {
  Message message;
  write_time(time, *message.mutable_timestamp());
  message.set_frame_id(frame);
  return message;
}

void write_transform(const std::string& sensor, const RigidTransform& world_from_depth, UpAxis up,
                     nanoseconds time, foxglove::FrameTransform& message) {
  const RigidTransform upright_from_depth = upright_from_world(up) * world_from_depth;
  write_time(time, *message.mutable_timestamp());
  message.set_parent_frame_id(kWorld);
  message.set_child_frame_id(sensor);
  write_vector(upright_from_depth.translation_m, *message.mutable_translation());
  write_rotation(upright_from_depth.rotation, *message.mutable_rotation());
}

}  // namespace

RigidTransform upright_from_world(UpAxis up) {
  RigidTransform upright;
  if (up == UpAxis::kZ) upright.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return upright;
}

FoxgloveSchema foxglove_schema(FoxgloveKind kind) {
  const google::protobuf::Descriptor& descriptor = descriptor_of(kind);
  google::protobuf::FileDescriptorSet files;
  collect(*descriptor.file(), files);
  return {descriptor.full_name(), files.SerializeAsString()};
}

std::string points_message(const PointCloud& cloud, UpAxis up, nanoseconds time) {
  auto message = stamped<foxglove::PointCloud>(kWorld, time);
  message.mutable_pose()->mutable_position();
  message.mutable_pose()->mutable_orientation()->set_w(1);
  describe_points(message);
  std::string& data = *message.mutable_data();
  data.resize(kPointBytes * cloud.size());
  static_assert(std::endian::native == std::endian::little);
  const Eigen::Matrix3f rotation = upright_from_world(up).rotation.cast<float>();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    char* const point = data.data() + kPointBytes * i;
    const Eigen::Vector3f upright = rotation * cloud.points_m[i];
    std::memcpy(point, upright.data(), 12);
    const std::uint8_t color[] = {cloud.colors[i].b, cloud.colors[i].g, cloud.colors[i].r, 255};
    std::memcpy(point + 12, color, 4);
  }
  return message.SerializeAsString();
}

std::string transform_message(const std::string& sensor, const RigidTransform& world_from_depth,
                              UpAxis up, nanoseconds time) {
  foxglove::FrameTransform message;
  write_transform(sensor, world_from_depth, up, time, message);
  return message.SerializeAsString();
}

std::string transforms_message(std::span<const NamedPose> poses, UpAxis up, nanoseconds time) {
  foxglove::FrameTransforms message;
  for (const NamedPose& pose : poses)
    write_transform(pose.sensor, pose.world_from_depth, up, time, *message.add_transforms());
  return message.SerializeAsString();
}

std::string video_message(const std::string& sensor, std::span<const std::uint8_t> vp9,
                          nanoseconds time) {
  auto message = stamped<foxglove::CompressedVideo>(sensor, time);
  message.set_format("vp9");
  message.set_data(vp9.data(), vp9.size());
  return message.SerializeAsString();
}

std::string jpeg_message(const std::string& sensor, std::span<const std::uint8_t> jpeg,
                         nanoseconds time) {
  auto message = stamped<foxglove::CompressedImage>(sensor, time);
  message.set_format("jpeg");
  message.set_data(jpeg.data(), jpeg.size());
  return message.SerializeAsString();
}

std::string depth_message(const std::string& sensor, DepthView depth_mm, nanoseconds time) {
  auto message = stamped<foxglove::RawImage>(sensor, time);
  const std::size_t row_bytes = sizeof(std::uint16_t) * static_cast<std::size_t>(depth_mm.width);
  message.set_width(static_cast<std::uint32_t>(depth_mm.width));
  message.set_height(static_cast<std::uint32_t>(depth_mm.height));
  message.set_encoding("16UC1");
  message.set_step(static_cast<std::uint32_t>(row_bytes));
  std::string& data = *message.mutable_data();
  data.reserve(row_bytes * static_cast<std::size_t>(depth_mm.height));
  for (int y = 0; y < depth_mm.height; ++y)
    data.append(reinterpret_cast<const char*>(depth_mm.row(y)), row_bytes);
  return message.SerializeAsString();
}

std::string camera_message(const SetSensor& sensor, nanoseconds time) {
  const CameraIntrinsics& camera = sensor.depth;
  auto message = stamped<foxglove::CameraCalibration>(sensor.name, time);
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
  return message.SerializeAsString();
}

}  // namespace roomcast::recording
