// SPDX-License-Identifier: Apache-2.0
// FilmWriter: renders a recorded room as a film from a moving camera. Pictures are at a constant
// rate; each shows the newest frame set of its time. Rendered without a window. Single-threaded;
// has its own GL context, current on the thread that created it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/export/set_writer.h"
#include "roomcast/recording/film/camera_path.h"
#include "roomcast/render/gl/gl_context.h"
#include "roomcast/render/room_renderer.h"
#include "roomcast/render/view/offscreen_target.h"
#include "roomcast/scene_flow/room_flow.h"
#include "roomcast/viewer/capture/video_sink.h"

namespace roomcast::recording {

struct FilmOptions {
  viewer::PictureSize size = {1280, 720};
  int fps = 30;
  double vertical_fov_rad = 1.047;
  render::RenderMode mode = render::RenderMode::kBlend;
  std::optional<CameraPath> path;  // nothing: a slow swing about the first sensor's view
  double length_s = 0;             // of the film, for the swing
};

class FilmWriter final : public SetWriter {
 public:
  /// kInvalidArgument for an invalid size or angle; kUnavailable without GL.
  static Result<std::unique_ptr<FilmWriter>> create(const std::vector<SetSensor>& sensors,
                                                    FilmOptions options,
                                                    std::unique_ptr<viewer::VideoSink> sink);

  Status add(const FrameSet& set) override;
  /// Shows the last set for one picture and closes the file.
  Status finish() override;
  [[nodiscard]] ExportTotals totals() const override { return totals_; }

  /// Where the film begins in the recording, and its length.
  [[nodiscard]] nanoseconds begin() const { return begin_; }
  [[nodiscard]] nanoseconds length() const;
  /// View frame: x right, y up, -z ahead. `time`: since the film began. Only after add().
  [[nodiscard]] RigidTransform world_from_view(nanoseconds time) const;

 private:
  struct Stage {
    render::EglContext context;
    render::OffscreenTarget target;
    render::RoomRenderer renderer;
  };
  FilmWriter(const std::vector<SetSensor>& sensors, FilmOptions options, render::ViewCamera camera,
             Stage stage, std::unique_ptr<viewer::VideoSink> sink);
  void start(const FrameSet& set);
  Status draw_before(double time_s);
  Status draw();
  Status show(const FrameSet& set);

  const std::vector<SetSensor> sensors_;
  const FilmOptions options_;
  render::ViewCamera camera_;
  Stage stage_;
  scene_flow::RoomFlow flow_;
  std::unique_ptr<viewer::VideoSink> sink_;
  std::optional<CameraPath> path_;
  nanoseconds begin_{};  // start of the film, in the recording
  ExportTotals totals_;
};

/// Writes OUT/film.mp4 with ffmpeg, or OUT/film/frame-NNNNNN.png if ffmpeg is not installed. The
/// file gets its final name when it is complete. Creates the folder. kUnavailable if the film
/// exists already.
[[nodiscard]] Result<std::unique_ptr<FilmWriter>> make_film(const std::filesystem::path& out,
                                                            const std::vector<SetSensor>& sensors,
                                                            FilmOptions options);

}  // namespace roomcast::recording
