// SPDX-License-Identifier: Apache-2.0
// Exports a recorded room for Foxglove, Lichtblick and Rerun: an MCAP file of the messages of
// foxglove_messages.h:
//   /points          foxglove.PointCloud         merged, in `world`
//   /NAME/color      foxglove.CompressedVideo    VP9, in the depth grid
//   /NAME/depth      foxglove.RawImage           16UC1, millimetres
//   /NAME/camera     foxglove.CameraCalibration  of both
//   /tf              foxglove.FrameTransform     world -> NAME, an optical frame
// Times are UTC if the recording tells its date; otherwise they count from its begin. Metadata of
// the channels tell what the schemas cannot: "up" of /tf, the axis of `world`; "fps" of depth.
// Single-threaded.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/codec/color/vp9_color_encoder.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/export/foxglove_messages.h"
#include "roomcast/recording/export/point_cloud.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"
#include "roomcast/recording/mcap/writer.h"

namespace roomcast::recording {

class FoxgloveWriter {
 public:
  /// `began_at` is added to the times of frames: as FrameSetReader::began_at. `up`: of `world`.
  static Result<FoxgloveWriter> create(const std::filesystem::path& path,
                                       const std::vector<SetSensor>& sensors, nanoseconds began_at,
                                       UpAxis up);

  /// `cloud`: merged cloud of `set`, in roomcast's world.
  [[nodiscard]] Status add(const FrameSet& set, const PointCloud& cloud);
  [[nodiscard]] Status finish() { return writer_.finish(); }

 private:
  struct SensorChannels {
    SetSensor sensor;
    recording::mcap::ChannelId video{}, depth{}, camera{};
    std::unique_ptr<codec::Vp9ColorEncoder> encoder;  // created on first use
    std::uint32_t pictures = 0;
    std::shared_ptr<const codec::DecodedFrame> last;
  };

  FoxgloveWriter(recording::mcap::Writer writer, nanoseconds began_at, UpAxis up)
      : writer_(std::move(writer)), began_at_(began_at), up_(up) {}
  void add_channels(const std::vector<SetSensor>& sensors);
  [[nodiscard]] Status add_sensor(const SetFrame& frame);
  [[nodiscard]] Status add_video(SensorChannels& channels, const SetFrame& frame);
  [[nodiscard]] Status write(recording::mcap::ChannelId channel, const std::string& message,
                             nanoseconds time);

  recording::mcap::Writer writer_;
  nanoseconds began_at_;
  UpAxis up_;
  std::vector<SensorChannels> sensors_;
  recording::mcap::ChannelId points_{}, transforms_{};
  std::uint32_t sequence_ = 0;
};

}  // namespace roomcast::recording
