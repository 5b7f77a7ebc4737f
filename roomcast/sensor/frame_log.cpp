// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/frame_log.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <span>
#include <string>

#include <fmt/format.h>

#include "roomcast/core/crc32.h"

namespace roomcast::sensor {

static_assert(std::endian::native == std::endian::little,
              "depth rows are hashed as they lie in memory");

std::uint32_t depth_crc32(DepthView depth_mm) {
  std::uint32_t crc = 0;
  for (int y = 0; y < depth_mm.height; ++y) {
    crc = crc32(std::as_bytes(std::span(depth_mm.row(y), static_cast<std::size_t>(depth_mm.width))),
                crc);
  }
  return crc;
}

Result<FrameLog> FrameLog::open(const std::filesystem::path& path, Start start) {
  OwnedFile file = open_file_at_once(path, start == Start::kAppended ? "a" : "w");
  if (file == nullptr) {
    return Error{ErrorCode::kUnavailable,
                 "cannot write " + path.string() + ": " + std::strerror(errno)};
  }
  return FrameLog(std::move(file));
}

Status FrameLog::add(std::uint32_t seq, RoomTime capture_time, DepthView depth_mm) {
  const std::string line =
      fmt::format("{{\"seq\":{},\"capture_ns\":{},\"depth_crc32\":{}}}\n", seq,
                  capture_time.time_since_epoch().count(), depth_crc32(depth_mm));
  const bool written = std::fwrite(line.data(), 1, line.size(), file_.get()) == line.size() &&
                       std::fflush(file_.get()) == 0;
  if (written) return {};
  return Error{ErrorCode::kUnavailable, std::string("cannot write: ") + std::strerror(errno)};
}

}  // namespace roomcast::sensor
