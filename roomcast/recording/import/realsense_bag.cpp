// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/realsense_bag.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "roomcast/core/little_endian.h"
#include "roomcast/recording/import/color_pairs.h"
#include "roomcast/recording/import/ros_lens.h"
#include "roomcast/recording/import/ros_sensor_file.h"
#include "roomcast/recording/import/sensor_name.h"

namespace roomcast::recording {
namespace {

/// Host time is that of arrival: a frame later at 30/s, at most two.
constexpr nanoseconds kArrivalError = std::chrono::milliseconds(70);
constexpr double kLatest_ms = 4e12;  // of the time of day

/// Messages of a RealSense recording by topic.
class Topics {
 public:
  explicit Topics(RosStore& store) : store_(store) {
    for (std::size_t i = 0; i < store.topics().size(); ++i)
      index_[store.topics()[i].name] = static_cast<std::uint32_t>(i);
  }

  [[nodiscard]] std::optional<std::uint32_t> find(const std::string& topic) const {
    const auto found = index_.find(topic);
    if (found == index_.end()) return std::nullopt;
    return found->second;
  }
  /// A copy of the first message.
  [[nodiscard]] std::optional<std::vector<std::uint8_t>> first(const std::string& topic) {
    const auto index = find(topic);
    for (std::size_t i = 0; index && i < store_.messages().size(); ++i) {
      if (store_.messages()[i].topic != *index) continue;
      const auto data = store_.data(i);
      if (!data) return std::nullopt;
      return std::vector<std::uint8_t>(data->begin(), data->end());
    }
    return std::nullopt;
  }
  /// The first value of a key; empty without one.
  [[nodiscard]] std::string value(const std::string& topic, std::string_view key) {
    const auto index = find(topic);
    for (std::size_t i = 0; index && i < store_.messages().size(); ++i) {
      if (store_.messages()[i].topic != *index) continue;
      const auto data = store_.data(i);
      const auto pair = data ? ros::read_key_value(*data, ros::Serialisation::kRos1) : std::nullopt;
      if (pair && pair->key == key) return pair->value;
    }
    return {};
  }
  /// The first topic of the form PREFIX .. PART .. ENDING.
  [[nodiscard]] std::optional<std::string> matching(std::string_view prefix, std::string_view part,
                                                    std::string_view ending) const {
    for (const auto& [name, unused] : index_) {
      if (name.starts_with(prefix) && name.ends_with(ending) &&
          name.find(part) != std::string::npos)
        return name;
    }
    return std::nullopt;
  }

 private:
  RosStore& store_;
  std::map<std::string, std::uint32_t> index_;
};

/// "/device_0/sensor_0/Depth_0" of its topic "image/data".
std::string stem_of(const std::string& data_topic) {
  return data_topic.substr(0, data_topic.size() - std::string_view("/image/data").size());
}

Result<CameraIntrinsics> camera_of(Topics& topics, const std::string& stem) {
  const auto message = topics.first(stem + "/info/camera_info");
  const auto info =
      message ? ros::read_camera_info(*message, ros::Serialisation::kRos1) : std::nullopt;
  if (!info) return malformed("it has no camera_info of " + stem);
  const auto lens = lens_of(*info, false);
  if (!lens) return lens.error();
  return lens->camera;
}

/// The pose of the device's first camera in the frame of this one.
std::optional<RigidTransform> stream_pose(Topics& topics, const std::string& stem) {
  const auto topic = topics.matching(stem, "/tf/", "");
  const auto message = topic ? topics.first(*topic) : std::nullopt;
  const auto transform =
      message ? ros::read_transform(*message, ros::Serialisation::kRos1) : std::nullopt;
  if (!transform) return std::nullopt;
  const auto pose = transform_of(*transform);
  if (!pose) return std::nullopt;
  return *pose;
}

double depth_units(Topics& topics, const std::string& depth_stem) {
  constexpr double kUsual = 0.001;
  const std::string sensor = depth_stem.substr(0, depth_stem.rfind('/'));
  const auto message = topics.first(sensor + "/option/Depth Units/value");
  if (!message || message->size() < 4) return kUsual;
  const auto units = static_cast<double>(std::bit_cast<float>(read_u32(message->data())));
  if (!(units > 1e-6 && units <= 1)) return kUsual;
  return std::abs(units - kUsual) < 1e-9 ? kUsual : units;  // 0.001 as a float is a little more
}

SensorClock realsense_clock(Topics& topics, const std::string& depth_stem,
                            nanoseconds first_stamp) {
  SensorClock clock;
  const std::string metadata = depth_stem + "/image/metadata";
  const std::string domain = topics.value(metadata, "timestamp_domain");
  if (domain == "System Time" || domain == "Global Time") {
    clock.utc_minus_device = nanoseconds(0);
    clock.utc_error = kArrivalError;
    return clock;
  }
  const std::string text = topics.value(metadata, "system_time");
  double ms = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), ms);
  if (error != std::errc() || !(ms > 0 && ms < kLatest_ms)) return clock;
  clock.utc_minus_device = nanoseconds(static_cast<std::int64_t>(ms * 1e6)) - first_stamp;
  clock.utc_error = kArrivalError;
  return clock;
}

