// SPDX-License-Identifier: Apache-2.0
// CaptureWriter: writes screenshots and videos of the view to the folder that the user chose.
// Returns the outcome as a Toast. Needs the GL context of the pictures.
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

  /// The room's name becomes part of the file name.
  Toast save(const render::OffscreenTarget& picture, const std::string& room);

  [[nodiscard]] bool is_recording() const { return video_ != nullptr; }
  /// File or folder; empty while no video is being recorded.
  [[nodiscard]] const std::string& video_name() const { return name_; }
  Toast start_video(const render::OffscreenTarget& picture, const std::string& room);
  Toast stop_video();
  /// Adds a picture to the video. False if the video must be stopped, because the size has changed
  /// or writing failed.
  bool record(const render::OffscreenTarget& picture, HostTime now);

 private:
  std::filesystem::path folder_;
  io::PictureWriter write_;
  std::unique_ptr<VideoRecorder> video_;
  std::string name_;
  PictureSize size_;
};

}  // namespace roomcast::viewer
