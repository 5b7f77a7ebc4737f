// SPDX-License-Identifier: Apache-2.0
#include "roomcast/foxglove/topics.h"

#include <algorithm>
#include <utility>

namespace roomcast::foxglove {

using recording::FoxgloveKind;
using recording::SetFrame;
using recording::SetSensor;

Channel Topics::new_channel(std::string topic, FoxgloveKind kind) {
  return {ChannelId{++last_id_}, std::move(topic), kind};
}

bool Topics::set_sensors(const std::vector<SetSensor>& sensors) {
  const bool same = std::ranges::equal(sensors, sensors_, [](const auto& a, const auto& b) {
    return a.name == b.name && a.depth == b.depth;
  });
  if (same && merged_) return false;
  sensors_ = sensors;
  merged_ = std::make_unique<recording::MergedCloud>(sensors, options_.cloud);
  std::map<std::string, SensorTopics> topics;
  bool changed = false;
  for (const SetSensor& sensor : sensors) {
    if (auto known = topics_.extract(sensor.name)) {
      topics.insert(std::move(known));
      continue;
    }
    changed = true;
    const std::string begin = "/" + sensor.name;
    topics.emplace(sensor.name,
                   SensorTopics{new_channel(begin + "/color", FoxgloveKind::kImage),
                                new_channel(begin + "/depth", FoxgloveKind::kDepth),
                                new_channel(begin + "/camera", FoxgloveKind::kCamera), nullptr});
  }
  changed |= !topics_.empty();  // what is left has gone
  topics_ = std::move(topics);
  return changed;
}

std::vector<Channel> Topics::channels() const {
  std::vector<Channel> channels = {points_, transforms_};
  for (const auto& [name, topics] : topics_)
    channels.insert(channels.end(), {topics.color, topics.depth, topics.camera});
  return channels;
}

Status Topics::publish(const recording::FrameSet& set, const std::set<ChannelId>& wanted,
                       const Publish& publish) {
  Status status;
  bool news = false;
  std::vector<recording::NamedPose> poses;
  for (const SetFrame& frame : set.frames) {
    const std::string& name = sensors_[frame.sensor].name;
    if (frame.world_from_depth) poses.push_back({name, *frame.world_from_depth});
    SensorTopics& topics = topics_.at(name);
    if (topics.last == frame.pictures) continue;
    topics.last = frame.pictures;
    news = true;
    if (auto done = publish_sensor(frame, topics, wanted, publish); !done) status = done;
  }
  if (!news) return status;
  if (wanted.contains(transforms_.id))
    publish(transforms_.id, set.time, recording::transforms_message(poses, options_.up, set.time));
  if (wanted.contains(points_.id)) {
    merged_->merge(set, cloud_);
    publish(points_.id, set.time, recording::points_message(cloud_, options_.up, set.time));
  }
  return status;
}

Status Topics::publish_sensor(const SetFrame& frame, const SensorTopics& topics,
                              const std::set<ChannelId>& wanted, const Publish& publish) {
  const SetSensor& sensor = sensors_[frame.sensor];
  if (wanted.contains(topics.camera.id))
    publish(topics.camera.id, frame.time, recording::camera_message(sensor, frame.time));
  if (wanted.contains(topics.depth.id))
    publish(topics.depth.id, frame.time,
            recording::depth_message(sensor.name, frame.pictures->depth_mm, frame.time));
  if (!wanted.contains(topics.color.id) || frame.pictures->color.empty()) return {};
  std::vector<std::uint8_t> jpeg;
  const auto problem = jpeg_.encode(frame.pictures->color, options_.jpeg_quality, jpeg);
  if (!problem.empty())
    return Error{ErrorCode::kMalformed, "no colour picture of " + sensor.name + ": " + problem};
  publish(topics.color.id, frame.time, recording::jpeg_message(sensor.name, jpeg, frame.time));
  return {};
}

}  // namespace roomcast::foxglove
