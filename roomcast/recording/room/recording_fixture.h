// SPDX-License-Identifier: Apache-2.0
// For tests: a short recording of a synthetic room. The sensors send lossless depth and colour of a
// slanted wall that approaches; every fifth frame is a key frame.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/client/room/calibration_message.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/recording/room/room_recording_writer.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::recording {

class RecordingFixtureRoom {
 public:
  static constexpr int kWidth = 64, kHeight = 48;
  static constexpr nanoseconds kUnixMinusRoom{1'700'000'000'000'000'000};
  static constexpr nanoseconds kPeriod{100'000'000};
  static constexpr int kFramesPerKey = 5;

  explicit RecordingFixtureRoom(int sensors = 2) : encoders_(static_cast<std::size_t>(sensors)) {
    for (auto& encoder : encoders_) {
      codec::FrameEncoderOptions options;
      options.width = kWidth;
      options.height = kHeight;
      options.fps = 10;
      options.depth_mode = codec::DepthMode::kLossless;
      encoder = std::move(*codec::FrameEncoder::create(options));
    }
  }

  /// Sets the frame rate that the last sensor reports; its frames still arrive at the rate of the
  /// others.
  RecordingFixtureRoom& with_last_fps(double fps) {
    last_fps_ = fps;
    return *this;
  }

  static std::string name(int sensor) { return "s" + std::to_string(sensor); }

  /// The sensors are half a metre apart along x; all look along world -z.
  static RigidTransform world_from_depth(int sensor) {
    RigidTransform pose;
    pose.rotation = Eigen::Vector3d(1, -1, -1).asDiagonal();
    pose.translation_m = {0.5 * sensor, 1.5, 0};
    return pose;
  }

  static SensorCalibration calibration() {
    SensorCalibration calibration;
    calibration.depth = {
        .width = kWidth, .height = kHeight, .fx = 60, .fy = 60, .cx = 31.5, .cy = 23.5};
    calibration.color = calibration.depth;
    calibration.color_is_registered = true;
    return calibration;
  }

  static DepthImage depth(int instant) {
    DepthImage depth(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        depth.at(x, y) = static_cast<std::uint16_t>(2000 + 4 * x - 5 * instant);
    depth.at(3, 4) = 0;
    return depth;
  }
  static ColorImage color(int sensor) {
    return {kWidth, kHeight, {static_cast<std::uint8_t>(60 + 100 * sensor), 120, 40}};
  }

  [[nodiscard]] wire::pb::Roster roster(bool placed = true) const {
    wire::pb::Roster roster;
    for (int i = 0; i < static_cast<int>(encoders_.size()); ++i) {
      auto& entry = *roster.add_sensors();
      entry.set_id(static_cast<std::uint32_t>(10 + i));
      entry.set_name(name(i));
      entry.set_online(true);
      entry.set_fps(i + 1 == static_cast<int>(encoders_.size()) ? last_fps_ : 10);
      entry.set_placement(placed ? wire::pb::PLACEMENT_ALIGNED : wire::pb::PLACEMENT_UNPLACED);
      *entry.mutable_calibration() = client::message_from_calibration(calibration());
      wire::write_transform(placed ? world_from_depth(i) : RigidTransform(),
                            *entry.mutable_world_from_depth());
    }
    return roster;
  }

  /// Returns header and payload as a hub forwards them. `instant` must increase from call to call.
  std::vector<std::uint8_t> frame(int sensor, int instant) {
    std::vector<std::uint8_t> bytes(wire::kFrameHeaderBytes);
    const MaskImage seen(kWidth, kHeight, 255);
    const auto info = encoders_[static_cast<std::size_t>(sensor)]->encode(
        depth(instant), color(sensor), seen, instant % kFramesPerKey == 0, bytes);
    EXPECT_TRUE(info.ok());
    wire::FrameHeader header;
    header.key = info->key;
    header.layer = info->layer;
    header.last = sensor + 1 == static_cast<int>(encoders_.size());
    header.sensor = SensorId{static_cast<std::uint16_t>(10 + sensor)};
    header.seq = static_cast<std::uint32_t>(instant);
    header.base_seq = info->key ? header.seq : base_seq_;
    if (info->layer == 0 && header.last) base_seq_ = header.seq;
    header.set = SetId{static_cast<std::uint64_t>(instant + 1)};
    header.capture_time = RoomTime(capture(instant));
    header.payload_length = static_cast<std::uint32_t>(bytes.size() - wire::kFrameHeaderBytes);
    wire::write_frame_header(header, std::span(bytes).first<wire::kFrameHeaderBytes>());
    return bytes;
  }

  /// An audio packet of 20 ms as a hub forwards it; `payload` is not looked at.
  static std::vector<std::uint8_t> voice(std::uint32_t speaker, std::uint32_t seq,
                                         nanoseconds captured,
                                         std::span<const std::uint8_t> payload, bool ends = false) {
    std::vector<std::uint8_t> bytes(wire::kAudioHeaderBytes);
    wire::write_audio_header({.ends = ends,
                              .speaker = ViewerId{speaker},
                              .seq = seq,
                              .capture_time = RoomTime(captured),
                              .payload_length = static_cast<std::uint16_t>(payload.size())},
                             std::span(bytes).first<wire::kAudioHeaderBytes>());
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    return bytes;
  }

  static nanoseconds capture(int instant) { return nanoseconds(5'000'000'000) + instant * kPeriod; }
  /// Arrival time: 20 ms after capture.
  static nanoseconds came(int instant) {
    return capture(instant) + kUnixMinusRoom + nanoseconds(20'000'000);
  }

  /// Sensors are placed from instant `placed_at` on. Returns all frame messages in order.
  std::vector<std::vector<std::uint8_t>> record(const std::filesystem::path& path, int instants,
                                                bool finish = true, int placed_at = 0) {
    std::vector<std::vector<std::uint8_t>> frames;
    auto writer = RoomRecordingWriter::create(path, "lab");
    EXPECT_TRUE(writer.ok());
    EXPECT_TRUE(writer->add_clock({kUnixMinusRoom, nanoseconds(1000)}, came(0)).ok());
    if (placed_at > 0) {
      EXPECT_TRUE(writer->add_roster(roster(false), came(0)).ok());
    }
    for (int instant = 0; instant < instants; ++instant) {
      if (instant == placed_at) {
        EXPECT_TRUE(writer->add_roster(roster(), came(instant)).ok());
      }
      for (int sensor = 0; sensor < static_cast<int>(encoders_.size()); ++sensor) {
        frames.push_back(frame(sensor, instant));
        EXPECT_TRUE(writer->add_frame(frames.back(), came(instant)).ok());
      }
    }
    if (finish) {
      EXPECT_TRUE(writer->finish().ok());
    }
    return frames;
  }

 private:
  std::vector<std::unique_ptr<codec::FrameEncoder>> encoders_;
  double last_fps_ = 10;
  std::uint32_t base_seq_ = 0;
};

}  // namespace roomcast::recording
