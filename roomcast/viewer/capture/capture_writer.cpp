// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/capture/capture_writer.h"

#include <utility>

#include "roomcast/viewer/capture/open_video.h"

namespace roomcast::viewer {
namespace {

Toast saved_as(const std::string& name) {
  return {Toast::Kind::kGood, "Saved as " + name + "."};
}

Toast not_saved(const Error& why) {
  return {Toast::Kind::kError, why.message};
}

}  // namespace

Toast CaptureWriter::save(const render::OffscreenTarget& picture, const std::string& room) {
  const auto path = io::next_free_path(folder_, io::file_stem(room), ".png");
  if (!path) return not_saved(path.error());
  if (const Status saved = write_(*path, picture.read_color()); !saved)
    return not_saved(saved.error());
  return saved_as(path->string());
}

Toast CaptureWriter::start_video(const render::OffscreenTarget& picture, const std::string& room) {
  size_ = {picture.width(), picture.height()};
  auto opened = open_video(folder_, io::file_stem(room), size_, write_);
  if (!opened) return not_saved(opened.error());
  name_ = opened->path.string();
  video_ = std::make_unique<VideoRecorder>(std::move(opened->sink));
  if (!opened->note.empty()) return {Toast::Kind::kNotice, opened->note};
  return {Toast::Kind::kGood, "Recording " + name_ + "."};
}

Toast CaptureWriter::stop_video() {
  const Status finished = std::exchange(video_, nullptr)->finish();
  const std::string name = std::exchange(name_, {});
  return finished ? saved_as(name) : not_saved(finished.error());
}

bool CaptureWriter::record(const render::OffscreenTarget& picture, HostTime now) {
  const bool same_size = size_ == PictureSize{picture.width(), picture.height()};
  if (!same_size || video_->has_failed()) return false;
  if (video_->wants_frame(now)) video_->offer(picture.read_color());
  return true;
}

}  // namespace roomcast::viewer
