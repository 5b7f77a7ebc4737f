// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/modeler/room_modeler.h"

#include <algorithm>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include "roomcast/client/subscriber.h"
#include "roomcast/core/interruptible_wait.h"
#include "roomcast/recording/live_sets/live_sets.h"
#include "roomcast/recording/mesh/mesh_writer.h"
#include "roomcast/recording/modeler/cpu_allowance.h"
#include "roomcast/recording/modeler/kept_views.h"
#include "roomcast/recording/modeler/model_pieces.h"
#include "roomcast/recording/modeler/view_folder.h"

namespace roomcast::recording {
namespace {

using namespace std::chrono_literals;

constexpr int kModelerNiceness = 15;  // frames and alignment go first
constexpr auto kWaitForPictures = 500ms;
constexpr auto kTryAgain = 3s;
constexpr auto kBetweenRequests = 4s;
constexpr auto kBetweenSaves = 60s;
/// From the first view in which something is different: the other sensors' follow.
constexpr auto kSettle = 1500ms;

std::uint64_t milliseconds_since_1970() {
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(
                                        std::chrono::system_clock::now().time_since_epoch())
                                        .count());
}

nanoseconds thread_cpu_time() {
  ::timespec spent{};
  (void)::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
  return std::chrono::seconds(spent.tv_sec) + nanoseconds(spent.tv_nsec);
}

void lower_priority() {
  // On Linux this sets the niceness of this thread only.
  (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kModelerNiceness);
}

}  // namespace

model::ModelOptions running_room_options() {
  model::ModelOptions options;
  options.voxel_m = 0.02F;
  options.memory_frames = 9;
  return options;
}

class RoomModeler::Work {
 public:
  explicit Work(RoomModelerOptions options)
      : options_(std::move(options)),
        views_(options_.model),
        thread_([this](const std::stop_token& stop) { run(stop); }) {}

  std::shared_ptr<const std::string> changes_after(std::uint64_t known) const {
    const std::lock_guard lock(mutex_);
    if (pieces_.version() == 0 || known >= pieces_.version()) return nullptr;
    if (known == known_ && changes_) return changes_;
    known_ = known;
    changes_ = std::make_shared<const std::string>(pieces_.changes_after(known));
    return changes_;
  }

 private:
  void run(const std::stop_token& stop);
  void follow(client::Subscriber& room, const std::stop_token& stop);
  void take(const client::RoomSnapshot& room);
  void ask_for_more(const client::RoomSnapshot& room, client::Subscriber& subscriber);
  void fuse_when_due(const std::stop_token& stop);
  void start_fusing(const std::stop_token& stop);
  void finish_fusing();
  struct Fused {
    nanoseconds spent{};  // CPU time
    bool is_different = false;
    Status status;
  };
  Fused fuse(const std::vector<model::ViewSurface>& views, const std::stop_token& stop);
  void load();
  void save();
  void warn(const Error& error);

  const RoomModelerOptions options_;
  // On the thread only.
  KeptViews views_;
  LiveSets sets_;
  SteadyClock clock_;
  HostTime next_request_{}, next_save_{};
  CpuAllowance fusing_time_;         // a room in which much changes must not keep a core busy
  std::optional<HostTime> noticed_;  // when something was different first; not fused yet
  /// Sensors that the hub has named. One that it names no longer was sent away; one that it has not
  /// named yet may still come.
  std::set<std::string> listed_;
  /// A picture is in many snapshots, and its time is another one once the clock is known better.
  std::map<SensorId, std::shared_ptr<const codec::DecodedFrame>> taken_;
  /// On a thread of its own, where the system has one: meanwhile key frames come, and one that is
  /// not taken is lost.
  std::future<Fused> fusing_;
  bool is_changing_ = false;  // the newest model looks different from the one before
  bool is_unsaved_ = false;
  std::string warned_;  // the last warning; it is not repeated

  mutable std::mutex mutex_;
  ModelPieces pieces_;  // by all
  mutable std::uint64_t known_ = 0;
  mutable std::shared_ptr<const std::string> changes_;  // after known_: viewers ask for the same
  std::jthread thread_;                                 // last: uses all of the above
};

void RoomModeler::Work::run(const std::stop_token& stop) {
  lower_priority();
  load();
  start_fusing(stop);
  while (!stop.stop_requested()) {
    auto room = client::Subscriber::open({.hub_url = options_.hub_url,
                                          .room = options_.room,
                                          .credential = {.token = options_.token, .code = {}},
                                          .name = "modeler",
                                          .is_modeler = true,
                                          .log = {},
                                          .stop = stop});
    if (room) {
      follow(**room, stop);
    } else if (!stop.stop_requested()) {
      warn(room.error());
    }
    (void)wait_for(kTryAgain, stop);
  }
  if (fusing_.valid()) finish_fusing();
  save();
}

/// Until the connection has ended for good.
void RoomModeler::Work::follow(client::Subscriber& room, const std::stop_token& stop) {
  std::uint64_t revision = 0;
  while (!stop.stop_requested() && !room.failure()) {
    const auto snapshot = room.wait_newer(revision, kWaitForPictures);
    if (snapshot->revision != revision) {
      revision = snapshot->revision;
      take(*snapshot);
      if (clock_.now() >= next_request_) ask_for_more(*snapshot, room);
      if (!noticed_ && views_.are_worth_fusing(is_changing_)) noticed_ = clock_.now();
    }
    fuse_when_due(stop);
    if (clock_.now() >= next_save_) save();
  }
}

