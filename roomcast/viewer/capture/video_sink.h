// SPDX-License-Identifier: Apache-2.0
// Where a video's frames go: to ffmpeg where it is installed, else into a folder of PNG files.
// Single-threaded; all frames are of one size.
#pragma once

#include <filesystem>
#include <memory>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/io/numbered_files.h"
#include "roomcast/viewer/view/view_target.h"

namespace roomcast::viewer {

class VideoSink {
 public:
  virtual ~VideoSink() = default;
  /// The next frame of the video. kUnavailable when it could not be kept: no more will come.
  virtual Status write(ColorView frame) = 0;
  /// Waits until everything is in the file.
  virtual Status finish() = 0;
};

/// FOLDER/frame-000001.png, ...
[[nodiscard]] std::unique_ptr<VideoSink> open_png_sequence(const std::filesystem::path& folder,
                                                           io::PictureWriter write);

/// True when a program of this name is on the PATH.
[[nodiscard]] bool is_on_path(const std::string& program);

/// Runs ffmpeg, which writes H.264 into `file` where it can. kUnavailable when it does not start.
[[nodiscard]] Result<std::unique_ptr<VideoSink>> open_ffmpeg(const std::filesystem::path& file,
                                                             PictureSize size, int fps);

}  // namespace roomcast::viewer
