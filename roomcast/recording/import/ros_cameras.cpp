// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/ros_cameras.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "roomcast/recording/dataset/recording.h"
#include "roomcast/recording/import/color_pairs.h"
#include "roomcast/recording/import/frame_tree.h"
#include "roomcast/recording/import/ros_lens.h"
#include "roomcast/recording/import/ros_sensor_file.h"
#include "roomcast/recording/import/sensor_name.h"
#include "roomcast/recording/import/topic_name.h"

namespace roomcast::recording {
namespace {

constexpr nanoseconds kReceivingError = std::chrono::milliseconds(100);
constexpr std::size_t kMaxStreams = 256;

bool starts_rectified(std::string_view topic) {
  return topic.find("/image_rect") != std::string_view::npos &&
         topic.find("rect_raw") == std::string_view::npos;
}

/// A picture topic: what its first picture shows, and its camera_info.
struct Stream {
  std::string topic;  // without the name of a compression
  std::uint32_t index = 0;
  RosPictureKind kind = RosPictureKind::kOther;
  bool is_compressed = false;
  std::optional<ros::CameraInfoMessage> info;
  std::string frame_id;
};

std::string base_of(const std::string& topic, bool is_compressed) {
  return is_compressed ? topic.substr(0, topic.rfind('/')) : topic;
}

class Finder {
 public:
  Finder(const std::shared_ptr<RosStore>& store, std::string name)
      : store_(store), name_(std::move(name)) {}

  Result<std::vector<std::unique_ptr<SensorFile>>> run() {
    find_first_messages();
    read_transforms();
    find_streams();
    std::vector<std::unique_ptr<SensorFile>> sensors;
    std::map<std::string, const Stream*> best;  // of each camera
    for (const Stream& stream : streams_) {
      if (stream.kind != RosPictureKind::kDepth || !stream.info) continue;
      const Stream*& chosen = best[camera_name(stream)];
      if (chosen == nullptr || rank(stream) > rank(*chosen)) chosen = &stream;
    }
    if (best.empty())
      return Error{ErrorCode::kUnsupported,
                   "it has no depth pictures with a camera_info beside them"};
    for (const auto& [camera, stream] : best) {
      auto sensor = make(*stream, camera);
      if (!sensor) return sensor.error();
      sensors.push_back(*std::move(sensor));
    }
    return sensors;
  }

 private:
  void find_first_messages() {
    first_.resize(store_->topics().size());
    for (std::size_t i = 0; i < store_->messages().size(); ++i) {
      auto& first = first_[store_->messages()[i].topic];
      if (!first) first = i;
    }
  }

  void read_transforms() {
    for (std::size_t i = 0; i < store_->messages().size(); ++i) {
      const std::string& topic = store_->topics()[store_->messages()[i].topic].name;
      // Moving frames do not lie between the two pictures of one camera: the first value will do.
      const bool is_static = topic == "/tf_static" || topic == "tf_static";
      if (!is_static && topic != "/tf") continue;
      if (!is_static && first_[store_->messages()[i].topic] != i) continue;
      const auto data = store_->data(i);
      if (!data) continue;
      const auto transforms = ros::read_transforms(*data, store_->serialisation());
      for (std::size_t t = 0; transforms && t < transforms->size(); ++t) {
        const auto transform = transform_of((*transforms)[t].parent_from_child);
        if (transform) frames_.add((*transforms)[t].parent, (*transforms)[t].child, *transform);
      }
    }
  }

  void find_streams() {
    for (std::size_t t = 0; t < store_->topics().size() && streams_.size() < kMaxStreams; ++t) {
      const StoredTopic& topic = store_->topics()[t];
      const bool is_compressed = topic.type == "sensor_msgs/CompressedImage";
      if ((!is_compressed && topic.type != "sensor_msgs/Image") || !first_[t]) continue;
      const auto data = store_->data(*first_[t]);
      if (!data) continue;
      Stream stream{base_of(topic.name, is_compressed),
                    static_cast<std::uint32_t>(t),
                    RosPictureKind::kOther,
                    is_compressed,
                    std::nullopt,
                    ""};
      if (is_compressed) {
        const auto image = ros::read_compressed_image(*data, store_->serialisation());
        if (!image) continue;
        stream.kind = kind_of_compressed(image->format);
        stream.frame_id = image->header.frame_id;
      } else {
        const auto image = ros::read_image(*data, store_->serialisation());
        if (!image) continue;
        stream.kind = kind_of_encoding(image->encoding, topic.name);
        stream.frame_id = image->header.frame_id;
      }
      stream.info = camera_info_of(stream.topic);
      streams_.push_back(std::move(stream));
    }
  }

  [[nodiscard]] std::optional<ros::CameraInfoMessage> camera_info_of(const std::string& topic) {
    const std::string wanted = topic_above(topic) + "/camera_info";
    const auto found = std::ranges::find(store_->topics(), wanted, &StoredTopic::name);
    if (found == store_->topics().end()) return std::nullopt;
    const auto first = first_[static_cast<std::size_t>(found - store_->topics().begin())];
    if (!first) return std::nullopt;
    const auto data = store_->data(*first);
    return data ? ros::read_camera_info(*data, store_->serialisation()) : std::nullopt;
  }

