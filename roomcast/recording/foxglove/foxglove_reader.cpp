// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/foxglove/foxglove_reader.h"

#include <algorithm>

#include "roomcast/recording/foxglove/foxglove.pb.h"
#include "roomcast/wire/parse_message.h"

namespace roomcast::recording {
namespace {

constexpr std::int64_t kLatest_s = 4'294'967'296;  // in the year 2106
constexpr int kNanosOfSecond = 1'000'000'000;

nanoseconds time_of(const google::protobuf::Timestamp& stamp) {
  const bool is_time = stamp.seconds() >= 0 && stamp.seconds() < kLatest_s && stamp.nanos() >= 0 &&
                       stamp.nanos() < kNanosOfSecond;
  return is_time ? std::chrono::seconds(stamp.seconds()) + nanoseconds(stamp.nanos())
                 : nanoseconds(0);
}

template <class Message>
ros::MessageReader::Header header_of(const Message& message) {
  return {time_of(message.timestamp()), message.frame_id()};
}

ros::ByteView view_of(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

template <class Message>
std::optional<ros::CompressedImageMessage> compressed(ros::ByteView bytes, Message& message) {
  if (!wire::parse_message(bytes, message)) return std::nullopt;
  return ros::CompressedImageMessage{header_of(message), message.format(), view_of(message.data())};
}

ros::StampedTransform transform_in(const foxglove::FrameTransform& message) {
  const foxglove::Vector3& t = message.translation();
  const foxglove::Quaternion& q = message.rotation();
  return {message.parent_frame_id(),
          message.child_frame_id(),
          {{t.x(), t.y(), t.z()}, {q.x(), q.y(), q.z(), q.w()}}};
}

}  // namespace

struct FoxgloveReader::Parsed {
  foxglove::RawImage image;
  foxglove::CompressedImage compressed;
  foxglove::CompressedVideo video;
  foxglove::CameraCalibration camera;
  foxglove::FrameTransform transform;
  foxglove::FrameTransforms transforms;
};

FoxgloveReader::FoxgloveReader() : parsed_(std::make_unique<Parsed>()) {}
FoxgloveReader::~FoxgloveReader() = default;

std::optional<ros::ImageMessage> FoxgloveReader::raw_image(ros::ByteView message) {
  foxglove::RawImage& image = parsed_->image;
  if (!wire::parse_message(message, image)) return std::nullopt;
  return ros::ImageMessage{header_of(image),     image.width(), image.height(),
                           image.encoding(),     false,         image.step(),
                           view_of(image.data())};
}

std::optional<ros::CompressedImageMessage> FoxgloveReader::compressed_image(ros::ByteView message) {
  return compressed(message, parsed_->compressed);
}

std::optional<ros::CompressedImageMessage> FoxgloveReader::compressed_video(ros::ByteView message) {
  return compressed(message, parsed_->video);
}

std::optional<ros::CameraInfoMessage> FoxgloveReader::calibration(ros::ByteView message) {
  const foxglove::CameraCalibration& camera = parsed_->camera;
  if (!wire::parse_message(message, parsed_->camera)) return std::nullopt;
  ros::CameraInfoMessage info{
      header_of(camera), camera.width(), camera.height(), camera.distortion_model(), {}, {}, {}};
  const bool has_sizes = static_cast<std::size_t>(camera.d_size()) <= ros::kMaxLensTerms &&
                         static_cast<std::size_t>(camera.k_size()) == info.k.size();
  if (!has_sizes) return std::nullopt;
  info.d.assign(camera.d().begin(), camera.d().end());
  std::ranges::copy(camera.k(), info.k.begin());
  if (static_cast<std::size_t>(camera.p_size()) == info.p.size())
    std::ranges::copy(camera.p(), info.p.begin());
  return info;
}

std::optional<std::vector<ros::StampedTransform>> FoxgloveReader::transform(ros::ByteView message) {
  if (!wire::parse_message(message, parsed_->transform)) return std::nullopt;
  return std::vector{transform_in(parsed_->transform)};
}

std::optional<std::vector<ros::StampedTransform>> FoxgloveReader::transforms(
    ros::ByteView message) {
  if (!wire::parse_message(message, parsed_->transforms)) return std::nullopt;
  const auto& all = parsed_->transforms.transforms();
  if (static_cast<std::size_t>(all.size()) > ros::kMaxTransforms) return std::nullopt;
  std::vector<ros::StampedTransform> transforms(static_cast<std::size_t>(all.size()));
  std::ranges::transform(all, transforms.begin(), transform_in);
  return transforms;
}

}  // namespace roomcast::recording
