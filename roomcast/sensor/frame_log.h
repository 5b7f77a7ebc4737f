// SPDX-License-Identifier: Apache-2.0
// FrameLog: writes one JSON line per frame sent, so that a test can compare the received frames:
// {"seq":0,"capture_ns":1,"depth_crc32":2}. depth_crc32 is over the depth picture as little-endian
// u16, row by row.
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>

#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/open_at_once.h"
#include "roomcast/core/result.h"

namespace roomcast::sensor {

[[nodiscard]] std::uint32_t depth_crc32(DepthView depth_mm);

class FrameLog {
 public:
  enum class Start { kAnew, kAppended };  // to what is in the file
  /// kUnavailable when the file cannot be written.
  static Result<FrameLog> open(const std::filesystem::path& path, Start start = Start::kAnew);
  /// kUnavailable when the line cannot be written, for example to a full disk.
  [[nodiscard]] Status add(std::uint32_t seq, RoomTime capture_time, DepthView depth_mm);

 private:
  explicit FrameLog(OwnedFile file) : file_(std::move(file)) {}
  OwnedFile file_;
};

}  // namespace roomcast::sensor
