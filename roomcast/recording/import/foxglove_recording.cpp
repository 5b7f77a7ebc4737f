// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/foxglove_recording.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "roomcast/recording/dataset/recording.h"
#include "roomcast/recording/dataset/rig_json.h"
#include "roomcast/recording/import/color_pairs.h"
#include "roomcast/recording/import/foxglove_sensor_file.h"
#include "roomcast/recording/import/foxglove_streams.h"
#include "roomcast/recording/import/mcap_store.h"
#include "roomcast/recording/import/ros_lens.h"
#include "roomcast/recording/import/ros_picture.h"
#include "roomcast/recording/import/sensor_name.h"
#include "roomcast/recording/import/topic_name.h"
#include "roomcast/recording/mcap/reader.h"

namespace roomcast::recording {
namespace {

constexpr nanoseconds kLoggingError = std::chrono::milliseconds(100);

RigidTransform world_from_z_up() {
  RigidTransform turned;  // (x, y, z) with z up is (x, z, -y) with y up
  turned.rotation << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return turned;
}

/// "/left" of "/left/depth" and "/left/depth/image".
std::string camera_topic(const std::string& depth_topic) {
  const std::size_t depth_at = depth_topic.rfind("depth");
  return depth_at == std::string::npos ? topic_above(depth_topic)
                                       : topic_above(depth_topic.substr(0, depth_at));
}

/// The frame of a camera whose topics are named after it, as in roomcast's files, else its topics.
std::string name_of_camera(const FoxgloveStream& depth, const std::string& file) {
  const std::string topic = camera_topic(depth.topic);
  const bool is_named = topic == "/" + depth.frame_id && is_sensor_name(depth.frame_id) &&
                        depth.frame_id.find('/') == std::string::npos;
  return is_named ? depth.frame_id : sensor_name(topic, file);
}

bool is_readable_color(const FoxgloveStream& stream) {
  if (stream.is_depth) return false;
  if (stream.pictures == FoxglovePictures::kVideo) return stream.encoding == "vp9";
  if (stream.pictures == FoxglovePictures::kRaw)
    return kind_of_encoding(stream.encoding, stream.topic) == RosPictureKind::kColor;
  return kind_of_compressed(stream.encoding) == RosPictureKind::kColor;
}

class FoxgloveCameras {
 public:
  FoxgloveCameras(std::shared_ptr<MessageStore> store, std::string name)
      : store_(std::move(store)), name_(std::move(name)), all_(find_foxglove_streams(*store_)) {}

  [[nodiscard]] Result<std::vector<std::unique_ptr<SensorFile>>> sensors() {
    const std::vector<const FoxgloveStream*> depth_streams = depth_of_cameras();
    if (depth_streams.empty())
      return Error{ErrorCode::kUnsupported,
                   "it has no depth pictures of Foxglove's schemas with a CameraCalibration of "
                   "their frame"};
    std::set<std::string> worlds;
    for (const FoxgloveStream* depth : depth_streams) {
      if (const auto root = all_.frames.root_above(depth->frame_id)) worlds.insert(*root);
    }
    has_one_world_ = worlds.size() < 2;
    std::vector<FoxgloveCameraParts> cameras;
    for (const FoxgloveStream* depth : depth_streams) {
      auto parts = parts_of(*depth);
      if (!parts) return parts.error();
      cameras.push_back(*std::move(parts));
    }
    return made(std::move(cameras));
  }

 private:
  /// One of each camera, raw pictures rather than compressed ones, in the order of the file.
  [[nodiscard]] std::vector<const FoxgloveStream*> depth_of_cameras() const {
    std::vector<const FoxgloveStream*> chosen;
    for (const FoxgloveStream& stream : all_.streams) {
      if (!stream.is_depth || calibration_of(stream) == nullptr) continue;
      const auto same = std::ranges::find_if(chosen, [&](const FoxgloveStream* other) {
        return camera_topic(other->topic) == camera_topic(stream.topic);
      });
      if (same == chosen.end()) {
        chosen.push_back(&stream);
      } else if (stream.pictures == FoxglovePictures::kRaw &&
                 (*same)->pictures != FoxglovePictures::kRaw) {
        *same = &stream;
      }
    }
    return chosen;
  }

  /// Of the same frame, or beside the pictures; of several the one of their size, then the one with
  /// the longest common beginning.
  [[nodiscard]] const ros::CameraInfoMessage* calibration_of(const FoxgloveStream& stream) const {
    const ros::CameraInfoMessage* best = nullptr;
    std::tuple<bool, bool, std::size_t> best_rank;
    for (const auto& [topic, calibration] : all_.calibrations) {
      const bool same_frame = calibration.header.frame_id == stream.frame_id;
      if (!same_frame && topic_above(topic) != topic_above(stream.topic)) continue;
      const bool same_size = stream.width == 0 || (calibration.width == stream.width &&
                                                   calibration.height == stream.height);
      const std::tuple rank(same_frame, same_size, common_topic_parts(topic, stream.topic));
      if (best == nullptr || rank > best_rank) best = &calibration, best_rank = rank;
    }
    return best;
  }

  [[nodiscard]] const FoxgloveStream* color_of(const FoxgloveStream& depth) const {
    const FoxgloveStream* best = nullptr;
    std::pair<std::size_t, bool> best_rank;
    std::size_t colors = 0;
    for (const FoxgloveStream& stream : all_.streams) {
      if (!is_readable_color(stream) || calibration_of(stream) == nullptr) continue;
      ++colors;
      const std::pair rank(common_topic_parts(stream.topic, depth.topic),
                           stream.pictures != FoxglovePictures::kVideo);
      if (best == nullptr || rank > best_rank) best = &stream, best_rank = rank;
    }
    return best != nullptr && (best_rank.first > 0 || colors == 1) ? best : nullptr;
  }

