// SPDX-License-Identifier: Apache-2.0
// Measures a viewer who walks along a path and tells the hub where he looks, beside one who tells
// nothing and gets all frames; then, on the same path, alone, so that sensors need not send what he
// does not see. Sensors play what was simulated before.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <map>
#include <memory>
#include <optional>
#include <thread>
#include <tuple>
#include <utility>

#include "bench/line/line_bench.h"
#include "bench/line/looked_pictures.h"
#include "bench/line/looped_source.h"
#include "bench/line/viewer_path.h"
#include "roomcast/client/room/calibration_message.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/core/interruptible_wait.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/hub/visibility/seen_surface.h"
#include "roomcast/hub/visibility/view_culling.h"
#include "roomcast/render/view/view_camera.h"
#include "roomcast/sensor/coarse_depth.h"
#include "roomcast/sensor/sensor_feed.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

constexpr double kLookingFps = 15;
constexpr int kLookingFrames = 60;  // of each sensor, played forward and backward
constexpr auto kStep = 50ms;        // between two poses
constexpr int kFramesBehind = 2;    // more are late; layer 0 has every second frame
constexpr int kStepsPerPicture = 20;
constexpr auto kLookingWarmUp = 5s;
constexpr double kRadius_m = 1.5;  // of the walk round the room
constexpr int kManyViewers = 500;

ViewAngles looked_angles() {
  return render::view_angles({.world_from_view = {},
                              .vertical_fov_rad = kLookedFov_rad,
                              .width = kLookedSide_px,
                              .height = kLookedSide_px});
}

struct Room {
  std::unique_ptr<hub::RunningHub> hub;
  std::vector<std::unique_ptr<sensor::SensorFeed>> feeds;
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();  // on the floor: what the sensors look at
};

Result<Room> open_room(const LineBenchOptions& options,
                       const std::function<void(const std::string&)>& say) {
  Room room;
  auto hub = hub::RunningHub::start({.port = 0});
  if (!hub) return hub.error();
  room.hub = *std::move(hub);
  std::vector<FloorRay> axes;
  for (int i = 0; i < options.sensors; ++i) {
    say("simulating sensor " + std::to_string(i + 1) + " of " + std::to_string(options.sensors));
    auto source =
        LoopedSource::capture(options.scene, i, options.sensors, kLookingFps, kLookingFrames);
    if (!source) return source.error();
    if (const auto& pose = (*source)->description().world_from_depth) {
      const Eigen::Vector3d ahead = pose->rotation.col(2);
      axes.push_back({{pose->translation_m.x(), pose->translation_m.z()}, {ahead.x(), ahead.z()}});
    }
    sensor::SensorFeedOptions feed;
    feed.hub_url = room.hub->url();
    auto started = sensor::SensorFeed::start(*std::move(source), feed);
    if (!started) return started.error();
    room.feeds.push_back(*std::move(started));
  }
  room.middle_m = nearest_to_all(axes);
  return room;
}

Result<std::unique_ptr<client::Subscriber>> viewer_of(const Room& room) {
  return client::Subscriber::open({.hub_url = room.hub->url(), .room = {}, .name = {}, .log = {}});
}

/// Follows the sensors that come into view, and whether their pictures are new enough.
class LateSensors {
 public:
  /// Compared with the viewer who gets everything.
  void add(const client::RoomSnapshot& whole, const client::RoomSnapshot& culled,
           const RigidTransform& world_from_head, nanoseconds step) {
    for (const client::RoomSensor& sensor : whole.sensors) {
      const auto other = std::ranges::find(culled.sensors, sensor.id, &client::RoomSensor::id);
      if (!sensor.picture || other == culled.sensors.end() || !other->picture) continue;
      const nanoseconds behind = sensor.picture->capture_time - other->picture->capture_time;
      follow(sensor, other->is_paused || behind > kFramesBehind * interval(), world_from_head,
             step);
    }
  }

  /// Of a viewer who is alone: compared with the age that the pictures of all frames had.
  void add_alone(const client::RoomSnapshot& room, HostTime now, nanoseconds usual_age,
                 const RigidTransform& world_from_head, nanoseconds step) {
    for (const client::RoomSensor& sensor : room.sensors) {
      if (!sensor.picture) continue;
      const bool is_late =
          sensor.is_paused || age_of(sensor, now) > usual_age + kFramesBehind * interval();
      follow(sensor, is_late, world_from_head, step);
    }
  }

