// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/film/film_writer.h"

#include <algorithm>
#include <utility>

#include "roomcast/io/image_file.h"
#include "roomcast/io/new_folder.h"

namespace roomcast::recording {
namespace {

constexpr double kUsualDistance_m = 2.5;  // assumed if the sensor has no depth readings

SensorId id_of(std::size_t sensor) {
  return SensorId{static_cast<std::uint16_t>(sensor + 1)};
}

double median_depth_m(const DepthImage& depth_mm) {
  std::vector<std::uint16_t> readings(depth_mm.data(),
                                      depth_mm.data() + depth_mm.view().pixel_count());
  std::erase(readings, 0);
  if (readings.empty()) return kUsualDistance_m;
  const auto middle = readings.begin() + static_cast<std::ptrdiff_t>(readings.size() / 2);
  std::ranges::nth_element(readings, middle);
  return 0.001 * *middle;
}

/// A swing about the centre of the view of the first placed sensor.
CameraPath swing_before(const FrameSet& set, double length_s) {
  const auto frame = std::ranges::find_if(
      set.frames, [](const SetFrame& f) { return f.world_from_depth.has_value(); });
  if (frame == set.frames.end())
    return swinging_path({0, 0, 0}, {0, 0, kUsualDistance_m}, length_s);
  const RigidTransform& world_from_depth = *frame->world_from_depth;
  const double distance_m = median_depth_m(frame->pictures->depth_mm);
  return swinging_path(world_from_depth.translation_m,
                       world_from_depth * Eigen::Vector3d(0, 0, distance_m), length_s);
}

}  // namespace

Result<std::unique_ptr<FilmWriter>> FilmWriter::create(const std::vector<SetSensor>& sensors,
                                                       FilmOptions options,
                                                       std::unique_ptr<viewer::VideoSink> sink) {
  const render::ViewCamera camera{.world_from_view = {},
                                  .vertical_fov_rad = options.vertical_fov_rad,
                                  .width = options.size.width,
                                  .height = options.size.height};
  if (auto status = camera.check(); !status) return status.error();
  auto context = render::EglContext::create();
  if (!context) return context.error();
  auto target = render::OffscreenTarget::create(camera.width, camera.height);
  if (!target) return target.error();
  auto renderer = render::RoomRenderer::create();
  if (!renderer) return renderer.error();
  render::RenderOptions look;
  look.floor_grid = false;
  if (auto status = renderer->set_options(look); !status) return status.error();
  return std::unique_ptr<FilmWriter>(new FilmWriter(
      sensors, std::move(options), camera,
      {std::move(*context), std::move(*target), std::move(*renderer)}, std::move(sink)));
}

FilmWriter::FilmWriter(const std::vector<SetSensor>& sensors, FilmOptions options,
                       render::ViewCamera camera, Stage stage,
                       std::unique_ptr<viewer::VideoSink> sink)
    : sensors_(sensors),
      options_(std::move(options)),
      camera_(camera),
      stage_(std::move(stage)),
      sink_(std::move(sink)),
      path_(options_.path) {}

Status FilmWriter::add(const FrameSet& set) {
  if (totals_.sets == 0) start(set);
  const double time_s = std::chrono::duration<double>(set.time - begin_).count();
  if (auto status = draw_before(time_s); !status) return status;
  ++totals_.sets;
  return show(set);
}

nanoseconds FilmWriter::length() const {
  return nanoseconds(
      static_cast<std::int64_t>(1e9 * static_cast<double>(totals_.pictures) / options_.fps));
}

RigidTransform FilmWriter::world_from_view(nanoseconds time) const {
  return path_->world_from_view(std::chrono::duration<double>(time).count());
}

void FilmWriter::start(const FrameSet& set) {
  begin_ = set.time;
  if (!path_) path_ = swing_before(set, options_.length_s);
}

Status FilmWriter::finish() {
  if (totals_.sets > 0) {
    if (auto status = draw(); !status) return status;
  }
  return sink_->finish();
}

/// Draws the pictures before `time_s`, which still show the previous set.
Status FilmWriter::draw_before(double time_s) {
  while (static_cast<double>(totals_.pictures) < time_s * options_.fps) {
    if (auto status = draw(); !status) return status;
  }
  return {};
}

Status FilmWriter::draw() {
  camera_.world_from_view =
      path_->world_from_view(static_cast<double>(totals_.pictures) / options_.fps);
  if (auto status = stage_.renderer.draw(camera_, stage_.target, options_.mode); !status)
    return status;
  ++totals_.pictures;
  return sink_->write(stage_.target.read_color());
}

Status FilmWriter::show(const FrameSet& set) {
  for (std::size_t sensor = 0; sensor < sensors_.size(); ++sensor) {
    const auto frame = std::ranges::find(set.frames, sensor, &SetFrame::sensor);
    if (frame == set.frames.end() || !frame->world_from_depth) {
      stage_.renderer.remove(id_of(sensor));
      flow_.forget(id_of(sensor));
      continue;
    }
    const codec::DecodedFrame& pictures = *frame->pictures;
    if (auto status = stage_.renderer.set_sensor(id_of(sensor), sensors_[sensor].depth,
                                                 *frame->world_from_depth);
        !status)
      return status;
    const RoomTime time(frame->time);
    const scene_flow::FlowField* moves =
        flow_.take(id_of(sensor), sensors_[sensor].depth, pictures.depth_mm, time);
    if (auto status = stage_.renderer.upload(id_of(sensor), pictures.depth_mm, pictures.color,
                                             pictures.color_seen, {time, moves});
        !status)
      return status;
  }
  return {};
}

namespace {

/// A video file that is renamed to its final name when it is complete.
class NamedWhenWhole final : public viewer::VideoSink {
 public:
  NamedWhenWhole(std::unique_ptr<viewer::VideoSink> inner, std::filesystem::path part,
                 std::filesystem::path name)
      : inner_(std::move(inner)), part_(std::move(part)), name_(std::move(name)) {}

