// SPDX-License-Identifier: Apache-2.0
// Chooses the format of a video: one file by ffmpeg if that is installed, else a folder of
// pictures.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "roomcast/viewer/capture/video_sink.h"

namespace roomcast::viewer {

struct OpenedVideo {
  std::unique_ptr<VideoSink> sink;
  std::filesystem::path path;
  std::string note;  // for the user; may be empty
};

/// Opens a video in `folder` under an unused name that begins with `stem`. Errors as next_free_path
/// and open_ffmpeg.
[[nodiscard]] Result<OpenedVideo> open_video(const std::filesystem::path& folder,
                                             const std::string& stem, PictureSize size,
                                             const io::PictureWriter& write_png);

}  // namespace roomcast::viewer