  /// Hub and viewers are in this process, so room time is its clock.
  static nanoseconds age_of(const client::RoomSensor& sensor, HostTime now) {
    return now.time_since_epoch() - sensor.picture->capture_time.time_since_epoch();
  }

  /// Of each time that a sensor came into view; sorted.
  [[nodiscard]] std::vector<double> late_ms() const {
    std::vector<double> late = late_ms_;
    for (const auto& [id, watched] : watched_) {
      if (watched.is_seen) late.push_back(watched.late_ms);
    }
    std::ranges::sort(late);
    return late;
  }

 private:
  struct Watched {
    bool is_seen = false;
    double late_ms = 0;
  };

  static nanoseconds interval() { return nanoseconds(std::int64_t(1e9 / kLookingFps)); }

  void follow(const client::RoomSensor& sensor, bool is_late, const RigidTransform& world_from_head,
              nanoseconds step) {
    Watched& watched = watched_[sensor.id];
    const bool is_seen = sees(sensor, world_from_head);
    if (is_seen && !watched.is_seen) watched.late_ms = 0;
    if (is_seen && is_late)
      watched.late_ms += std::chrono::duration<double, std::milli>(step).count();
    if (!is_seen && watched.is_seen) late_ms_.push_back(watched.late_ms);
    watched.is_seen = is_seen;
  }

  /// Really sees: without any margin.
  static bool sees(const client::RoomSensor& sensor, const RigidTransform& world_from_head) {
    const auto lens = client::message_from_calibration(sensor.calibration).depth();
    const hub::SeenSurface surface = hub::seen_surface(
        sensor::coarse_depth(sensor.picture->frame.depth_mm), lens, sensor.pose.world_from_depth);
    const ViewCone view{world_from_head.translation_m.cast<float>(),
                        -world_from_head.rotation.col(2).cast<float>(), looked_angles(),
                        world_from_head.rotation.col(1).cast<float>()};
    constexpr float kRightAngle = 1.5708F;
    hub::VisibilityOptions strict;
    strict.all = strict.base_only = {0, kRightAngle, strict.all.enough};
    return hub::needed_detail(surface, {view}, strict) == hub::Detail::kAll;
  }

  std::map<SensorId, Watched> watched_;
  std::vector<double> late_ms_;
};

struct Sent {
  double bytes = 0, frames = 0;

  [[nodiscard]] double bytes_per_frame() const { return bytes / std::max(1.0, frames); }
};

struct Walk {
  std::vector<LookedMoment> moments;
  LateSensors late;
  double whole_bytes = 0, culled_bytes = 0;
  Sent sent;                    // by the sensors
  std::vector<double> ages_ms;  // of the pictures with all frames
};

void send_pose(client::Subscriber& viewer, const RigidTransform& world_from_head) {
  client::PersonPose pose;
  pose.world_from_head = world_from_head;
  pose.view = looked_angles();
  viewer.send_pose(pose);
}

/// The time in the scene of the newest picture.
nanoseconds scene_time_of(const client::RoomSnapshot& room, int sensors) {
  RoomTime newest{};
  std::size_t newest_sensor = 0;
  for (std::size_t i = 0; i < room.sensors.size(); ++i) {
    const auto& picture = room.sensors[i].picture;
    if (!picture || picture->capture_time < newest) continue;
    newest = picture->capture_time;
    newest_sensor = i;
  }
  const std::string& name = room.sensors[newest_sensor].name;  // "s2"
  return LoopedSource::scene_time(HostTime(newest.time_since_epoch()), std::stoi(name.substr(1)),
                                  sensors, kLookingFps, kLookingFrames);
}

/// When a walk may begin: the sensors show the same at the same place of each walk.
HostTime next_beginning() {
  const nanoseconds period = LoopedSource::period(kLookingFps, kLookingFrames);
  const HostTime beginning((SteadyClock().now().time_since_epoch() / period + 1) * period);
  std::ignore = wait_until(beginning, {});
  return beginning;
}

Sent sent_by_all(const Room& room) {
  Sent sent;
  for (const auto& feed : room.feeds) {
    const sensor::SensorFeedStats stats = feed->stats();
    sent.bytes += static_cast<double>(stats.bytes_sent);
    sent.frames += static_cast<double>(stats.frames_sent);
  }
  return sent;
}

