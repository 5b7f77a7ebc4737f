// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/camera/picture_topic.h"

#include <utility>

#include "roomcast/ros2/dds/names.h"

namespace roomcast::ros2 {
namespace {

using recording::ros::Serialisation;

/// "/camera/color/image_raw" of "/camera/color/image_raw/compressed".
std::string picture_topic_base(const std::string& name, bool& is_compressed) {
  for (const char* end : {"/compressed", "/compressedDepth"}) {
    is_compressed = name.ends_with(end);
    if (is_compressed) return name.substr(0, name.size() - std::string_view(end).size());
  }
  return name;
}

std::string info_beside(const std::string& base) {
  return base.substr(0, base.rfind('/')) + "/camera_info";
}

}  // namespace

PictureTopic::PictureTopic(std::string name, std::string info_name, bool is_compressed)
    : name_(std::move(name)), info_name_(std::move(info_name)), is_compressed_(is_compressed) {}

Result<std::unique_ptr<PictureTopic>> PictureTopic::open(Participant& participant,
                                                         const std::string& name) {
  if (Status status = check_topic_name(name); !status) return status.error();
  bool is_compressed = false;
  const std::string base = picture_topic_base(name, is_compressed);
  std::unique_ptr<PictureTopic> topic(
      new PictureTopic(name, info_beside(base.empty() ? name : base), is_compressed));
  auto pictures = participant.reader(
      {name, is_compressed ? "sensor_msgs/msg/CompressedImage" : "sensor_msgs/msg/Image",
       kSensorData});
  if (!pictures) return pictures.error();
  topic->pictures_ = *std::move(pictures);
  auto infos = participant.reader({topic->info_name_, "sensor_msgs/msg/CameraInfo", kSensorData});
  if (!infos) return infos.error();
  topic->infos_ = *std::move(infos);
  return topic;
}

void PictureTopic::look_for_camera() {
  while (const Message message = infos_->take()) {
    if (auto info = recording::ros::read_camera_info(*message, Serialisation::kRos2))
      camera_ = *std::move(info);
  }
}

bool PictureTopic::is_rectified() const {
  return name_.find("_rect") != std::string::npos;
}

template <class Picture, class Decode>
Result<std::optional<nanoseconds>> PictureTopic::take_with(Picture& picture, Decode decode) {
  const Message message = pictures_->take();
  if (!message) return std::optional<nanoseconds>();
  ROOMCAST_ASSERT(camera_);
  const auto read = [&](auto image) -> Result<std::optional<nanoseconds>> {
    if (!image) return malformed(name_ + ": a message is damaged");
    if (Status status = decode(*image, static_cast<int>(camera_->width),
                               static_cast<int>(camera_->height), picture);
        !status)
      return Error{status.error().code, name_ + ": " + status.error().message};
    return std::optional<nanoseconds>(image->header.stamp);
  };
  return is_compressed_
             ? read(recording::ros::read_compressed_image(*message, Serialisation::kRos2))
             : read(recording::ros::read_image(*message, Serialisation::kRos2));
}

Result<std::optional<nanoseconds>> PictureTopic::take(DepthImage& depth_mm) {
  return take_with(depth_mm, [this](const auto& image, int width, int height, DepthImage& out) {
    return decoder_.depth(image, width, height, out);
  });
}

Result<std::optional<nanoseconds>> PictureTopic::take(ColorImage& color) {
  return take_with(color, [this](const auto& image, int width, int height, ColorImage& out) {
    return decoder_.color(image, width, height, out);
  });
}

}  // namespace roomcast::ros2
