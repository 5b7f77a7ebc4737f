// SPDX-License-Identifier: Apache-2.0
// CaptureWriter: screenshots and videos of what a viewer shows, in the folder that its person
// chose. Says what came of it. Needs the GL context of the pictures.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "roomcast/core/clock.h"
#include "roomcast/io/numbered_files.h"
#include "roomcast/render/view/offscreen_target.h"
#include "roomcast/viewer/capture/video_recorder.h"
#include "roomcast/viewer/report/toasts.h"

namespace roomcast::viewer {

class CaptureWriter {
 public:
  CaptureWriter(std::filesystem::path folder, io::PictureWriter write)
      : folder_(std::move(folder)), write_(std::move(write)) {}

  /// The room's name becomes part of the file's.
  Toast save(const render::OffscreenTarget& picture, const std::string& room);

  [[nodiscard]] bool is_recording() const { return video_ != nullptr; }
  /// The file or folder; empty while nothing is recorded.
  [[nodiscard]] const std::string& video_name() const { return name_; }
  Toast start_video(const render::OffscreenTarget& picture, const std::string& room);
  Toast stop_video();
  /// What is shown now. A video has one size: false when it cannot go on and has to be stopped.
  bool record(const render::OffscreenTarget& picture, HostTime now);

 private:
  std::filesystem::path folder_;
  io::PictureWriter write_;
  std::unique_ptr<VideoRecorder> video_;
  std::string name_;
  PictureSize size_;
};

}  // namespace roomcast::viewer
