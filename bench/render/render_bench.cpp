// SPDX-License-Identifier: Apache-2.0
#include "bench/render/render_bench.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "bench/render/aligned_poses.h"
#include "bench/render/judged_views.h"
#include "bench/render/rig_frames.h"
#include "bench/render/rig_model.h"
#include "bench/render/silhouette_score.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/modeler/model_pieces.h"
#include "roomcast/render/gl/gl_context.h"
#include "roomcast/render/render_mode.h"
#include "roomcast/scene_flow/room_flow.h"

namespace roomcast::bench {
namespace {

constexpr int kDrawingsPerView = 3;

Eigen::Vector3d random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Eigen::Vector3d direction(normal(random), normal(random), normal(random));
  return direction.normalized();
}

RigidTransform disturbed(const RigidTransform& pose, const RenderBenchOptions& options,
                         std::mt19937_64& random) {
  const double angle = options.pose_error_deg * std::numbers::pi / 180;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angle, random_direction(random)).toRotationMatrix();
  const Eigen::Vector3d shift = 1e-3 * options.pose_error_mm * random_direction(random);
  return {turn * pose.rotation, pose.translation_m + shift};
}

using FrameFile = std::vector<recording::RecordedFrame>::const_iterator;

class RenderBench {
 public:
  RenderBench(const RenderBenchOptions& options, TruthViews views, RigFrames frames,
              std::vector<RigidTransform> poses,
              const std::function<void(const std::string&)>& progress)
      : options_(options),
        views_(std::move(views)),
        frames_(std::move(frames)),
        poses_(std::move(poses)),
        progress_(progress) {}

  Status judge_views();
  Status fuse_model();
  Result<RenderRow> measure(render::RenderMode mode);
  [[nodiscard]] std::size_t view_count() const { return judged_.size(); }

 private:
  using FrameNumbers = std::vector<std::uint64_t>;  // by sensor

  Result<render::RoomRenderer> room_of(render::RenderMode mode);
  Status warm_up(render::RoomRenderer& room, render::RenderMode mode);
  Status show(render::RoomRenderer& room, const FrameNumbers& numbers, RenderRow* cost);
  Status upload(render::RoomRenderer& room, std::size_t sensor, std::uint64_t number,
                RenderRow* cost);
  Status upload_before(render::RoomRenderer& room, std::size_t sensor, std::uint64_t number);
  Status measure_cost(render::RoomRenderer& room, const render::ViewCamera& camera,
                      const render::OffscreenTarget& target, render::RenderMode mode,
                      RenderRow& cost) const;
  Result<DrawnView> draw(render::RoomRenderer& room, const JudgedView& view,
                         render::RenderMode mode, RenderRow* cost);
  Status write_picture(const JudgedView& view, render::RenderMode mode,
                       const DrawnView& drawn) const;
  [[nodiscard]] bool is_compared(std::size_t sensor, std::uint64_t number) const;
  [[nodiscard]] std::optional<FrameNumbers> next_frames(const FrameNumbers& numbers);
  [[nodiscard]] std::size_t late_sensor() { return frames_.sensors().size() - 1; }
  [[nodiscard]] std::uint64_t late_frame(std::uint64_t number);
  [[nodiscard]] FrameFile file_of(std::size_t sensor, std::uint64_t number);
  [[nodiscard]] std::set<int> instants() const;
  void report_progress(const std::string& what) const {
    if (progress_) progress_(what);
  }

  const RenderBenchOptions& options_;
  TruthViews views_;
  RigFrames frames_;
  std::vector<RigidTransform> poses_;  // for drawing, before pose errors are added
  const std::function<void(const std::string&)>& progress_;
  std::vector<JudgedView> judged_;
  std::map<model::GridPlace, model::RoomMesh> model_;  // its pieces; none: it is not shown
  RegisteredFrame frame_;
  scene_flow::RoomFlow flow_;  // of the mode that is measured
  int uploads_ = 0;
};

Status RenderBench::judge_views() {
  report_progress("true views");
  auto views = read_judged_views(views_.entries, frames_);
  if (!views) return views.error();
  judged_ = *std::move(views);
  return {};
}

/// Which must be in the recording.
FrameFile RenderBench::file_of(std::size_t sensor, std::uint64_t number) {
  const auto& files = frames_.sensors()[sensor].recording.frames;
  return std::ranges::find(files, number, &recording::RecordedFrame::index);
}

