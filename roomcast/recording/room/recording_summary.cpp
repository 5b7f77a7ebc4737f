// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/room/recording_summary.h"

#include <utility>

#include "roomcast/recording/room/room_recording.h"
#include "roomcast/recording/room_channels.h"

namespace roomcast::recording {
namespace {

std::string value_of(const mcap::StringMap& map, std::string_view key) {
  const auto found = map.find(std::string(key));
  return found == map.end() ? std::string() : found->second;
}

std::size_t count_sensors(const mcap::Summary& summary) {
  std::size_t sensors = 0;
  for (const auto& [id, channel] : summary.channels) {
    const auto count = summary.statistics.channel_message_counts.find(id);
    const bool has_messages =
        count != summary.statistics.channel_message_counts.end() && count->second > 0;
    if (has_messages && channel.message_encoding == kFrameEncoding) ++sensors;
  }
  return sensors;
}

}  // namespace

Result<AboutRecording> about_recording(const mcap::Reader& file) {
  const auto about = file.metadata(std::string(kMetadataName));
  if (!about) {
    const bool other = about.error().code == ErrorCode::kNotFound;
    if (!other) return about.error();
    return Error{ErrorCode::kUnsupported,
                 about.error().message + ": it was not made by roomcast record"};
  }
  if (value_of(*about, "version") != kFormatVersion) {
    return Error{ErrorCode::kUnsupported,
                 "the recording has a later version; use a newer roomcast"};
  }
  return AboutRecording{.room = value_of(*about, "room"),
                        .by = value_of(*about, kByKey),
                        .may_be_exported = value_of(*about, kExportKey) != kForbidden};
}

Status check_recorded_times(const mcap::Reader& file) {
  const auto& [count, start, end, channels] = file.summary().statistics;
  if (is_plausible(start) && is_plausible(end) && start <= end) return {};
  return Error{ErrorCode::kMalformed, "the recording has times out of range"};
}

Result<RecordingSummary> summarize_recording(const std::filesystem::path& path) {
  const auto file = mcap::Reader::open(path);
  if (!file) return file.error();
  auto about = about_recording(*file);
  if (!about) return about.error();
  if (auto status = check_recorded_times(*file); !status) return status.error();
  return RecordingSummary{.about = *std::move(about),
                          .start = file->summary().statistics.start_time,
                          .end = file->summary().statistics.end_time,
                          .sensors = count_sensors(file->summary()),
                          .damage = file->damage()};
}

}  // namespace roomcast::recording