  /// "/camera" of "/camera/depth/image_raw" and "/camera/aligned_depth_to_color/image_raw".
  [[nodiscard]] static std::string camera_name(const Stream& depth) {
    const std::size_t depth_at = depth.topic.find("depth");
    const std::size_t end =
        depth_at == std::string::npos ? depth.topic.rfind('/') : depth.topic.rfind('/', depth_at);
    return end == std::string::npos ? "" : depth.topic.substr(0, end);
  }

  [[nodiscard]] const Stream* color_of(const Stream& depth) const {
    const Stream* best = nullptr;
    std::pair<std::size_t, int> best_rank{0, 0};
    std::size_t colors = 0;
    for (const Stream& stream : streams_) {
      if (stream.kind != RosPictureKind::kColor || !stream.info) continue;
      ++colors;
      const bool is_grey = stream.topic.find("mono") != std::string::npos;
      const std::pair<std::size_t, int> rank{common_topic_parts(stream.topic, depth.topic),
                                             (is_grey ? 0 : 2) + (stream.is_compressed ? 0 : 1)};
      if (rank > best_rank) best = &stream, best_rank = rank;
    }
    if (best == nullptr || (best_rank.first == 0 && colors > 1)) return nullptr;
    return best;
  }

  /// 3: with colour at a known place; 2: resampled into colour's frame; 1: without colour.
  [[nodiscard]] int rank(const Stream& depth) const {
    const Stream* const color = color_of(depth);
    int rank = 1;
    if (color != nullptr && color->frame_id == depth.frame_id) rank = 2;
    if (color != nullptr && color->frame_id != depth.frame_id &&
        frames_.between(color->frame_id, depth.frame_id))
      rank = 3;
    return 2 * rank + (depth.is_compressed ? 0 : 1);
  }

  [[nodiscard]] SensorClock ros_clock(const RosStore& store, const RosStream& depth) const {
    SensorClock clock;
    clock.recording = name_;
    const nanoseconds stamp = depth.stamps.front();
    const nanoseconds recorded = store.messages()[depth.messages.front()].time;
    if (stamp > kEarliestUtc) {
      clock.utc_minus_device = nanoseconds(0);
    } else if (recorded > kEarliestUtc && recorded < kLatestStamp) {
      clock.utc_minus_device = recorded - stamp;
      clock.utc_error = kReceivingError;
    }
    return clock;
  }

  [[nodiscard]] Result<std::unique_ptr<SensorFile>> make(const Stream& depth,
                                                         const std::string& camera) {
    RosCameraParts parts;
    auto stream = read_ros_stream(*store_, depth.index);
    if (!stream) return stream.error();
    const auto lens = lens_of(*depth.info, starts_rectified(depth.topic));
    if (!lens) return lens.error();
    SensorFileInfo& info = parts.info;
    info.times = stream->stamps;
    info.description = {sensor_name(camera, name_),
                        {lens->camera, lens->camera, {}, true},
                        std::nullopt,
                        fps_of_gap(median_gap(info.times, kNominalGap))};
    info.clock = ros_clock(*store_, *stream);
    info.has_color = false;
    parts.depth = *std::move(stream);
    if (Status status = add_color(depth, parts); !status) return status.error();
    parts.color_of_depth.resize(info.times.size());
    if (const auto damage = store_->damage())
      info.notes.push_back(*damage + "; everything before that was read");
    return make_ros_sensor(store_, std::move(parts), name_);
  }

  [[nodiscard]] Status add_color(const Stream& depth, RosCameraParts& parts) {
    const Stream* const color = color_of(depth);
    if (color == nullptr) return {};
    const auto color_from_depth = frames_.between(color->frame_id, depth.frame_id);
    if (!color_from_depth) {
      parts.info.notes.push_back("its colour is left out, because /tf_static does not say where " +
                                 color->frame_id + " is from " + depth.frame_id);
      return {};
    }
    auto stream = read_ros_stream(*store_, color->index);
    if (!stream) return stream.error();
    const auto lens = lens_of(*color->info, starts_rectified(color->topic));
    if (!lens) return lens.error();
    set_color_camera(lens->camera, *color_from_depth, color->frame_id == depth.frame_id,
                     parts.info.description.calibration);
    parts.color_of_depth = nearest_colors(parts.info.times, stream->stamps);
    parts.color = *std::move(stream);
    parts.info.has_color = true;
    return {};
  }

  std::shared_ptr<RosStore> store_;
  std::string name_;
  std::vector<std::optional<std::size_t>> first_;  // message of each topic
  std::vector<Stream> streams_;
  FrameTree frames_;
};

}  // namespace

Result<std::vector<std::unique_ptr<SensorFile>>> ros_sensors(const std::shared_ptr<RosStore>& store,
                                                             const std::string& name) {
  return Finder(store, name).run();
}

}  // namespace roomcast::recording
