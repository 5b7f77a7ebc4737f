// SPDX-License-Identifier: Apache-2.0
// FrameSetReader: a recorded room instant by instant: depth and colour in its grid of every sensor,
// and where it stood. The same whether the room was kept by `roomcast record` or lies in a rig or
// TUM folder. Metres, millimetres in pictures. Single-threaded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::recording {

struct SetSensor {
  std::string name;
  CameraIntrinsics depth;  // also of the colour, which is in the depth grid
  double fps = 30;
  double expected_error_m = 0;  // of a place that was found, 2.5 m in front of it; 0: not known
};

/// One sensor's part of a set.
struct SetFrame {
  std::size_t sensor = 0;                               // in FrameSetReader::sensors()
  std::shared_ptr<const codec::DecodedFrame> pictures;  // never null
  std::optional<RigidTransform> world_from_depth;       // nothing: nobody knows where it stood
  nanoseconds time{};                                   // as FrameSet::time
};

struct FrameSet {
  std::uint64_t number = 0;      // counts the sets of the recording that were read
  nanoseconds time{};            // since the recording began, of its newest frame
  std::vector<SetFrame> frames;  // by sensor; one that has just missed this set has its last frame
};

/// A frame that is older is not part of the room any more.
inline constexpr nanoseconds kOldestInSet{500'000'000};

class FrameSetReader {
 public:
  virtual ~FrameSetReader() = default;
  [[nodiscard]] virtual const std::vector<SetSensor>& sensors() const = 0;
  /// For people who wait.
  [[nodiscard]] virtual nanoseconds length() const = 0;
  /// False: the room's owner did not let who recorded it.
  [[nodiscard]] virtual bool may_be_exported() const { return true; }
  /// False at the end. An error of a damaged place; the next call goes on behind it where that can
  /// be.
  [[nodiscard]] virtual Result<bool> next(FrameSet& set) = 0;
};

/// `path`: FILE.mcap of `roomcast record`, or the folder of a rig or of a TUM recording. From the
/// set at `from` on. kNotFound where it is none of these; else the kinds' own errors.
[[nodiscard]] Result<std::unique_ptr<FrameSetReader>> open_frame_sets(
    const std::filesystem::path& path, nanoseconds from = {});

}  // namespace roomcast::recording
