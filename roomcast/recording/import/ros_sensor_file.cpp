// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/ros_sensor_file.h"

#include <algorithm>
#include <utility>

namespace roomcast::recording {
namespace {

constexpr const char* kDamagedMessage = "a message of it is damaged";

struct Stamped {
  nanoseconds stamp;
  std::size_t message;
};

io::DepthValues values_of(double depth_scale_to_metre) {
  io::RecordedCamera camera;
  camera.depth_scale_to_metre = depth_scale_to_metre;
  return io::DepthValues(camera);
}

class RosSensorFile final : public SensorFile {
 public:
  RosSensorFile(std::shared_ptr<RosStore> store, RosCameraParts parts, std::string name)
      : store_(std::move(store)),
        parts_(std::move(parts)),
        name_(std::move(name)),
        decoder_(parts_.yuv422_is_yuyv),
        depth_values_(values_of(parts_.depth_scale_to_metre)) {}

  [[nodiscard]] const SensorFileInfo& info() const override { return parts_.info; }

  [[nodiscard]] Status read_depth(std::size_t frame, DepthImage& depth_mm) override {
    const CameraIntrinsics& camera = parts_.info.description.calibration.depth;
    const Status status = decode(parts_.depth, frame, camera, depth_mm,
                                 [this](auto& image, int width, int height, DepthImage& depth) {
                                   return decoder_.depth(image, width, height, depth);
                                 });
    if (status) depth_values_.to_mm(depth_mm);
    return named(status);
  }

  [[nodiscard]] Status read_color(std::size_t frame, ColorImage& color) override {
    color = {};
    if (!parts_.color_of_depth[frame]) return {};
    const CameraIntrinsics& camera = parts_.info.description.calibration.color;
    return named(decode(*parts_.color, *parts_.color_of_depth[frame], camera, color,
                        [this](auto& image, int width, int height, ColorImage& into) {
                          return decoder_.color(image, width, height, into);
                        }));
  }

  [[nodiscard]] Status read_jpeg(std::size_t frame, std::vector<std::uint8_t>& jpeg) override {
    jpeg.clear();
    const bool has_jpeg = parts_.color_of_depth[frame] && parts_.color->is_compressed &&
                          is_jpeg(parts_.color->encoding);
    if (!has_jpeg) return {};
    const auto data = store_->data(parts_.color->messages[*parts_.color_of_depth[frame]]);
    if (!data) return named(data.error());
    const auto image = ros::read_compressed_image(*data, store_->serialisation());
    if (!image) return named(malformed(kDamagedMessage));
    if (is_jpeg(image->format)) jpeg.assign(image->data.begin(), image->data.end());
    return {};
  }

 private:
  template <class Picture, class Decode>
  [[nodiscard]] Status decode(const RosStream& stream, std::size_t at,
                              const CameraIntrinsics& camera, Picture& into,
                              Decode decode_picture) {
    const auto data = store_->data(stream.messages[at]);
    if (!data) return data.error();
    if (stream.is_compressed) {
      const auto image = ros::read_compressed_image(*data, store_->serialisation());
      return image ? decode_picture(*image, camera.width, camera.height, into)
                   : Status(malformed(kDamagedMessage));
    }
    const auto image = ros::read_image(*data, store_->serialisation());
    return image ? decode_picture(*image, camera.width, camera.height, into)
                 : Status(malformed(kDamagedMessage));
  }
  [[nodiscard]] Status named(Status status) const {
    if (status) return status;
    return Error{status.error().code, name_ + ": " + status.error().message};
  }

  std::shared_ptr<RosStore> store_;
  RosCameraParts parts_;
  std::string name_;
  RosPictureDecoder decoder_;
  io::DepthValues depth_values_;
};

}  // namespace

Result<RosStream> read_ros_stream(RosStore& store, std::uint32_t topic) {
  RosStream stream;
  stream.is_compressed = store.topics()[topic].type == "sensor_msgs/CompressedImage";
  std::vector<Stamped> stamped;
  Error last = malformed(kDamagedMessage);
  for (std::size_t i = 0; i < store.messages().size(); ++i) {
    if (store.messages()[i].topic != topic || stamped.size() == kMaxSensorFrames) continue;
    const auto data = store.data(i);
    if (!data) {
      last = data.error();
      continue;
    }
    ros::MessageReader reader(*data, store.serialisation());
    const auto header = reader.header();
    if (!reader.ok()) continue;
    if (stamped.empty()) {
      stream.frame_id = header.frame_id;
      const auto raw = ros::read_image(*data, store.serialisation());
      const auto compressed = ros::read_compressed_image(*data, store.serialisation());
      if (stream.is_compressed ? !compressed : !raw) continue;
      stream.encoding = stream.is_compressed ? compressed->format : raw->encoding;
    }
    const nanoseconds recorded = store.messages()[i].time;
    const nanoseconds stamp = header.stamp.count() > 0 ? header.stamp : recorded;
    if (stamp.count() >= 0 && stamp < kLatestStamp) stamped.push_back({stamp, i});
  }
  if (stamped.empty()) return last;
  std::ranges::stable_sort(stamped, {}, &Stamped::stamp);
  for (const Stamped& entry : stamped) {
    if (!stream.stamps.empty() && stream.stamps.back() == entry.stamp) continue;
    stream.stamps.push_back(entry.stamp);
    stream.messages.push_back(entry.message);
  }
  return stream;
}

std::unique_ptr<SensorFile> make_ros_sensor(std::shared_ptr<RosStore> store, RosCameraParts parts,
                                            std::string name) {
  return std::make_unique<RosSensorFile>(std::move(store), std::move(parts), std::move(name));
}

}  // namespace roomcast::recording
