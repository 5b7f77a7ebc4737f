// SPDX-License-Identifier: Apache-2.0
#include "bench/real/rig_depth.h"

#include <cstddef>

#include "roomcast/sensor/source_factory.h"

namespace roomcast::bench {

constexpr std::size_t kMaxFramesOfRig = 64;

Result<RigDepth> read_rig_depth(const std::filesystem::path& rig, const std::string& id) {
  const auto source = sensor::open_source("rig:" + rig.string() + "#" + id,
                                          {.pace = source::Pace::kAsFastAsPossible, .loop = false});
  if (!source) return source.error();
  RigDepth depth{(*source)->description().calibration.depth, {}};
  source::CapturedFrame frame;
  while (depth.frames.size() < kMaxFramesOfRig) {
    const auto more = (*source)->next(frame, {});
    if (!more) return more.error();
    if (!*more) break;
    depth.frames.push_back(frame.depth_mm);
  }
  if (depth.frames.empty())
    return Error{ErrorCode::kInvalidArgument, "sensor " + id + " of the rig has no frames"};
  return depth;
}

}  // namespace roomcast::bench
