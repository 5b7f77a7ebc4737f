// SPDX-License-Identifier: Apache-2.0
// Topic, metadata and encoding names used in a recorded room's MCAP file: docs/spec/recording.md.
#pragma once

#include <string>
#include <string_view>

namespace roomcast::recording {

inline constexpr std::string_view kMetadataName = "roomcast";
inline constexpr std::string_view kFormatVersion = "1";

inline constexpr std::string_view kExportKey = "export";  // key in the kMetadataName record
inline constexpr std::string_view kByKey = "by";          // likewise
inline constexpr std::string_view kForbidden = "no";

inline constexpr std::string_view kRosterTopic = "/room/roster";
inline constexpr std::string_view kPosesTopic = "/room/viewer_poses";
inline constexpr std::string_view kMarksTopic = "/room/marks";
inline constexpr std::string_view kVoicesTopic = "/room/voices";
inline constexpr std::string_view kClockTopic = "/room/clock";
inline constexpr std::string_view kSensorPrefix = "/sensor/";
inline constexpr std::string_view kFrameSuffix = "/frame";
inline constexpr std::string_view kBundleSuffix = "/bundle";

inline constexpr std::string_view kFrameEncoding = "x-roomcast.v1";  // a frame message, wire.md §2
inline constexpr std::string_view kVoiceEncoding = "x-roomcast.v1.audio";  // wire.md §6
inline constexpr std::string_view kProtobuf = "protobuf";
inline constexpr std::string_view kJson = "json";
inline constexpr std::string_view kSensorKey = "sensor";  // in a channel's metadata

[[nodiscard]] inline std::string frame_topic(std::string_view sensor) {
  return std::string(kSensorPrefix).append(sensor).append(kFrameSuffix);
}
[[nodiscard]] inline std::string bundle_topic(std::string_view sensor) {
  return std::string(kSensorPrefix).append(sensor).append(kBundleSuffix);
}

}  // namespace roomcast::recording
