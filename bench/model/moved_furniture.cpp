// SPDX-License-Identifier: Apache-2.0
#include "bench/model/moved_furniture.h"

#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <ostream>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "roomcast/client/subscriber.h"
#include "roomcast/core/clock.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/model/pieces/decoded_model.h"
#include "roomcast/recording/modeler/room_modeler.h"
#include "roomcast/sensor/sensor_feed.h"
#include "roomcast/sensor/source_factory.h"
#include "roomcast/simulator/scene/moved_cabinet.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;
using Seconds = std::chrono::duration<double>;

constexpr std::size_t kModelled = 200;      // points by which the cabinet is in the model
constexpr std::size_t kForgottenPart = 20;  // less than this part of them is left
/// The model has the cabinet's faces up to so far outside them; nothing else stands so near, above
/// this height.
constexpr float kBeside_m = 0.08F, kAboveFloor_m = 0.2F;
constexpr auto kLook = 100ms;
constexpr double kViewHalfAngle_rad = 0.8;

/// The model as a viewer has it.
class KeptModel {
 public:
  /// Takes the changes that the hub would send at this moment.
  Status take(const recording::RoomModeler& modeler) {
    const auto bytes = modeler.changes_after(version_);
    if (!bytes) return {};
    auto model =
        model::decode_model({reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()});
    if (!model) return model.error();
    if (model->is_whole) pieces_.clear();
    version_ = model->version;
    for (model::DecodedModel::Piece& piece : model->pieces)
      pieces_[piece.place] = std::move(piece.mesh);
    return {};
  }

  [[nodiscard]] bool is_there() const { return version_ != 0; }
  [[nodiscard]] std::size_t triangles() const {
    std::size_t sum = 0;
    for (const auto& [place, mesh] : pieces_) sum += mesh.triangles.size();
    return sum;
  }
  [[nodiscard]] std::size_t points_in(const Eigen::AlignedBox3f& box_m) const {
    std::size_t sum = 0;
    for (const auto& [place, mesh] : pieces_) {
      for (const Eigen::Vector3f& point_m : mesh.points_m) sum += box_m.contains(point_m);
    }
    return sum;
  }

 private:
  std::map<model::GridPlace, model::RoomMesh> pieces_;
  std::uint64_t version_ = 0;
};

/// The space of the cabinet and its faces.
Eigen::AlignedBox3f search_box(Eigen::AlignedBox3f box_m) {
  box_m.min().y() = kAboveFloor_m;
  box_m.min() -= Eigen::Vector3f(kBeside_m, 0, kBeside_m);
  box_m.max() += Eigen::Vector3f::Constant(kBeside_m);
  return box_m;
}

struct Rig {
  std::unique_ptr<hub::RunningHub> hub;
  std::vector<std::unique_ptr<sensor::SensorFeed>> sensors;
  std::array<Eigen::AlignedBox3f, 2> places_m;
  Eigen::Vector3d eye_m;  // in a corner
};

Result<Rig> start_rig(const MovedFurnitureOptions& options,
                      const std::function<void(const std::string&)>& progress) {
  auto room = simulator::build_room(options.scene, options.seed);
  if (!room) return room.error();
  const auto places = simulator::cabinet_places(*room);
  if (!places) return invalid_argument("this room has no space for a cabinet; use another --seed");
  Rig rig;
  rig.places_m = {search_box((*places)[0]), search_box((*places)[1])};
  const Eigen::Vector3d half_m = 0.5 * room->size_m.cast<double>();
  rig.eye_m = {-half_m.x() + 0.3, 1.7, -half_m.z() + 0.3};
  auto hub = hub::RunningHub::start({.port = 0});
  if (!hub) return hub.error();
  rig.hub = *std::move(hub);
  sensor::SourceOptions simulated;
  simulated.sim_fps = options.fps;
  simulated.sim_sensor_count = options.sensors;
  simulated.sim_seed = options.seed;
  for (int i = 0; i < options.sensors; ++i) {
    progress(fmt::format("sensor {} of {}", i + 1, options.sensors));
    auto source = sensor::open_source(
        fmt::format("sim:{},cabinet={}#{}", options.scene, options.stretch_s, i), simulated);
    if (!source) return source.error();
    sensor::SensorFeedOptions feed;
    feed.hub_url = rig.hub->url();
    auto started = sensor::SensorFeed::start(*std::move(source), std::move(feed));
    if (!started) return started.error();
    rig.sensors.push_back(*std::move(started));
  }
  return rig;
}

