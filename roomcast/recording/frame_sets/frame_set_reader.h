// SPDX-License-Identifier: Apache-2.0
// FrameSetReader: reads a recorded room set by set: each sensor's depth, its colour in the depth
// grid, and its pose. The same interface for files of `roomcast record`, rig folders and TUM
// folders. Poses in metres, depth in millimetres. Single-threaded.
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
  double expected_error_m = 0;  // of an estimated pose, 2.5 m in front of the sensor; 0: unknown
  /// By which all distances in the room may be too long or too short alike, as a share, one
  /// standard deviation; the same for all its sensors, not part of the error above. 0: unknown.
  double scale_error = 0;
};

/// One sensor's part of a frame set.
struct SetFrame {
  std::size_t sensor = 0;                               // index into FrameSetReader::sensors()
  std::shared_ptr<const codec::DecodedFrame> pictures;  // never null
  std::optional<RigidTransform> world_from_depth;       // nothing: the sensor is unplaced
  nanoseconds time{};                                   // as FrameSet::time
  /// The file of the colour, where a folder has it in the depth grid; else empty.
  std::filesystem::path color_file = {};
};

struct FrameSet {
  std::uint64_t number = 0;      // running number of the sets returned by next()
  nanoseconds time{};            // capture time of the newest frame, since the recording began
  std::vector<SetFrame> frames;  // by sensor; one that missed this set has its last frame
};

/// Maximum age of a frame in a set; older frames are left out.
inline constexpr nanoseconds kOldestInSet{500'000'000};

class FrameSetReader {
 public:
  virtual ~FrameSetReader() = default;
  [[nodiscard]] virtual const std::vector<SetSensor>& sensors() const = 0;
  /// Duration of the recording; 0: unknown.
  [[nodiscard]] virtual nanoseconds length() const = 0;
  /// The number of sets that next() gives from the beginning to the end if no picture is damaged;
  /// nothing if the recording has to be read to know it.
  [[nodiscard]] virtual std::optional<std::uint64_t> set_count() const { return std::nullopt; }
  /// The instant from which FrameSet::time counts, since 1970-01-01 UTC; 0 if the recording does
  /// not tell it.
  [[nodiscard]] virtual nanoseconds began_at() const { return {}; }
  /// Why the end of the recording is missing, where it is: everything before is read.
  [[nodiscard]] virtual std::optional<std::string> damage() const { return std::nullopt; }
  /// False if the recorder was not permitted to export the room.
  [[nodiscard]] virtual bool may_be_exported() const { return true; }
  /// Returns false at the end. An error describes a damaged place; if possible, the next call
  /// continues after it.
  [[nodiscard]] virtual Result<bool> next(FrameSet& set) = 0;
};

/// kUnavailable, with a sentence, if the recording may not be exported.
[[nodiscard]] Status check_may_be_exported(const FrameSetReader& reader);

/// `path`: FILE.mcap of `roomcast record`, or the folder of a rig or of a TUM recording. Starts
/// with the set at `from`. kNotFound if `path` is none of these; otherwise the errors of the
/// respective reader.
[[nodiscard]] Result<std::unique_ptr<FrameSetReader>> open_frame_sets(
    const std::filesystem::path& path, nanoseconds from = {});

}  // namespace roomcast::recording