std::set<int> RenderBench::instants() const {
  std::set<int> instants;
  for (const JudgedView& view : judged_) instants.insert(view.entry.instant);
  return instants;
}

Result<render::RoomRenderer> RenderBench::room_of(render::RenderMode mode) {
  auto room = render::RoomRenderer::create();
  if (!room) return room;
  render::RenderOptions look;
  look.floor_grid = false;
  look.background = {};
  look.update_background = render::uses_background_model(mode);
  if (auto status = room->set_options(look); !status) return status.error();
  std::mt19937_64 random(options_.pose_seed);
  for (std::size_t s = 0; s < frames_.sensors().size(); ++s) {
    const RigFrames::Sensor& sensor = frames_.sensors()[s];
    const SensorId id{static_cast<std::uint16_t>(s)};
    const RigidTransform pose = disturbed(poses_[s], options_, random);
    auto status = room->set_sensor(id, sensor.recording.camera.calibration.depth, pose);
    if (!status) return status.error();
  }
  for (const auto& [place, piece] : model_) {
    if (auto status = room->set_model_piece({place.x, place.y, place.z},
                                            {piece.points_m, piece.colors, piece.triangles});
        !status)
      return status.error();
  }
  if (auto status = warm_up(*room, mode); !status) return status.error();
  if (options_.late_ms > 0 && !options_.keep_late) {
    room->set_late(SensorId{static_cast<std::uint16_t>(late_sensor())}, true);
  }
  return room;
}

bool RenderBench::is_compared(std::size_t sensor, std::uint64_t number) const {
  return std::ranges::any_of(
      views_.entries, [&](const TruthViewEntry& entry) { return entry.frames[sensor] == number; });
}

/// Of all frames except the compared ones.
Status RenderBench::fuse_model() {
  report_progress("the model");
  auto mesh = fuse_rig(frames_, poses_, [this](std::size_t sensor, std::uint64_t number) {
    return is_compared(sensor, number);
  });
  if (!mesh) return mesh.error();
  model_ = recording::cut_mesh(*mesh, recording::kPieceEdge_m);
  return {};
}

/// Draws all frames of the recording except the compared ones, in time order, for modes that use
/// the background model.
Status RenderBench::warm_up(render::RoomRenderer& room, render::RenderMode mode) {
  if (!render::uses_background_model(mode)) return {};
  std::size_t longest = 0;
  for (const auto& sensor : frames_.sensors()) {
    longest = std::max(longest, sensor.recording.frames.size());
  }
  for (std::size_t i = 0; i < longest; ++i) {
    report_progress(fmt::format("{}: background, frame {} of {}", name_of(mode), i + 1, longest));
    for (std::size_t s = 0; s < frames_.sensors().size(); ++s) {
      const auto& files = frames_.sensors()[s].recording.frames;
      if (i >= files.size() || is_compared(s, files[i].index)) continue;
      if (auto status = upload(room, s, files[i].index, nullptr); !status) return status;
    }
  }
  return {};
}

Status RenderBench::upload(render::RoomRenderer& room, std::size_t sensor, std::uint64_t number,
                           RenderRow* cost) {
  if (auto status = frames_.read(frames_.sensors()[sensor], number, frame_); !status) return status;
  glFinish();
  const double before = process_cpu_ms();
  const SensorId id{static_cast<std::uint16_t>(sensor)};
  render::PictureMotion motion;
  if (options_.one_instant) {
    const RoomTime time(file_of(sensor, number)->true_time);
    const auto& lens = frames_.sensors()[sensor].recording.camera.calibration.depth;
    motion = {time, flow_.take(id, lens, frame_.depth_mm, time)};
  }
  auto status = room.upload(id, frame_.depth_mm, frame_.color.color, frame_.color.seen, motion);
  glFinish();
  if (cost != nullptr) {
    cost->upload_cpu_ms += process_cpu_ms() - before;
    ++uploads_;
  }
  return status;
}

/// The newest frame of the late sensor that is older than `number` by `late_ms`, or its oldest one.
std::uint64_t RenderBench::late_frame(std::uint64_t number) {
  const double frames = options_.late_ms * views_.rig.fps / 1000;
  std::uint64_t late = frames_.sensors()[late_sensor()].recording.frames.front().index;
  for (const auto& file : frames_.sensors()[late_sensor()].recording.frames) {
    if (static_cast<double>(file.index) + frames <= static_cast<double>(number)) late = file.index;
  }
  return late;
}

