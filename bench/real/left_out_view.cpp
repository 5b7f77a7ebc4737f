// SPDX-License-Identifier: Apache-2.0
#include "bench/real/left_out_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "bench/render/view_score.h"
#include "roomcast/render/room_renderer.h"
#include "roomcast/scene_flow/room_flow.h"

namespace roomcast::bench {
namespace {

constexpr double kMaxHalfAngle_tan = 4;  // wider views are cut off: 76 degrees to each side

using Frames = std::vector<recording::RecordedFrame>;

/// The normalised coordinates of a pixel, as the ideal pinhole has them.
std::optional<Eigen::Vector2d> ray_of(const CameraIntrinsics& lens, int x, int y) {
  return undistort(lens, {(x - lens.cx) / lens.fx, (y - lens.cy) / lens.fy});
}

Eigen::Vector2d pixel_of(const render::ViewCamera& view, const Eigen::Vector2d& xy) {
  return focal_length_px(view) * xy + 0.5 * Eigen::Vector2d(view.width - 1, view.height - 1);
}

std::vector<std::size_t> spread_evenly(std::size_t frames, int count) {
  std::vector<std::size_t> chosen;
  const auto parts = static_cast<std::size_t>(count) + 1;
  for (std::size_t part = 1; part < parts; ++part) {
    const std::size_t next = part * frames / parts;
    if (chosen.empty() || chosen.back() != next) chosen.push_back(next);
  }
  return chosen;
}

/// The room as the other sensors show it, up to a time.
class RoomWithout {
 public:
  static Result<RoomWithout> create(RigFrames& frames, std::size_t left_out) {
    auto room = render::RoomRenderer::create();
    if (!room) return room.error();
    render::RenderOptions look;
    look.floor_grid = false;
    look.background = {};
    if (auto status = room->set_options(look); !status) return status.error();
    for (std::size_t s = 0; s < frames.sensors().size(); ++s) {
      if (s == left_out) continue;
      const RigFrames::Sensor& sensor = frames.sensors()[s];
      auto status = room->set_sensor(id_of(s), sensor.recording.camera.calibration.depth,
                                     sensor.world_from_depth);
      if (!status) return status.error();
    }
    return RoomWithout(frames, left_out, *std::move(room));
  }

  /// Takes the frames of each of the others up to this time, and draws what moves where it is then.
  Status advance(nanoseconds time) {
    room_.set_instant(RoomTime(time));
    for (std::size_t s = 0; s < frames_.sensors().size(); ++s) {
      RigFrames::Sensor& sensor = frames_.sensors()[s];
      const Frames& files = sensor.recording.frames;
      for (; s != left_out_ && next_[s] < files.size() && files[next_[s]].true_time <= time;
           ++next_[s]) {
        auto status = frames_.read(sensor, files[next_[s]].index, frame_);
        if (!status) return status;
        const RoomTime taken(files[next_[s]].true_time);
        const scene_flow::FlowField* moves =
            flow_.take(id_of(s), sensor.recording.camera.calibration.depth, frame_.depth_mm, taken);
        status = room_.upload(id_of(s), frame_.depth_mm, frame_.color.color, frame_.color.seen,
                              {taken, moves});
        if (!status) return status;
      }
    }
    return {};
  }

  Result<DrawnView> draw(const render::ViewCamera& camera) {
    const auto target = render::OffscreenTarget::create(camera.width, camera.height);
    if (!target) return target.error();
    auto status = room_.draw(camera, *target, render::RenderMode::kBlend);
    if (!status) return status.error();
    return DrawnView{target->read_color(), target->read_depth_m(camera)};
  }

 private:
  RoomWithout(RigFrames& frames, std::size_t left_out, render::RoomRenderer room)
      : frames_(frames),
        left_out_(left_out),
        room_(std::move(room)),
        next_(frames.sensors().size(), 0) {}

  static SensorId id_of(std::size_t sensor) { return {static_cast<std::uint16_t>(sensor)}; }