class Device {
 public:
  Device(const std::shared_ptr<RosStore>& store, const std::string& name, std::string prefix)
      : store_(store), topics_(*store), name_(name), prefix_(std::move(prefix)) {}

  /// Nothing if the device has no depth.
  [[nodiscard]] Result<std::unique_ptr<SensorFile>> sensor() {
    const auto depth = topics_.matching(prefix_, "/Depth_", "/image/data");
    if (!depth) return std::unique_ptr<SensorFile>();
    if (Status status = take_depth(*depth); !status) return status.error();
    if (const auto color = topics_.matching(prefix_, "/Color_", "/image/data")) {
      if (Status status = take_color(*color, stem_of(*depth)); !status) return status.error();
    }
    parts_.color_of_depth.resize(parts_.info.times.size());
    if (const auto damage = store_->damage())
      parts_.info.notes.push_back(*damage + "; everything before that was read");
    return make_ros_sensor(store_, std::move(parts_), name_);
  }

 private:
  [[nodiscard]] Status take_depth(const std::string& topic) {
    const std::string stem = stem_of(topic);
    auto stream = read_ros_stream(*store_, *topics_.find(topic));
    if (!stream) return stream.error();
    const auto camera = camera_of(topics_, stem);
    if (!camera) return camera.error();
    SensorFileInfo& info = parts_.info;
    info.times = stream->stamps;
    info.description.name = sensor_name(topics_.value(prefix_ + "info", "Serial Number"), name_);
    info.description.calibration = {*camera, *camera, {}, true};
    info.description.fps = fps_of_gap(median_gap(info.times, kNominalGap));
    info.has_color = false;
    info.clock = realsense_clock(topics_, stem, info.times.front());
    parts_.depth_scale_to_metre = depth_units(topics_, stem);
    parts_.yuv422_is_yuyv = true;
    parts_.depth = *std::move(stream);
    return {};
  }

  [[nodiscard]] Status take_color(const std::string& topic, const std::string& depth_stem) {
    const std::string stem = stem_of(topic);
    auto stream = read_ros_stream(*store_, *topics_.find(topic));
    const auto depth_pose = stream_pose(topics_, depth_stem),
               color_pose = stream_pose(topics_, stem);
    if (!stream || !depth_pose || !color_pose) {
      parts_.info.notes.emplace_back(
          "its colour is left out, because it does not say where the colour camera is");
      return {};
    }
    const auto camera = camera_of(topics_, stem);
    if (!camera) return camera.error();
    SensorCalibration& calibration = parts_.info.description.calibration;
    calibration.color = *camera;
    calibration.color_from_depth = *color_pose * depth_pose->inverse();
    calibration.color_is_registered = false;
    // The cameras are not triggered together: a colour picture may be most of a frame off.
    const nanoseconds period = median_gap(parts_.info.times, kNominalGap);
    parts_.color_of_depth = nearest_colors(parts_.info.times, stream->stamps, period);
    parts_.color = *std::move(stream);
    parts_.info.has_color = true;
    return {};
  }

  std::shared_ptr<RosStore> store_;
  Topics topics_;
  std::string name_, prefix_;
  RosCameraParts parts_;
};

}  // namespace

bool is_realsense(const RosStore& store) {
  return std::ranges::any_of(store.topics(), [](const StoredTopic& topic) {
    return topic.name.starts_with("/device_") && topic.name.ends_with("/image/data");
  });
}

Result<std::vector<std::unique_ptr<SensorFile>>> realsense_sensors(
    const std::shared_ptr<RosStore>& store, const std::string& name) {
  constexpr int kMaxDevices = 16;
  std::vector<std::unique_ptr<SensorFile>> sensors;
  for (int i = 0; i < kMaxDevices; ++i) {
    auto sensor = Device(store, name, "/device_" + std::to_string(i) + "/").sensor();
    if (!sensor) return sensor.error();
    if (*sensor) sensors.push_back(*std::move(sensor));
  }
  if (sensors.empty())
    return Error{ErrorCode::kUnsupported, "it is a RealSense recording without depth"};
  return sensors;
}

}  // namespace roomcast::recording