/// Uploads the frame before this one: motion is known from two in a row.
Status RenderBench::upload_before(render::RoomRenderer& room, std::size_t sensor,
                                  std::uint64_t number) {
  const auto file = file_of(sensor, number);
  if (file == frames_.sensors()[sensor].recording.frames.begin()) return {};
  return upload(room, sensor, std::prev(file)->index, nullptr);
}

Status RenderBench::show(render::RoomRenderer& room, const FrameNumbers& numbers, RenderRow* cost) {
  for (std::size_t s = 0; s < numbers.size(); ++s) {
    const std::uint64_t number =
        options_.late_ms > 0 && s == late_sensor() ? late_frame(numbers[s]) : numbers[s];
    if (auto status = upload_before(room, s, number); !status) return status;
    if (auto status = upload(room, s, number, cost); !status) return status;
  }
  return {};
}

/// Measures the cost; leaves a picture of this mode in `target`.
Status RenderBench::measure_cost(render::RoomRenderer& room, const render::ViewCamera& camera,
                                 const render::OffscreenTarget& target, render::RenderMode mode,
                                 RenderRow& cost) const {
  if (options_.stereo) {
    const auto stereo = stereo_cost(room, camera, mode, kDrawingsPerView);
    if (!stereo) return stereo.error();
    cost.stereo.at_once_cpu_ms += stereo->at_once_cpu_ms;
    cost.stereo.one_by_one_cpu_ms += stereo->one_by_one_cpu_ms;
    if (auto status = room.draw(camera, target, mode); !status) return status;
  }
  for (int i = 0; i < kDrawingsPerView; ++i) {
    const auto points = drawing_cpu_ms(room, camera, target, render::RenderMode::kPoints);
    if (!points) return points.error();
    const auto drawn = drawing_cpu_ms(room, camera, target, mode);
    if (!drawn) return drawn.error();
    cost.points_cpu_ms += *points;
    cost.draw_cpu_ms += *drawn;
  }
  return {};
}

Result<DrawnView> RenderBench::draw(render::RoomRenderer& room, const JudgedView& view,
                                    render::RenderMode mode, RenderRow* cost) {
  const render::ViewCamera& camera = view.entry.camera;
  const auto target = render::OffscreenTarget::create(camera.width, camera.height);
  if (!target) return target.error();
  // Work done once per frame counts towards the frame's upload.
  if (auto status = room.draw(camera, *target, mode); !status) return status.error();
  if (cost != nullptr) {
    auto status = measure_cost(room, camera, *target, mode, *cost);
    if (!status) return status.error();
  }
  return DrawnView{target->read_color(), target->read_depth_m(camera)};
}

Status RenderBench::write_picture(const JudgedView& view, render::RenderMode mode,
                                  const DrawnView& drawn) const {
  if (!options_.pictures) return {};
  std::error_code error;
  std::filesystem::create_directories(*options_.pictures, error);
  const auto name =
      fmt::format("view{}_t{}_{}", view.entry.view, view.entry.instant, name_of(mode));
  auto status = io::write_color_png(*options_.pictures / (name + ".png"), drawn.color);
  if (!status) return status;
  const auto errors = find_errors(drawn.depth_m, view.truth, view.classes.silhouette);
  if (std::isnan(errors.missing_share)) return {};
  return io::write_color_png(*options_.pictures / (name + "_silhouette.png"),
                             picture_of(errors, view.classes.silhouette, drawn.color));
}

/// The next frame of every sensor; nothing where a sensor has no next frame or has lost it.
std::optional<RenderBench::FrameNumbers> RenderBench::next_frames(const FrameNumbers& numbers) {
  FrameNumbers next;
  for (std::size_t s = 0; s < numbers.size(); ++s) {
    const auto& files = frames_.sensors()[s].recording.frames;
    const auto file = std::ranges::find(files, numbers[s], &recording::RecordedFrame::index);
    if (file == files.end() || file + 1 == files.end()) return std::nullopt;
    next.push_back((file + 1)->index);
  }
  return next;
}