std::int64_t stretch_now(double stretch_s) {
  return static_cast<std::int64_t>(
      std::floor(Seconds(SteadyClock().now().time_since_epoch()).count() / stretch_s));
}

std::uint64_t frames_received(const client::Subscriber& room) {
  std::uint64_t frames = 0;
  for (const client::RoomSensor& sensor : room.snapshot()->sensors)
    frames += sensor.frames_received;
  return frames;
}

}  // namespace

Result<MovedFurnitureReport> run_moved_furniture(
    const MovedFurnitureOptions& options, const std::function<void(const std::string&)>& progress) {
  auto rig = start_rig(options, progress);
  if (!rig) return rig.error();
  // So that the cabinet stays for a whole stretch once the model begins.
  for (const std::int64_t now = stretch_now(options.stretch_s);
       stretch_now(options.stretch_s) == now;) {
    progress("waiting for a move");
    std::this_thread::sleep_for(kLook);
  }
  const std::string url = rig->hub->url(), token = rig->hub->server().own_token();
  const recording::RoomModeler modeler({.hub_url = url, .room = "room", .token = token});
  // Gets key frames only, so that these are counted.
  auto counter = client::Subscriber::open({.hub_url = url,
                                           .room = {},
                                           .credential = {.token = token, .code = {}},
                                           .name = {},
                                           .is_modeler = true,
                                           .log = {}});
  if (!counter) return counter.error();
  auto viewer = client::Subscriber::open({.hub_url = url, .room = {}, .name = {}, .log = {}});
  if (!viewer) return viewer.error();
  client::PersonPose pose;
  pose.world_from_head = world_from_optical_looking_at(rig->eye_m, {0, 0.8, 0});
  pose.world_from_head.rotation.col(1) *= -1;  // as a head: y up, and it looks along -z
  pose.world_from_head.rotation.col(2) *= -1;
  pose.view.half_angle_rad = options.looks ? kViewHalfAngle_rad : 0;

  MovedFurnitureReport report;
  KeptModel kept;
  const auto began = std::chrono::steady_clock::now();
  const auto passed_s = [&] { return Seconds(std::chrono::steady_clock::now() - began).count(); };
  std::int64_t stretch = stretch_now(options.stretch_s);
  MovedFurnitureMove move;
  double moved_s = 0;         // scene time
  bool is_measuring = false;  // the cabinet was moved, and is still in the model
  std::size_t place = 0;
  for (int moves = 0; moves < options.moves || is_measuring;) {
    if (options.looks) (*viewer)->send_pose(pose);
    std::this_thread::sleep_for(kLook);
    if (auto status = kept.take(modeler); !status) return status.error();
    if (report.modelled_s == 0 && kept.is_there()) report.modelled_s = passed_s();
    progress(fmt::format("{:.0f} s, {} moves, {} triangles", passed_s(), moves, kept.triangles()));
    const double scene_s = Seconds(SteadyClock().now().time_since_epoch()).count();
    if (is_measuring) {
      const bool is_forgotten = kept.points_in(rig->places_m[place]) < move.points / kForgottenPart;
      if (is_forgotten) move.forgotten_s = scene_s - moved_s;
      if (is_forgotten || stretch_now(options.stretch_s) != stretch) {
        report.moves.push_back(move);
        is_measuring = false;
      }
      continue;
    }
    if (const std::int64_t now = stretch_now(options.stretch_s); now != stretch) {
      place = static_cast<std::size_t>(stretch % 2);
      stretch = now;
      ++moves;
      move = MovedFurnitureMove{kept.points_in(rig->places_m[place]), 0};
      moved_s = static_cast<double>(now) * options.stretch_s;
      is_measuring = move.points >= kModelled;
    }
  }
  report.triangles = kept.triangles();
  if (const auto whole = modeler.changes_after(0)) report.bytes = whole->size();
  report.key_frames_per_minute =
      60 * static_cast<double>(frames_received(**counter)) / (options.sensors * passed_s());
  return report;
}

void print_table(const MovedFurnitureReport& report, std::ostream& out) {
  fmt::print(out,
             "first model after {:.1f} s; {} triangles, {:.2f} MB; {:.1f} key frames a minute\n",
             report.modelled_s, report.triangles, 1e-6 * static_cast<double>(report.bytes),
             report.key_frames_per_minute);
  for (const MovedFurnitureMove& move : report.moves) {
    if (move.forgotten_s > 0)
      fmt::print(out, "{} points of the cabinet, forgotten after {:.1f} s\n", move.points,
                 move.forgotten_s);
    else
      fmt::print(out, "{} points of the cabinet, not forgotten\n", move.points);
  }
}

}  // namespace roomcast::bench