Sent sent_since(const Room& room, const Sent& before) {
  const Sent now = sent_by_all(room);
  return {now.bytes - before.bytes, now.frames - before.frames};
}

void note_ages(const client::RoomSnapshot& room, HostTime now, std::vector<double>& ages_ms) {
  for (const client::RoomSensor& sensor : room.sensors) {
    if (!sensor.picture) continue;
    ages_ms.push_back(
        std::chrono::duration<double, std::milli>(LateSensors::age_of(sensor, now)).count());
  }
}

Walk walk(const Room& room, client::Subscriber& whole, client::Subscriber& culled,
          const ViewerPath& path, const LineBenchOptions& options) {
  Walk walk;
  const HostTime begin = next_beginning();
  const Sent sent_before = sent_by_all(room);
  const double whole_before = static_cast<double>(whole.snapshot()->bytes_received);
  const double culled_before = static_cast<double>(culled.snapshot()->bytes_received);
  HostTime last = begin;
  for (int step = 1; SteadyClock().now() < begin + options.duration; ++step) {
    std::ignore = wait_until(begin + step * kStep, {});
    const HostTime now = SteadyClock().now();
    const RigidTransform head = path.at(now - begin);
    send_pose(culled, head);
    const auto with_all = whole.snapshot(), with_some = culled.snapshot();
    walk.late.add(*with_all, *with_some, head, now - std::exchange(last, now));
    note_ages(*with_all, now, walk.ages_ms);
    if (step % kStepsPerPicture == 0)
      walk.moments.push_back(
          {with_all, with_some, head, scene_time_of(*with_all, options.sensors)});
  }
  walk.whole_bytes = static_cast<double>(whole.snapshot()->bytes_received) - whole_before;
  walk.culled_bytes = static_cast<double>(culled.snapshot()->bytes_received) - culled_before;
  walk.sent = sent_since(room, sent_before);
  std::ranges::sort(walk.ages_ms);
  return walk;
}

/// The same walk without the viewer who gets everything. Its pictures go to the moments of the walk
/// before.
Walk walk_alone(const Room& room, client::Subscriber& viewer, const ViewerPath& path,
                nanoseconds usual_age, std::vector<LookedMoment>& moments,
                const LineBenchOptions& options) {
  Walk walk;
  const HostTime begin = next_beginning();
  const Sent sent_before = sent_by_all(room);
  HostTime last = begin;
  for (int step = 1; SteadyClock().now() < begin + options.duration; ++step) {
    std::ignore = wait_until(begin + step * kStep, {});
    const HostTime now = SteadyClock().now();
    const RigidTransform head = path.at(now - begin);
    send_pose(viewer, head);
    const auto seen = viewer.snapshot();
    walk.late.add_alone(*seen, now, usual_age, head, now - std::exchange(last, now));
    const auto picture = static_cast<std::size_t>(step / kStepsPerPicture);
    if (step % kStepsPerPicture != 0 || picture > moments.size()) continue;
    moments[picture - 1].alone = seen;
    moments[picture - 1].alone_scene_time = scene_time_of(*seen, options.sensors);
  }
  walk.sent = sent_since(room, sent_before);
  return walk;
}

/// CPU time of the decisions for many viewers on this path, who started at different times, as a
/// share of one core.
double decision_cost(const client::RoomSnapshot& room, const ViewerPath& path) {
  hub::ViewCulling culling;
  for (const client::RoomSensor& sensor : room.sensors) {
    if (!sensor.picture) continue;
    culling.set_surface(
        sensor.id, hub::seen_surface(sensor::coarse_depth(sensor.picture->frame.depth_mm),
                                     client::message_from_calibration(sensor.calibration).depth(),
                                     sensor.pose.world_from_depth));
  }
  constexpr auto kDuration = 5s;
  std::size_t changes = 0;
  std::clock_t cpu = 0;
  for (nanoseconds time = 0s; time < kDuration; time += kStep) {
    std::vector<wire::pb::ViewerPose> poses;
    for (int viewer = 0; viewer < kManyViewers; ++viewer) {
      client::PersonPose pose;
      pose.world_from_head = path.at(time + viewer * 1s);
      pose.view = looked_angles();
      poses.push_back(client::message_from_pose(pose));
    }
    const std::clock_t before = std::clock();
    for (std::size_t viewer = 0; viewer < poses.size(); ++viewer)
      culling.viewer_moved(ConnectionId{viewer}, poses[viewer], RoomTime(time));
    changes += culling.update(RoomTime(time)).size();
    cpu += std::clock() - before;
  }
  return static_cast<double>(cpu) / CLOCKS_PER_SEC /
         std::chrono::duration<double>(kDuration).count();
}

