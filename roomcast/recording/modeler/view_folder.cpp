// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/modeler/view_folder.h"

#include <system_error>

#include "roomcast/recording/export/set_writer.h"
#include "roomcast/recording/frame_sets/frame_set_reader.h"

namespace roomcast::recording {
namespace {

namespace fs = std::filesystem;

/// Beside the folder: the new one is written here, and the old one is put away for a moment.
fs::path beside(const fs::path& folder, const char* ending) {
  return folder.parent_path() / (folder.filename().string() + ending);
}

}  // namespace

Status write_views(const fs::path& folder, const KeptViews::Saved& views) {
  const fs::path made = beside(folder, ".new"), old = beside(folder, ".old");
  std::error_code error;
  fs::remove_all(made, error);
  fs::remove_all(old, error);
  if (!views.sensors.empty()) {
    auto writer = make_set_writer(ExportFormat::kRig, made, {views.sensors, {}}, {});
    if (!writer) return writer.error();
    if (auto status = (*writer)->add(views.set); !status) return status;
    if (auto status = (*writer)->finish(); !status) return status;
  }
  fs::rename(folder, old, error);  // there may be none
  error.clear();
  if (!views.sensors.empty()) fs::rename(made, folder, error);
  const bool is_renamed = !error;
  fs::remove_all(old, error);
  if (is_renamed) return {};
  return Error{ErrorCode::kUnavailable, "cannot write the folder " + folder.string()};
}

Result<KeptViews::Saved> read_views(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error))
    return Error{ErrorCode::kNotFound, folder.string() + " does not exist"};
  auto reader = open_frame_sets(folder);
  if (!reader) return reader.error();
  KeptViews::Saved saved;
  saved.sensors = (*reader)->sensors();
  const auto more = (*reader)->next(saved.set);
  if (!more) return more.error();
  return saved;
}

}  // namespace roomcast::recording
