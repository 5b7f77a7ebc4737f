// SPDX-License-Identifier: Apache-2.0
// Topics: the channels of a room and their messages, made of its frame sets:
//   /points          foxglove.PointCloud         merged, in `world`
//   /tf              foxglove.FrameTransforms    world -> NAME for each placed sensor
//   /NAME/color      foxglove.CompressedImage    JPEG, in the depth grid
//   /NAME/depth      foxglove.RawImage           16UC1, millimetres
//   /NAME/camera     foxglove.CameraCalibration  of both
// A picture is sent once. Only what is wanted is made. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "roomcast/foxglove/protocol.h"
#include "roomcast/io/jpeg_codec.h"
#include "roomcast/recording/export/merged_cloud.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::foxglove {

struct TopicsOptions {
  recording::UpAxis up = recording::UpAxis::kZ;
  recording::MergedCloudOptions cloud;
  int jpeg_quality = 85;  // 1 to 100
};

class Topics {
 public:
  /// `options.cloud` passes MergedCloudOptions::check().
  explicit Topics(TopicsOptions options) : options_(std::move(options)) {}

  /// The sensors of the room from now on; true if the channels changed.
  bool set_sensors(const std::vector<recording::SetSensor>& sensors);
  [[nodiscard]] std::vector<Channel> channels() const;

  using Publish = std::function<void(ChannelId, nanoseconds time, std::string message)>;
  /// Frames of `set` belong to the sensors of the last set_sensors(); times are UTC. Returns the
  /// problem of a picture that could not be made, if any; the others are published.
  Status publish(const recording::FrameSet& set, const std::set<ChannelId>& wanted,
                 const Publish& publish);

 private:
  struct SensorTopics {
    Channel color, depth, camera;
    std::shared_ptr<const codec::DecodedFrame> last;
  };
  Channel new_channel(std::string topic, recording::FoxgloveKind kind);
  Status publish_sensor(const recording::SetFrame& frame, const SensorTopics& topics,
                        const std::set<ChannelId>& wanted, const Publish& publish);

  const TopicsOptions options_;
  std::uint32_t last_id_ = 0;
  Channel points_ = new_channel("/points", recording::FoxgloveKind::kPoints);
  Channel transforms_ = new_channel("/tf", recording::FoxgloveKind::kTransforms);
  std::vector<recording::SetSensor> sensors_;
  std::map<std::string, SensorTopics> topics_;  // by the sensor's name
  std::unique_ptr<recording::MergedCloud> merged_;
  recording::PointCloud cloud_;
  io::JpegCodec jpeg_;
};

}  // namespace roomcast::foxglove