void RoomModeler::Work::take(const client::RoomSnapshot& room) {
  if (!room.sensors_known) return;
  for (const std::string& name : views_.sensors()) {
    const auto sensor = std::ranges::find(room.sensors, name, &client::RoomSensor::name);
    const bool is_here = sensor != room.sensors.end();
    if (is_here ? sensor->pose.is_moved() : listed_.contains(name)) views_.forget(name);
  }
  for (const client::RoomSensor& sensor : room.sensors) listed_.insert(sensor.name);
  LiveSet live = sets_.set_of(room);
  std::erase_if(live.set.frames, [&](const SetFrame& frame) {
    const client::RoomSensor& sensor = room.sensors[frame.sensor];
    if (sensor.pose.is_moved() || !frame.world_from_depth) return true;
    return std::exchange(taken_[sensor.id], frame.pictures) == frame.pictures;
  });
  if (auto status = views_.add(live.sensors, live.set); !status) warn(status.error());
}

/// A new view is known soon: sensors that nobody records send few key frames by themselves.
void RoomModeler::Work::ask_for_more(const client::RoomSnapshot& room,
                                     client::Subscriber& subscriber) {
  next_request_ = clock_.now() + kBetweenRequests;
  for (const client::RoomSensor& sensor : room.sensors) {
    if (sensor.online && views_.needs_more_of(sensor.name)) subscriber.ask_for_key(sensor.id);
  }
}

void RoomModeler::Work::fuse_when_due(const std::stop_token& stop) {
  if (fusing_.valid()) {
    if (fusing_.wait_for(0s) == std::future_status::timeout) return;
    finish_fusing();
  }
  if (!noticed_ || clock_.now() < std::max(*noticed_ + kSettle, fusing_time_.next())) return;
  noticed_.reset();
  start_fusing(stop);
}

void RoomModeler::Work::start_fusing(const std::stop_token& stop) {
  if (!views_.are_worth_fusing(is_changing_)) return;
  const auto views = std::make_shared<const std::vector<model::ViewSurface>>(views_.surfaces());
  const auto work = [this, stop, views] {
    lower_priority();
    return fuse(*views, stop);
  };
  try {
    fusing_ = std::async(std::launch::async, work);
  } catch (const std::system_error&) {
    // The system has no thread to give: finish_fusing does the work itself.
    fusing_ = std::async(std::launch::deferred, work);
  }
}

void RoomModeler::Work::finish_fusing() {
  const Fused fused = fusing_.get();
  if (!fused.status) warn(fused.status.error());
  is_unsaved_ = true;
  is_changing_ = fused.is_different;
  fusing_time_.spent(fused.spent, clock_.now());
}

RoomModeler::Work::Fused RoomModeler::Work::fuse(const std::vector<model::ViewSurface>& views,
                                                 const std::stop_token& stop) {
  const nanoseconds before = thread_cpu_time();
  MeshWriterOptions meshing;
  meshing.model = options_.model;
  meshing.colored_only = true;  // viewers give what is left out the colour around it
  const auto mesh = mesh_surfaces(views, meshing, {}, Workers(1, stop));
  if (stop.stop_requested()) return {};
  bool is_different = false;
  {
    // Coding takes long, and viewers who ask meanwhile wait on the hub's thread for rooms.
    ModelPieces pieces = pieces_;
    is_different = pieces.update(mesh ? *mesh : model::RoomMesh(),
                                 std::max(milliseconds_since_1970(), pieces.version() + 1));
    const std::lock_guard lock(mutex_);
    pieces_ = std::move(pieces);
    changes_.reset();
  }
  const bool is_failure = !mesh && mesh.error().code != ErrorCode::kNotFound;
  return {thread_cpu_time() - before, is_different, is_failure ? Status(mesh.error()) : Status()};
}

void RoomModeler::Work::load() {
  if (options_.folder.empty()) return;
  auto saved = read_views(options_.folder);
  if (!saved) {
    if (saved.error().code != ErrorCode::kNotFound) warn(saved.error());
    return;
  }
  if (auto status = views_.add_saved(*saved); !status) warn(status.error());
}

void RoomModeler::Work::save() {
  if (options_.folder.empty() || !std::exchange(is_unsaved_, false)) return;
  next_save_ = clock_.now() + kBetweenSaves;
  if (auto status = write_views(options_.folder, views_.saved()); !status) warn(status.error());
}

void RoomModeler::Work::warn(const Error& error) {
  if (std::exchange(warned_, error.message) == error.message || !options_.log) return;
  options_.log(LogLevel::kWarning, "the model of room \"" + options_.room + "\": " + error.message);
}

RoomModeler::RoomModeler(RoomModelerOptions options)
    : work_(std::make_unique<Work>(std::move(options))) {}
RoomModeler::~RoomModeler() = default;

std::shared_ptr<const std::string> RoomModeler::changes_after(std::uint64_t known) const {
  return work_->changes_after(known);
}

}  // namespace roomcast::recording
