// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/capture/open_video.h"

#include "roomcast/viewer/capture/video_recorder.h"

namespace roomcast::viewer {

Result<OpenedVideo> open_video(const std::filesystem::path& folder, const std::string& stem,
                               PictureSize size, const io::PictureWriter& write_png) {
  const bool has_ffmpeg = is_on_path("ffmpeg");
  const auto path = io::next_free_path(folder, stem, has_ffmpeg ? ".mp4" : "-video");
  if (!path) return path.error();
  if (!has_ffmpeg) {
    return OpenedVideo{open_png_sequence(*path, write_png), *path,
                       "ffmpeg is not installed: the video becomes a folder of pictures."};
  }
  auto sink = open_ffmpeg(*path, size, VideoRecorder::kFps);
  if (!sink) return sink.error();
  return OpenedVideo{std::move(*sink), *path, ""};
}

}  // namespace roomcast::viewer
