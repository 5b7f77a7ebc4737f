// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/bridge/room_topics.h"

#include <algorithm>
#include <utility>

#include "roomcast/ros2/dds/names.h"

namespace roomcast::ros2 {
namespace {

using recording::SetFrame;
using recording::SetSensor;

constexpr const char* kImage = "sensor_msgs/msg/Image";
constexpr const char* kCameraInfo = "sensor_msgs/msg/CameraInfo";
constexpr const char* kPointCloud = "sensor_msgs/msg/PointCloud2";

bool is_read(const Writer& writer) {
  return writer.reader_count() > 0;
}

}  // namespace

Status RoomTopicsOptions::check() const {
  if (Status status = cloud.check(); !status) return status;
  return check_topic_name(prefix + "/points");
}

Result<std::unique_ptr<RoomTopics>> RoomTopics::open(Participant& participant,
                                                     RoomTopicsOptions options) {
  std::unique_ptr<RoomTopics> topics(new RoomTopics(participant, std::move(options)));
  auto points = topics->writer("/points", kPointCloud);
  if (!points) return points.error();
  topics->points_ = *std::move(points);
  auto transforms = participant.writer({"/tf_static", "tf2_msgs/msg/TFMessage", kStaticTransforms});
  if (!transforms) return transforms.error();
  topics->transforms_ = *std::move(transforms);
  return topics;
}

Result<std::unique_ptr<Writer>> RoomTopics::writer(const std::string& name,
                                                   const std::string& type) const {
  Quality quality = kSensorData;
  quality.is_reliable = options_.is_reliable;
  return participant_.writer({options_.prefix + name, type, quality});
}

std::string RoomTopics::unused_part(const std::string& sensor) const {
  const std::string part = name_part(sensor);
  std::string unused = part;
  const auto is_used = [&] {
    return unused == "points" || std::ranges::any_of(topics_, [&](const auto& known) {
             return known.second.part == unused;
           });
  };
  for (int number = 2; is_used(); ++number) unused = part + "_" + std::to_string(number);
  return unused;
}

Result<RoomTopics::SensorTopics> RoomTopics::new_topics(const std::string& sensor) const {
  SensorTopics topics;
  topics.part = unused_part(sensor);
  topics.frame = topics.part + "_optical_frame";
  const std::string begin = "/" + topics.part;
  const std::pair<std::unique_ptr<Writer> SensorTopics::*, std::pair<std::string, const char*>>
      writers[] = {
          {&SensorTopics::depth, {begin + "/depth/image_raw", kImage}},
          {&SensorTopics::depth_info, {begin + "/depth/camera_info", kCameraInfo}},
          {&SensorTopics::color, {begin + "/color/image_raw", kImage}},
          {&SensorTopics::color_info, {begin + "/color/camera_info", kCameraInfo}},
          {&SensorTopics::points, {begin + "/points", kPointCloud}},
      };
  for (const auto& [member, topic] : writers) {
    auto opened = writer(topic.first, topic.second);
    if (!opened) return opened.error();
    topics.*member = *std::move(opened);
  }
  return topics;
}

Status RoomTopics::set_sensors(const std::vector<SetSensor>& sensors) {
  const bool same = std::ranges::equal(sensors, sensors_, [](const auto& a, const auto& b) {
    return a.name == b.name && a.depth == b.depth;
  });
  if (same && merged_) return {};
  sensors_ = sensors;
  bool others = merged_ == nullptr;
  merged_ = std::make_unique<recording::MergedCloud>(sensors, options_.cloud);
  const std::size_t gone = std::erase_if(topics_, [&](const auto& known) {
    return std::ranges::find(sensors, known.first, &SetSensor::name) == sensors.end();
  });
  others = others || gone > 0;
  for (const SetSensor& sensor : sensors) {
    if (!topics_.contains(sensor.name)) {
      auto topics = new_topics(sensor.name);
      if (!topics) return topics.error();
      topics_.emplace(sensor.name, *std::move(topics));
      others = true;
    }
    SensorTopics& topics = topics_.at(sensor.name);
    if (topics.camera == sensor.depth) continue;
    topics.camera = sensor.depth;
    topics.rays = ray_table(sensor.depth);
  }
  changes_ += others ? 1 : 0;
  return {};
}

std::vector<std::string> RoomTopics::names() const {
  std::vector<std::string> names = {"/tf_static", options_.prefix + "/points"};
  for (const auto& [sensor, topics] : topics_) {
    for (const char* end : {"/depth/image_raw", "/depth/camera_info", "/color/image_raw",
                            "/color/camera_info", "/points"})
      names.push_back(options_.prefix + "/" + topics.part + end);
  }
  std::ranges::sort(names);
  return names;
}

Status RoomTopics::publish(const recording::FrameSet& set) {
  Status status = publish_poses(set);
  bool is_new = false;
  for (const SetFrame& frame : set.frames) {
    SensorTopics& topics = topics_.at(sensors_[frame.sensor].name);
    if (topics.last == frame.pictures) continue;
    topics.last = frame.pictures;
    is_new = true;
    if (Status done = publish_sensor(frame, topics); !done) status = done;
  }
  if (is_new && is_read(*points_)) {
    merged_->merge(set, cloud_);
    Status done =
        points_->write(world_points(cloud_, recording::upright_from_world(options_.up), set.time));
    if (!done) status = done;
  }
  return status;
}

Status RoomTopics::publish_sensor(const SetFrame& frame, const SensorTopics& topics) const {
  const DepthView depth = frame.pictures->depth_mm;
  const ColorView color = frame.pictures->color;
  Status status;
  const auto write = [&](const std::unique_ptr<Writer>& writer, auto&& make) {
    if (!is_read(*writer)) return;
    if (Status done = writer->write(make()); !done) status = done;
  };
  const auto info = [&] { return camera_info(topics.camera, topics.frame, frame.time); };
  write(topics.depth, [&] { return depth_image(depth, topics.frame, frame.time); });
  write(topics.depth_info, info);
  if (color.data != nullptr) {
    write(topics.color, [&] { return color_image(color, topics.frame, frame.time); });
    write(topics.color_info, info);
  }
  write(topics.points,
        [&] { return sensor_points(depth, color, topics.rays, topics.frame, frame.time); });
  return status;
}

Status RoomTopics::publish_poses(const recording::FrameSet& set) {
  std::vector<FramePose> poses;
  for (const SetFrame& frame : set.frames) {
    if (!frame.world_from_depth) continue;
    poses.push_back({topics_.at(sensors_[frame.sensor].name).frame,
                     recording::upright_from_world(options_.up) * *frame.world_from_depth});
  }
  if (poses == poses_) return {};
  poses_ = std::move(poses);
  return transforms_->write(transforms(poses_, set.time));
}

}  // namespace roomcast::ros2
