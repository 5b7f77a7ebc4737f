// SPDX-License-Identifier: Apache-2.0
// SetWriter: writes exported frame sets; one implementation per format. Files of single sets are
// written completely or not at all, so an interrupted export can be resumed: existing files are
// kept. Single-threaded.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/export/foxglove_messages.h"
#include "roomcast/recording/export/merged_cloud.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {

enum class ExportFormat {
  kPly,       // set_NNNNNN.ply: merged cloud
  kPcd,       // set_NNNNNN.pcd: the same
  kGltf,      // set_NNNNNN.glb: a textured mesh for each sensor
  kRig,       // a rig folder
  kTum,       // a rig folder whose sensors also have groundtruth.txt: each is a TUM recording
  kFoxglove,  // room.mcap of messages for Foxglove, Lichtblick and Rerun
};
inline constexpr std::array kExportFormats = {ExportFormat::kPly,  ExportFormat::kPcd,
                                              ExportFormat::kGltf, ExportFormat::kRig,
                                              ExportFormat::kTum,  ExportFormat::kFoxglove};
[[nodiscard]] std::string_view name_of(ExportFormat format);

struct ExportTotals {
  std::uint64_t sets = 0;       // written, or fused into a mesh
  std::uint64_t kept = 0;       // existed already
  std::uint64_t points = 0;     // of clouds, or of a mesh
  std::uint64_t triangles = 0;  // of a mesh
  std::uint64_t pictures = 0;   // of a film
};

class SetWriter {
 public:
  virtual ~SetWriter() = default;
  /// kUnavailable on a disk error.
  [[nodiscard]] virtual Status add(const FrameSet& set) = 0;
  [[nodiscard]] virtual Status finish() = 0;
  [[nodiscard]] virtual ExportTotals totals() const = 0;
};

/// The room to be exported, as FrameSetReader describes it.
struct ExportedRoom {
  std::vector<SetSensor> sensors;
  nanoseconds began_at{};  // as FrameSetReader::began_at; times in files are UTC then
};

/// `up` is that of `world` in a Foxglove file; in the other formats y is up.
/// Creates the folder `out`. kInvalidArgument as MergedCloudOptions::check; kUnavailable if it
/// cannot be written, or is not empty although the format needs a new folder.
[[nodiscard]] Result<std::unique_ptr<SetWriter>> make_set_writer(ExportFormat format,
                                                                 const std::filesystem::path& out,
                                                                 const ExportedRoom& room,
                                                                 const MergedCloudOptions& cloud,
                                                                 UpAxis up = UpAxis::kY);

}  // namespace roomcast::recording
