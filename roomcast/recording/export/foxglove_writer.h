// SPDX-License-Identifier: Apache-2.0
// Exports a recorded room for Foxglove, Lichtblick and Rerun: an MCAP file of their well-known
// messages (https://docs.foxglove.dev/docs/visualization/message-schemas), in Protobuf:
//   /points          foxglove.PointCloud         merged, in `world`
//   /NAME/color      foxglove.CompressedVideo    VP9, in the depth grid
//   /NAME/camera     foxglove.CameraCalibration
//   /tf              foxglove.FrameTransform     world -> NAME, an optical frame
// World frame: y up, metres. Times are UTC where the recording tells its date, else they count from
// its begin. Single-threaded.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "roomcast/codec/color/vp9_color_encoder.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/export/point_cloud.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"
#include "roomcast/recording/mcap/writer.h"

namespace google::protobuf {
class Message;
}

namespace roomcast::recording {

class FoxgloveWriter {
 public:
  /// `began_at` is added to the times of frames: as FrameSetReader::began_at.
  static Result<FoxgloveWriter> create(const std::filesystem::path& path,
                                       const std::vector<SetSensor>& sensors, nanoseconds began_at);

  /// `cloud`: merged cloud of `set`.
  [[nodiscard]] Status add(const FrameSet& set, const PointCloud& cloud);
  [[nodiscard]] Status finish() { return writer_.finish(); }

 private:
  struct SensorChannels {
    SetSensor sensor;
    recording::mcap::ChannelId video{}, camera{};
    std::unique_ptr<codec::Vp9ColorEncoder> encoder;  // created on first use
    std::uint32_t pictures = 0;
    std::shared_ptr<const codec::DecodedFrame> last;
  };

  FoxgloveWriter(recording::mcap::Writer writer, nanoseconds began_at)
      : writer_(std::move(writer)), began_at_(began_at) {}
  void add_channels(const std::vector<SetSensor>& sensors);
  [[nodiscard]] Status add_sensor(const SetFrame& frame);
  [[nodiscard]] Status add_video(SensorChannels& channels, const SetFrame& frame);
  [[nodiscard]] Status write(recording::mcap::ChannelId channel,
                             const google::protobuf::Message& message, nanoseconds time);

  recording::mcap::Writer writer_;
  nanoseconds began_at_;
  std::vector<SensorChannels> sensors_;
  recording::mcap::ChannelId points_{}, transforms_{};
  std::uint32_t sequence_ = 0;
};

}  // namespace roomcast::recording