  RigFrames& frames_;
  std::size_t left_out_;
  render::RoomRenderer room_;
  scene_flow::RoomFlow flow_;
  std::vector<std::size_t> next_;  // frame of each sensor that was not taken yet
  RegisteredFrame frame_;
};

/// Compares a picture with the sensor's own, both in its grid.
LeftOutPicture judged(const RegisteredFrame& own, DrawnView drawn) {
  TruthView truth{own.color.color, own.depth_mm, own.color.seen};
  ViewClasses classes{own.color.seen, MaskImage(drawn.color.width(), drawn.color.height(), 0)};
  double seen = 0, covered = 0;
  for (int y = 0; y < drawn.color.height(); ++y) {
    for (int x = 0; x < drawn.color.width(); ++x) {
      const bool is_shown = drawn.depth_m.at(x, y) > 0;
      seen += truth.seen.at(x, y) != 0;
      if (!is_shown) classes.colored.at(x, y) = 0;
      covered += classes.colored.at(x, y) != 0;
    }
  }
  const ViewScore scored = score(drawn, truth, classes);
  LeftOutPicture picture;
  const bool is_judged = covered > 0;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  picture.psnr_db = is_judged ? scored.psnr_colored : kNone;
  picture.ssim = is_judged ? scored.ssim_colored : kNone;
  picture.covered = seen > 0 ? covered / seen : 0;
  picture.wrong_depth = scored.wrong_depth;
  picture.own = own.color.color;
  picture.drawn = std::move(drawn.color);
  return picture;
}

}  // namespace

render::ViewCamera view_around(const CameraIntrinsics& lens,
                               const RigidTransform& world_from_depth) {
  const double focal_px = std::max(lens.fx, lens.fy);
  Eigen::Vector2d half(0, 0);  // tangents of the angles to the sides
  for (int y = 0; y < lens.height; ++y) {
    const bool is_edge_row = y == 0 || y == lens.height - 1;
    for (int x = 0; x < lens.width; x += is_edge_row ? 1 : std::max(lens.width - 1, 1)) {
      if (const auto xy = ray_of(lens, x, y)) half = half.cwiseMax(xy->cwiseAbs());
    }
  }
  half = half.cwiseMin(kMaxHalfAngle_tan);
  render::ViewCamera view;
  view.width = 2 * static_cast<int>(std::ceil(half.x() * focal_px)) + 1;
  view.height = 2 * static_cast<int>(std::ceil(half.y() * focal_px)) + 1;
  view.vertical_fov_rad = 2 * std::atan(0.5 * view.height / focal_px);
  view.world_from_view = world_from_depth * render::optical_from_view();
  return view;
}

template <class T>
Image<T> in_grid_of(const CameraIntrinsics& lens, const render::ViewCamera& view,
                    const Image<T>& drawn) {
  Image<T> out(lens.width, lens.height, T{});
  for (int y = 0; y < lens.height; ++y) {
    for (int x = 0; x < lens.width; ++x) {
      const auto xy = ray_of(lens, x, y);
      if (!xy) continue;
      const Eigen::Vector2d at = pixel_of(view, *xy);
      const auto column = static_cast<int>(std::lround(at.x()));
      const auto row = static_cast<int>(std::lround(at.y()));
      if (column < 0 || row < 0 || column >= drawn.width() || row >= drawn.height()) continue;
      out.at(x, y) = drawn.at(column, row);
    }
  }
  return out;
}

template Image<Rgb8> in_grid_of(const CameraIntrinsics&, const render::ViewCamera&,
                                const Image<Rgb8>&);
template Image<float> in_grid_of(const CameraIntrinsics&, const render::ViewCamera&,
                                 const Image<float>&);

Result<std::vector<LeftOutPicture>> draw_without(
    RigFrames& frames, std::size_t left_out, int count,
    const std::function<void(const std::string&)>& progress) {
  if (auto status = frames.restart(); !status) return status.error();
  auto room = RoomWithout::create(frames, left_out);
  if (!room) return room.error();
  RigFrames::Sensor& sensor = frames.sensors()[left_out];
  const CameraIntrinsics& lens = sensor.recording.camera.calibration.depth;
  const render::ViewCamera view = view_around(lens, sensor.world_from_depth);
  std::vector<LeftOutPicture> pictures;
  RegisteredFrame own;
  for (const std::size_t number : spread_evenly(sensor.recording.frames.size(), count)) {
    const recording::RecordedFrame& file = sensor.recording.frames[number];
    if (progress) progress(fmt::format("drawing frame {} without its sensor", file.index));
    if (auto status = room->advance(file.true_time); !status) return status.error();
    auto drawn = room->draw(view);
    if (!drawn) return drawn.error();
    if (auto status = frames.read(sensor, file.index, own); !status) return status.error();
    pictures.push_back(judged(
        own, {in_grid_of(lens, view, drawn->color), in_grid_of(lens, view, drawn->depth_m)}));
    pictures.back().sensor = sensor.recording.description.name;
    pictures.back().frame = file.index;
  }
  return pictures;
}

}  // namespace roomcast::bench