  [[nodiscard]] SensorClock clock_of(const FoxgloveStream& depth) const {
    SensorClock clock;
    clock.recording = name_;
    const nanoseconds logged = store_->messages()[depth.messages.front()].time;
    if (depth.stamps.front() > kEarliestUtc) {
      clock.utc_minus_device = nanoseconds(0);
    } else if (logged > kEarliestUtc && logged < kLatestStamp) {
      clock.utc_minus_device = logged - depth.stamps.front();
      clock.utc_error = kLoggingError;
    }
    return clock;
  }

  [[nodiscard]] Result<FoxgloveCameraParts> parts_of(const FoxgloveStream& depth) const {
    const auto lens = lens_of(*calibration_of(depth), false);
    if (!lens) return lens.error();
    FoxgloveCameraParts parts;
    SensorFileInfo& info = parts.info;
    info.times = depth.stamps;
    info.description = {
        name_of_camera(depth, name_),
        {lens->camera, lens->camera, {}, true},
        std::nullopt,
        depth.fps > 0 ? depth.fps : fps_of_gap(median_gap(info.times, kNominalGap))};
    info.clock = clock_of(depth);
    info.has_color = false;
    parts.color_of_depth.resize(info.times.size());
    parts.depth = depth;
    if (Status status = add_color(depth, parts); !status) return status.error();
    place(depth, info);
    if (const auto damage = store_->damage())
      info.notes.push_back(*damage + "; everything before that was read");
    return parts;
  }

  [[nodiscard]] Status add_color(const FoxgloveStream& depth, FoxgloveCameraParts& parts) const {
    const FoxgloveStream* const color = color_of(depth);
    if (color == nullptr) {
      note_other_video(depth, parts.info);
      return {};
    }
    const auto color_from_depth = all_.frames.between(color->frame_id, depth.frame_id);
    if (!color_from_depth) {
      parts.info.notes.push_back("its colour is left out, because no transform says where " +
                                 color->frame_id + " is from " + depth.frame_id);
      return {};
    }
    const auto lens = lens_of(*calibration_of(*color), false);
    if (!lens) return lens.error();
    set_color_camera(lens->camera, *color_from_depth, color->frame_id == depth.frame_id,
                     parts.info.description.calibration);
    parts.color_of_depth = nearest_colors(parts.info.times, color->stamps);
    parts.color = *color;
    parts.info.has_color = true;
    return {};
  }

  void note_other_video(const FoxgloveStream& depth, SensorFileInfo& info) const {
    const auto is_beside = [&](const FoxgloveStream& stream) {
      return stream.pictures == FoxglovePictures::kVideo &&
             camera_topic(stream.topic) == camera_topic(depth.topic);
    };
    const auto video = std::ranges::find_if(all_.streams, is_beside);
    if (video != all_.streams.end() && video->encoding != "vp9")
      info.notes.push_back("its colour is left out, because video is read in VP9 only, not in \"" +
                           video->encoding + "\"");
  }

  void place(const FoxgloveStream& depth, SensorFileInfo& info) const {
    const auto root = all_.frames.root_above(depth.frame_id);
    if (!root) return;
    if (!has_one_world_) {
      info.notes.push_back(
          "where it is is left out, because the frames of its cameras do not "
          "lead to one root");
      return;
    }
    const auto root_from_depth = all_.frames.between(*root, depth.frame_id);
    if (!root_from_depth) return;
    info.description.world_from_depth =
        all_.z_is_up ? world_from_z_up() * *root_from_depth : *root_from_depth;
    if (all_.moved.contains(depth.frame_id))
      info.notes.push_back(info.description.name +
                           " was moved while it was recorded; it gets its last pose");
  }

  [[nodiscard]] std::vector<std::unique_ptr<SensorFile>> made(
      std::vector<FoxgloveCameraParts> cameras) const {
    std::vector<std::string> names;
    for (const FoxgloveCameraParts& parts : cameras) names.push_back(parts.info.description.name);
    make_unique(names);
    std::vector<std::unique_ptr<SensorFile>> sensors;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      cameras[i].info.description.name = names[i];
      sensors.push_back(make_foxglove_sensor(store_, std::move(cameras[i]), name_));
    }
    return sensors;
  }

  std::shared_ptr<MessageStore> store_;
  std::string name_;
  FoxgloveStreams all_;
  bool has_one_world_ = true;
};

}  // namespace

bool is_foxglove_recording(const std::filesystem::path& path) {
  const auto reader = mcap::Reader::open(path);
  if (!reader) return false;
  const mcap::Summary& summary = reader->summary();
  return std::ranges::any_of(summary.channels, [&](const auto& entry) {
    const auto schema = summary.schemas.find(entry.second.schema);
    return entry.second.message_encoding == kProtobufEncoding && schema != summary.schemas.end() &&
           schema->second.name.starts_with("foxglove.");
  });
}

Result<std::vector<std::unique_ptr<SensorFile>>> open_foxglove_recording(
    const std::filesystem::path& path) {
  auto store = open_protobuf_store(path);
  if (!store) return store.error();
  auto sensors = FoxgloveCameras(*std::move(store), path.string()).sensors();
  if (!sensors) return Error{sensors.error().code, path.string() + ": " + sensors.error().message};
  return sensors;
}

}  // namespace roomcast::recording
