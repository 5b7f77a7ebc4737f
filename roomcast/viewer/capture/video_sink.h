// SPDX-License-Identifier: Apache-2.0
// VideoSink: destination of a video's frames: ffmpeg if it is installed, else a folder of PNG
// files. Single-threaded; all frames have one size.
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
  /// Writes the next frame. kUnavailable if it could not be written: then stop writing.
  virtual Status write(ColorView frame) = 0;
  /// Waits until everything is written.
  virtual Status finish() = 0;
};

/// Writes FOLDER/frame-000001.png, ...
[[nodiscard]] std::unique_ptr<VideoSink> open_png_sequence(const std::filesystem::path& folder,
                                                           io::PictureWriter write);

/// True if a program of this name is on the PATH.
[[nodiscard]] bool is_on_path(const std::string& program);

/// Starts ffmpeg, which writes `file`, in H.264 if it can. kUnavailable if it does not start.
[[nodiscard]] Result<std::unique_ptr<VideoSink>> open_ffmpeg(const std::filesystem::path& file,
                                                             PictureSize size, int fps);

}  // namespace roomcast::viewer
