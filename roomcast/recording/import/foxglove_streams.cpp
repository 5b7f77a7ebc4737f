// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/foxglove_streams.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "roomcast/codec/color/vp9_header.h"
#include "roomcast/recording/dataset/rig_json.h"
#include "roomcast/recording/foxglove/foxglove_reader.h"
#include "roomcast/recording/import/ros_lens.h"
#include "roomcast/recording/import/ros_picture.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {
namespace {

constexpr std::size_t kMaxFoxgloveTopics = 256;
constexpr double kStill_m = 1e-4, kStill = 1e-5;  // of transforms and of their rotations' elements

enum class Content { kOther, kRaw, kCompressed, kVideo, kCalibration, kTransform, kTransforms };

Content content_of(const std::string& schema) {
  static constexpr std::pair<const char*, Content> kSchemas[] = {
      {"foxglove.RawImage", Content::kRaw},
      {"foxglove.CompressedImage", Content::kCompressed},
      {"foxglove.CompressedVideo", Content::kVideo},
      {"foxglove.CameraCalibration", Content::kCalibration},
      {"foxglove.FrameTransform", Content::kTransform},
      {"foxglove.FrameTransforms", Content::kTransforms}};
  const auto* const found =
      std::ranges::find(kSchemas, schema, &std::pair<const char*, Content>::first);
  return found == std::end(kSchemas) ? Content::kOther : found->second;
}

/// Grey of 16 bits: PNG specification, 11.2.2, the header after eight bytes and a chunk's head.
bool is_deep_png(ros::ByteView bytes) {
  constexpr std::size_t kBitDepth = 24, kColorType = 25;
  return bytes.size() > kColorType && bytes[1] == 'P' && bytes[kBitDepth] == 16 &&
         bytes[kColorType] == 0;
}

double fps_of(const StoredTopic& topic) {
  const auto text = topic.metadata.find("fps");
  if (text == topic.metadata.end()) return 0;
  double fps = 0;
  const char* const end = text->second.data() + text->second.size();
  const auto read = std::from_chars(text->second.data(), end, fps);
  return read.ec == std::errc() && read.ptr == end && fps > 0 && fps <= kMaxFps ? fps : 0;
}

class StreamFinder {
 public:
  explicit StreamFinder(MessageStore& store) : store_(store) {
    for (const StoredTopic& topic : store.topics()) {
      contents_.push_back(contents_.size() < kMaxFoxgloveTopics ? content_of(topic.type)
                                                                : Content::kOther);
      streams_.emplace_back();
      streams_.back().topic = topic.name;
      streams_.back().fps = fps_of(topic);
      const bool has_frames =
          contents_.back() == Content::kTransform || contents_.back() == Content::kTransforms;
      const auto up = topic.metadata.find("up");
      if (has_frames && up != topic.metadata.end() && up->second == "y") found_.z_is_up = false;
    }
  }

  FoxgloveStreams run() {
    for (std::size_t i = 0; i < store_.messages().size(); ++i) take(i);
    for (FoxgloveStream& stream : streams_) {
      if (stream.messages.empty()) continue;
      sort(stream);
      found_.streams.push_back(std::move(stream));
    }
    return std::move(found_);
  }

 private:
  void take(std::size_t message) {
    const std::uint32_t topic = store_.messages()[message].topic;
    if (contents_[topic] == Content::kOther) return;
    const auto data = store_.data(message);
    if (!data) return;
    switch (contents_[topic]) {
      case Content::kRaw:
        return take_raw(message, *data, streams_[topic]);
      case Content::kCompressed:
        return take_compressed(message, *data, streams_[topic]);
      case Content::kVideo:
        return take_video(message, *data, streams_[topic]);
      case Content::kCalibration:
        return take_calibration(*data, store_.topics()[topic].name);
      case Content::kTransform:
        return take_transforms(reader_.transform(*data));
      case Content::kTransforms:
        return take_transforms(reader_.transforms(*data));
      case Content::kOther:
        return;
    }
  }

