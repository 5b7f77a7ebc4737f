// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/room/recording_summary.h"

#include <algorithm>
#include <utility>

#include "roomcast/recording/room/room_recording.h"
#include "roomcast/recording/room_channels.h"

namespace roomcast::recording {
namespace {

std::string value_of(const mcap::StringMap& map, std::string_view key) {
  const auto found = map.find(std::string(key));
  return found == map.end() ? std::string() : found->second;
}

/// Channels of this encoding that have messages.
std::size_t count_channels(const mcap::Summary& summary, std::string_view encoding) {
  return static_cast<std::size_t>(std::ranges::count_if(summary.channels, [&](const auto& entry) {
    const auto& counts = summary.statistics.channel_message_counts;
    const auto count = counts.find(entry.first);
    return count != counts.end() && count->second > 0 && entry.second.message_encoding == encoding;
  }));
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
                          .sensors = count_channels(file->summary(), kFrameEncoding),
                          .has_voices = count_channels(file->summary(), kVoiceEncoding) > 0,
                          .damage = file->damage()};
}

}  // namespace roomcast::recording