Result<RenderRow> RenderBench::measure(render::RenderMode mode) {
  flow_ = {};
  if (auto status = frames_.restart(); !status) return status.error();
  auto room = room_of(mode);
  if (!room) return room.error();
  RenderRow row;
  row.mode = name_of(mode);
  uploads_ = 0;
  std::vector<ViewScore> scores;
  double flicker_sum = 0;
  int flickers = 0;
  for (const int instant : instants()) {
    std::vector<const JudgedView*> views;
    for (const JudgedView& view : judged_) {
      if (view.entry.instant == instant) views.push_back(&view);
    }
    if (auto status = show(*room, views.front()->entry.frames, &row); !status) {
      return status.error();
    }
    room->set_instant(views.front()->entry.time);
    std::vector<DrawnView> drawn;
    for (const JudgedView* view : views) {
      report_progress(
          fmt::format("{}: view {} of instant {}", row.mode, view->entry.view, instant));
      auto picture = draw(*room, *view, mode, &row);
      if (!picture) return picture.error();
      scores.push_back(score(*picture, view->truth, view->classes));
      if (auto status = write_picture(*view, mode, *picture); !status) return status.error();
      drawn.push_back(*std::move(picture));
    }
    const auto next = next_frames(views.front()->entry.frames);
    if (!next) continue;
    if (auto status = show(*room, *next, nullptr); !status) return status.error();
    room->set_instant(RoomTime(file_of(0, next->front())->true_time));
    for (std::size_t i = 0; i < views.size(); ++i) {
      auto picture = draw(*room, *views[i], mode, nullptr);
      if (!picture) return picture.error();
      flicker_sum += flicker(drawn[i], *picture, views[i]->truth, views[i]->classes);
      ++flickers;
    }
  }
  row.score = mean(scores);
  row.flicker_levels = flickers > 0 ? flicker_sum / flickers : 0;
  row.upload_cpu_ms /= std::max(uploads_, 1);
  const double drawings = kDrawingsPerView * static_cast<double>(scores.size());
  row.draw_cpu_ms /= std::max(drawings, 1.0);
  row.points_cpu_ms /= std::max(drawings, 1.0);
  row.stereo.at_once_cpu_ms /= std::max(drawings, 1.0);
  row.stereo.one_by_one_cpu_ms /= std::max(drawings, 1.0);
  return row;
}

Result<std::vector<RigidTransform>> poses_to_draw_with(const RenderBenchOptions& options,
                                                       const recording::RigDescription& rig,
                                                       RigFrames& frames) {
  if (options.aligned) return read_aligned_poses(*options.aligned, rig);
  std::vector<RigidTransform> poses;
  for (const RigFrames::Sensor& sensor : frames.sensors()) {
    poses.push_back(sensor.world_from_depth);
  }
  return poses;
}

}  // namespace

Result<RenderReport> run_render_bench(const RenderBenchOptions& options,
                                      const std::function<void(const std::string&)>& progress) {
  auto views = read_truth_views(options.rig);
  if (!views) return views.error();
  if (views->entries.empty()) {
    return Error{ErrorCode::kInvalidArgument, options.rig.string() + " has no true views"};
  }
  auto frames = RigFrames::open(options.rig, views->rig, options.color_scale, options.fill_holes);
  if (!frames) return frames.error();
  auto poses = poses_to_draw_with(options, views->rig, *frames);
  if (!poses) return poses.error();
  auto context = render::EglContext::create();
  if (!context) return context.error();

  RenderReport report;
  report.rig = options.rig.filename().string();
  report.driver = context->driver_name();
  report.sensors = static_cast<int>(frames->sensors().size());
  report.width = views->entries.front().camera.width;
  report.height = views->entries.front().camera.height;
  RenderBench bench(options, *std::move(views), *std::move(frames), *std::move(poses), progress);
  if (auto status = bench.judge_views(); !status) return status.error();
  if (options.model) {
    if (auto status = bench.fuse_model(); !status) return status.error();
  }
  report.views = static_cast<int>(bench.view_count());
  std::vector<render::RenderMode> modes = options.modes;
  if (modes.empty()) modes.assign(render::kRenderModes.begin(), render::kRenderModes.end());
  for (const render::RenderMode mode : modes) {
    auto row = bench.measure(mode);
    if (!row) return row.error();
    report.rows.push_back(*std::move(row));
  }
  return report;
}

}  // namespace roomcast::bench
