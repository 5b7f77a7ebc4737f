// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/frame_sets/frame_set_reader.h"

#include "roomcast/recording/frame_sets/recorded_sets.h"
#include "roomcast/recording/frame_sets/rig_sets.h"
#include "roomcast/recording/room/room_recording.h"

namespace roomcast::recording {

Status check_may_be_exported(const FrameSetReader& reader) {
  return reader.may_be_exported() ? Status() : Status(export_is_not_allowed());
}

Result<std::unique_ptr<FrameSetReader>> open_frame_sets(const std::filesystem::path& path,
                                                        nanoseconds from) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) return open_recorded_sets(path, from);
  return open_folder_sets(path, from);
}

}  // namespace roomcast::recording
