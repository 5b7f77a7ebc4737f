// SPDX-License-Identifier: Apache-2.0
// SetWriter: where exported frame sets go; one for each format. Files of single sets are written
// whole or not at all, so an export that was interrupted can go on: what is there stays.
// Single-threaded.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/export/merged_cloud.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

enum class ExportFormat {
  kPly,       // set_NNNNNN.ply: merged cloud
  kPcd,       // set_NNNNNN.pcd: the same
  kGltf,      // set_NNNNNN.glb: a textured mesh for each sensor
  kRig,       // a rig folder
  kTum,       // a rig folder whose sensors also have groundtruth.txt: each is a TUM recording
  kFoxglove,  // room.mcap of messages that Foxglove, Lichtblick and Rerun know
};
inline constexpr std::array kExportFormats = {ExportFormat::kPly,  ExportFormat::kPcd,
                                              ExportFormat::kGltf, ExportFormat::kRig,
                                              ExportFormat::kTum,  ExportFormat::kFoxglove};
[[nodiscard]] std::string_view name_of(ExportFormat format);

struct ExportTotals {
  std::uint64_t sets = 0;      // written
  std::uint64_t kept = 0;      // that were there already
  std::uint64_t points = 0;    // of clouds
  std::uint64_t pictures = 0;  // of a film
};

class SetWriter {
 public:
  virtual ~SetWriter() = default;
  /// kUnavailable when the disk fails.
  [[nodiscard]] virtual Status add(const FrameSet& set) = 0;
  [[nodiscard]] virtual Status finish() = 0;
  [[nodiscard]] virtual ExportTotals totals() const = 0;
};

/// Makes the folder `out`. kInvalidArgument as MergedCloudOptions::check; kUnavailable when it
/// cannot be written, or holds something where the format needs a new one.
[[nodiscard]] Result<std::unique_ptr<SetWriter>> make_set_writer(
    ExportFormat format, const std::filesystem::path& out, const std::vector<SetSensor>& sensors,
    const MergedCloudOptions& cloud);

}  // namespace roomcast::recording