  Status write(ColorView frame) override { return inner_->write(frame); }
  Status finish() override {
    if (auto status = inner_->finish(); !status) return status;
    std::error_code error;
    std::filesystem::rename(part_, name_, error);
    if (!error) return {};
    return Error{ErrorCode::kUnavailable,
                 "cannot name the film " + name_.string() + ": " + error.message()};
  }

 private:
  std::unique_ptr<viewer::VideoSink> inner_;
  const std::filesystem::path part_, name_;
};

Result<std::unique_ptr<viewer::VideoSink>> open_sink(const std::filesystem::path& out,
                                                     const FilmOptions& options) {
  const auto file = out / "film.mp4", part = out / "film.part.mp4", folder = out / "film";
  if (auto status = io::make_folder(out); !status) return status.error();
  std::error_code error;
  for (const auto& path : {file, folder}) {
    if (std::filesystem::exists(path, error)) {
      return Error{ErrorCode::kUnavailable,
                   "there is " + path.string() +
                       " already; choose another folder, a film cannot be continued"};
    }
  }
  if (!viewer::is_on_path("ffmpeg")) return viewer::open_png_sequence(folder, io::write_color_png);
  auto ffmpeg = viewer::open_ffmpeg(part, options.size, options.fps);
  if (!ffmpeg) return ffmpeg.error();
  return std::unique_ptr<viewer::VideoSink>(
      std::make_unique<NamedWhenWhole>(std::move(*ffmpeg), part, file));
}

}  // namespace

Result<std::unique_ptr<FilmWriter>> make_film(const std::filesystem::path& out,
                                              const std::vector<SetSensor>& sensors,
                                              FilmOptions options) {
  auto sink = open_sink(out, options);
  if (!sink) return sink.error();
  return FilmWriter::create(sensors, std::move(options), std::move(*sink));
}

}  // namespace roomcast::recording