  void take_raw(std::size_t message, ros::ByteView data, FoxgloveStream& stream) {
    const auto image = reader_.raw_image(data);
    if (!image || !add(message, image->header, stream)) return;
    if (stream.messages.size() > 1) return;
    stream.pictures = FoxglovePictures::kRaw;
    stream.encoding = image->encoding;
    stream.width = image->width, stream.height = image->height;
    stream.is_depth = kind_of_encoding(image->encoding, stream.topic) == RosPictureKind::kDepth;
  }

  void take_compressed(std::size_t message, ros::ByteView data, FoxgloveStream& stream) {
    const auto image = reader_.compressed_image(data);
    if (!image || !add(message, image->header, stream)) return;
    if (stream.messages.size() > 1) return;
    stream.pictures = FoxglovePictures::kCompressed;
    stream.encoding = image->format;
    stream.is_depth = is_deep_png(image->data);
  }

  void take_video(std::size_t message, ros::ByteView data, FoxgloveStream& stream) {
    const auto picture = reader_.compressed_video(data);
    if (!picture || !add(message, picture->header, stream)) return;
    const auto header = codec::parse_vp9_header(picture->data);
    if (header && header->key) key_messages_.insert(message);
    if (stream.messages.size() > 1) return;
    stream.pictures = FoxglovePictures::kVideo;
    stream.encoding = picture->format;
  }

  bool add(std::size_t message, const ros::MessageReader::Header& header, FoxgloveStream& stream) {
    const nanoseconds recorded = store_.messages()[message].time;
    const nanoseconds stamp = header.stamp.count() > 0 ? header.stamp : recorded;
    if (stamp.count() < 0 || stamp >= kLatestStamp || stream.messages.size() == kMaxSensorFrames)
      return false;
    if (stream.messages.empty()) stream.frame_id = header.frame_id;
    stream.messages.push_back(message);
    stream.stamps.push_back(stamp);
    return true;
  }

  void take_calibration(ros::ByteView data, const std::string& topic) {
    if (found_.calibrations.contains(topic)) return;
    if (auto calibration = reader_.calibration(data))
      found_.calibrations[topic] = *std::move(calibration);
  }

  void take_transforms(const std::optional<std::vector<ros::StampedTransform>>& transforms) {
    for (std::size_t i = 0; transforms && i < transforms->size(); ++i) {
      const ros::StampedTransform& stamped = (*transforms)[i];
      const auto transform = transform_of(stamped.parent_from_child);
      if (!transform || stamped.parent == stamped.child) continue;
      const auto [before, is_new] = last_.emplace(stamped.child, *transform);
      const bool is_still =
          (before->second.translation_m - transform->translation_m).norm() < kStill_m &&
          (before->second.rotation - transform->rotation).cwiseAbs().maxCoeff() < kStill;
      if (!is_still) found_.moved.insert(stamped.child);
      before->second = *transform;
      found_.frames.add(stamped.parent, stamped.child, *transform);
    }
  }

  /// By stamp; of depth pictures with the same stamp the first one stays.
  void sort(FoxgloveStream& stream) const {
    std::vector<std::pair<nanoseconds, std::size_t>> pictures;
    for (std::size_t i = 0; i < stream.messages.size(); ++i)
      pictures.emplace_back(stream.stamps[i], stream.messages[i]);
    std::ranges::stable_sort(pictures, {}, &std::pair<nanoseconds, std::size_t>::first);
    stream.messages.clear(), stream.stamps.clear();
    for (const auto& [stamp, message] : pictures) {
      if (stream.is_depth && !stream.stamps.empty() && stream.stamps.back() == stamp) continue;
      if (key_messages_.contains(message)) stream.keys.push_back(stream.messages.size());
      stream.messages.push_back(message);
      stream.stamps.push_back(stamp);
    }
  }

  MessageStore& store_;
  FoxgloveReader reader_;
  std::vector<Content> contents_;        // of each topic
  std::vector<FoxgloveStream> streams_;  // of each topic
  std::set<std::size_t> key_messages_;   // of videos
  std::map<std::string, RigidTransform> last_;
  FoxgloveStreams found_;
};

}  // namespace

FoxgloveStreams find_foxglove_streams(MessageStore& store) {
  return StreamFinder(store).run();
}

}  // namespace roomcast::recording
