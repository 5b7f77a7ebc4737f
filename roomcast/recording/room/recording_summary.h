// SPDX-License-Identifier: Apache-2.0
// What a list of recordings says about one of them, read from the end of its file; only a file
// without a valid end is read as a whole. Threading: no state.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/mcap/reader.h"

namespace roomcast::recording {

/// What the file says about itself.
struct AboutRecording {
  std::string room;
  std::string by;  // who started it; empty: unknown
  bool may_be_exported = true;
};

struct RecordingSummary {
  AboutRecording about;
  nanoseconds start{}, end{};  // since 1970
  std::size_t sensors = 0;     // with frames
  bool has_voices = false;
  std::optional<std::string> damage;  // why the end is missing, as a sentence
};

/// kUnsupported: not a recorded room, or of a later version. kMalformed.
[[nodiscard]] Result<AboutRecording> about_recording(const mcap::Reader& file);

/// kMalformed: times out of range.
[[nodiscard]] Status check_recorded_times(const mcap::Reader& file);

/// Also kNotFound, and what Reader::open returns.
[[nodiscard]] Result<RecordingSummary> summarize_recording(const std::filesystem::path& path);

}  // namespace roomcast::recording
