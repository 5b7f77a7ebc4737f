// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/ros/messages.h"

#include <utility>

namespace roomcast::recording::ros {
namespace {

constexpr std::size_t kMinTransformBytes = 64;

TransformMessage take_transform(MessageReader& reader) {
  TransformMessage transform;
  for (double& value : transform.translation) value = reader.f64();
  for (double& value : transform.rotation_xyzw) value = reader.f64();
  return transform;
}

template <class Message>
std::optional<Message> if_ok(const MessageReader& reader, Message message) {
  if (!reader.ok()) return std::nullopt;
  return message;
}

}  // namespace

std::optional<ImageMessage> read_image(ByteView message, Serialisation from) {
  MessageReader reader(message, from);
  ImageMessage image;
  image.header = reader.header();
  image.height = reader.u32();
  image.width = reader.u32();
  image.encoding = reader.text();
  image.is_bigendian = reader.u8() != 0;
  image.step = reader.u32();
  image.data = reader.bytes();
  return if_ok(reader, std::move(image));
}

std::optional<CompressedImageMessage> read_compressed_image(ByteView message, Serialisation from) {
  MessageReader reader(message, from);
  CompressedImageMessage image;
  image.header = reader.header();
  image.format = reader.text();
  image.data = reader.bytes();
  return if_ok(reader, std::move(image));
}

std::optional<CameraInfoMessage> read_camera_info(ByteView message, Serialisation from) {
  MessageReader reader(message, from);
  CameraInfoMessage info;
  info.header = reader.header();
  info.height = reader.u32();
  info.width = reader.u32();
  info.distortion_model = reader.text();
  const std::uint32_t terms = reader.count(sizeof(double));
  if (terms > kMaxLensTerms) return std::nullopt;
  for (std::uint32_t i = 0; i < terms; ++i) info.d.push_back(reader.f64());
  for (double& value : info.k) value = reader.f64();
  for (int i = 0; i < 9; ++i) (void)reader.f64();  // the rotation of stereo cameras
  for (double& value : info.p) value = reader.f64();
  return if_ok(reader, std::move(info));
}

std::optional<KeyValueMessage> read_key_value(ByteView message, Serialisation from) {
  MessageReader reader(message, from);
  KeyValueMessage pair;
  pair.key = reader.text();
  pair.value = reader.text();
  return if_ok(reader, std::move(pair));
}

std::optional<TransformMessage> read_transform(ByteView message, Serialisation from) {
  MessageReader reader(message, from);
  const TransformMessage transform = take_transform(reader);
  return if_ok(reader, transform);
}

std::optional<std::vector<StampedTransform>> read_transforms(ByteView message, Serialisation from) {
  MessageReader reader(message, from);
  const std::uint32_t count = reader.count(kMinTransformBytes);
  if (count > kMaxTransforms) return std::nullopt;
  std::vector<StampedTransform> transforms;
  for (std::uint32_t i = 0; i < count && reader.ok(); ++i) {
    StampedTransform transform;
    transform.parent = reader.header().frame_id;
    transform.child = reader.text();
    transform.parent_from_child = take_transform(reader);
    transforms.push_back(std::move(transform));
  }
  return if_ok(reader, std::move(transforms));
}

}  // namespace roomcast::recording::ros