double sorted_percentile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

Status measure_looking(const LineBenchOptions& options,
                       const std::function<void(const std::string&)>& progress,
                       LineReport& report) {
  const auto say = [&](const std::string& what) {
    if (progress) progress(what);
  };
  auto path = options.viewer_path.empty()
                  ? Result<ViewerPath>(ViewerPath::round_walk(kRadius_m, 5min))
                  : ViewerPath::read(options.viewer_path);
  if (!path) return path.error();
  auto room = open_room(options, say);
  if (!room) return room.error();
  const ViewerPath in_room = path->around(room->middle_m);
  auto whole = viewer_of(*room);
  if (!whole) return whole.error();
  auto culled = viewer_of(*room);
  if (!culled) return culled.error();
  say("warming up");
  std::this_thread::sleep_for(kLookingWarmUp);
  say("walking");
  Walk walked = walk(*room, **whole, **culled, in_room, options);
  const double usual_age_ms = sorted_percentile(walked.ages_ms, 0.95);
  const client::RoomSnapshot last_whole = *(*whole)->snapshot();
  whole->reset();
  say("walking alone");
  const Walk alone = walk_alone(*room, **culled, in_room,
                                nanoseconds(static_cast<std::int64_t>(usual_age_ms * 1e6)),
                                walked.moments, options);
  say("sent to him alone: " +
      std::to_string(static_cast<int>(100 * alone.sent.bytes / walked.sent.bytes)) +
      " % of all bytes");
  const double many_share = decision_cost(last_whole, in_room);
  room->feeds.clear();
  const auto quality = compare_pictures(walked.moments, options.scene, progress);
  if (!quality) return quality.error();

  const std::vector<double> late_ms = walked.late.late_ms();
  const std::vector<double> late_alone_ms = alone.late.late_ms();
  const double seconds = std::chrono::duration<double>(options.duration).count();
  const auto add = [&](const char* name, const char* unit, double value) {
    report.figures.push_back({std::string("looking: ") + name, unit, value});
  };
  add("bytes of all frames", "kB/s", walked.whole_bytes / seconds / 1e3);
  add("bytes", "kB/s", walked.culled_bytes / seconds / 1e3);
  add("bytes", "% of all", 100 * walked.culled_bytes / walked.whole_bytes);
  add("PSNR with all frames", "dB", quality->whole_db);
  add("PSNR", "dB", quality->culled_db);
  add("pictures", "", quality->moments);
  add("times that a sensor came into view", "", static_cast<double>(late_ms.size()));
  add("without a new picture, 99 %", "ms", sorted_percentile(late_ms, 0.99));
  add("without a new picture, longest", "ms", late_ms.empty() ? 0 : late_ms.back());
  add("sensors send all frames", "kB/s", walked.sent.bytes / seconds / 1e3);
  add("sensors send to him alone", "kB/s", alone.sent.bytes / seconds / 1e3);
  add("sensors send to him alone", "% of all", 100 * alone.sent.bytes / walked.sent.bytes);
  add("frames that sensors send to him alone", "% of all",
      100 * alone.sent.frames / walked.sent.frames);
  add("sensors send to him alone, bytes of a frame", "% of all",
      100 * alone.sent.bytes_per_frame() / walked.sent.bytes_per_frame());
  add("alone, PSNR", "dB", quality->alone_db);
  add("alone, age of a picture that counts as usual", "ms", usual_age_ms);
  add("alone, times that a sensor came into view", "", static_cast<double>(late_alone_ms.size()));
  add("alone, without a new picture, 99 %", "ms", sorted_percentile(late_alone_ms, 0.99));
  add("alone, without a new picture, longest", "ms",
      late_alone_ms.empty() ? 0 : late_alone_ms.back());
  add("deciding for 500 viewers", "% of a core", 100 * many_share);
  return {};
}

}  // namespace roomcast::bench
