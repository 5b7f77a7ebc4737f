// SPDX-License-Identifier: Apache-2.0
// The messages of the program that reads .oni files (oni_reader.h) to the one that plays them
// (oni_file_camera.h), over a pipe: the description, then frames, then perhaps the end or a fault.
// Both are of one build, so structs are sent as they lie in memory. Millimetres, pixels,
// nanoseconds of the file's clock.
#pragma once

#include <cstdint>
#include <type_traits>

#include "roomcast/geometry/camera_model.h"

namespace roomcast::source {

enum class OniMessageKind : std::uint32_t { kDescription = 1, kFrame, kEnd, kFault };

/// Begins every message; `bytes` follow.
struct OniMessageHeader {
  OniMessageKind kind = OniMessageKind::kEnd;
  std::uint32_t bytes = 0;
  std::int64_t value = 0;  // a frame's device time in nanoseconds, a fault's ErrorCode
};

struct OniDescription {
  CameraIntrinsics depth, color;
  double color_from_depth_x_m = 0;
  double fps = 30;
  bool is_registered = false, has_color = false;
};

static_assert(std::is_trivially_copyable_v<OniMessageHeader>);
static_assert(std::is_trivially_copyable_v<OniDescription>);

inline constexpr std::uint32_t kMaxOniFaultBytes = 4096;  // of a sentence

}  // namespace roomcast::source
