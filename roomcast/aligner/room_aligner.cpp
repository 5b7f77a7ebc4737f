// SPDX-License-Identifier: Apache-2.0
#include "roomcast/aligner/room_aligner.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include <boost/asio/post.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "roomcast/aligner/bundle_message.h"
#include "roomcast/aligner/room_placing.h"
#include "roomcast/client/calibration_message.h"
#include "roomcast/client/hub_link.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/wire/limits.h"

namespace roomcast::aligner {

namespace {

using namespace std::chrono_literals;
namespace pb = wire::pb;

/// Sensors often come together; one thought for all is cheaper than one for each.
constexpr auto kWaitForMore = 500ms;
constexpr int kNiceness = 10;

pb::Join join_message(const RoomAlignerOptions& options) {
  pb::Join join;
  join.set_room(options.room);
  join.set_name("aligner");
  join.mutable_aligner()->set_key(options.key);
  return join;
}

/// What has come in since the last thought: of each sensor the newest.
struct News {
  struct Bundle {
    SensorCalibration calibration;
    pb::CalibrationBundle message;
  };
  std::map<std::string, Bundle> bundles;
  std::set<std::string> moved;  // and have not sent another bundle yet
  KnownPoses given, found_before;
  bool somebody_is_lost = false;  // a sensor that is here does not know where it stands
};

}  // namespace

/// Thinks, on a thread of its own.
class RoomAligner::Worker {
 public:
  using Tell = std::function<void(std::vector<Placement>)>;

  explicit Worker(Tell tell)
      : tell_(std::move(tell)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

  void add(const std::string& sensor, News::Bundle bundle) {
    {
      const std::lock_guard lock(mutex_);
      news_.bundles[sensor] = std::move(bundle);
    }
    changed_.notify_all();
  }
  /// What came before no longer holds.
  void forget(const std::string& sensor) {
    const std::lock_guard lock(mutex_);
    news_.bundles.erase(sensor);
    news_.moved.insert(sensor);
  }
  void set_known(KnownPoses given, KnownPoses found_before, bool somebody_is_lost) {
    {
      const std::lock_guard lock(mutex_);
      news_.given = std::move(given);
      news_.found_before = std::move(found_before);
      news_.somebody_is_lost = somebody_is_lost;
    }
    changed_.notify_all();
  }

 private:
  void run(const std::stop_token& stop) {
    // Linux: of this thread alone. Frames go before thoughts.
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNiceness);
    while (auto news = wait_for_news(stop)) {
      for (const auto& sensor : news->moved) placing_.forget(sensor);
      for (const auto& [sensor, bundle] : news->bundles) take(sensor, bundle);
      auto placements = placing_.solve(news->given, news->found_before);
      for (auto& placement : placements)
        placement.bundle_number = bundle_numbers_[placement.sensor];
      if (!stop.stop_requested()) tell_(std::move(placements));
    }
  }

  std::optional<News> wait_for_news(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    const auto worth_a_thought = [this] {
      return !news_.bundles.empty() && news_.somebody_is_lost;
    };
    if (!changed_.wait(lock, stop, worth_a_thought)) return std::nullopt;
    changed_.wait_for(lock, stop, kWaitForMore, [] { return false; });
    if (stop.stop_requested()) return std::nullopt;
    News news = news_;
    news_.bundles.clear();
    news_.moved.clear();
    return news;
  }

  void take(const std::string& sensor, const News::Bundle& news) {
    bundle_numbers_[sensor] = news.message.number();
    const auto bundle = bundle_from_message(news.message, sensor, news.calibration);
    if (!bundle) return placing_.refuse(sensor, bundle.error().message);
    placing_.add(*bundle);
  }

  const Tell tell_;
  RoomPlacing placing_;  // the thread's own, as is what follows
  std::map<std::string, std::uint32_t> bundle_numbers_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  News news_;
  std::jthread thread_;
};

class RoomAligner::Link final : public HubLinkEvents {
 public:
  Link(net::HubUrl hub, RoomAlignerOptions options)
      : options_(std::move(options)),
        link_(network_.io(), std::move(hub), join_message(options_), *this),
        worker_([this](auto placements) { tell(std::move(placements)); }) {
    link_.start();
    network_.start();
  }
  ~Link() override {
    network_.finish([this] { link_.stop(); });
  }

  void on_welcome(const pb::Welcome&) override {}
  void on_control(const pb::Control& message) override {
    if (message.has_roster()) take_roster(message.roster());
    if (message.has_calibration_bundle()) take_bundle(message.calibration_bundle());
  }
  void on_frame(net::MessageBuffer) override {}  // a hub sends an aligner none
  net::SealedMessagePtr next_frame() override { return nullptr; }
  void on_clock(const ClockEstimate&) override {}
  void on_down(const Error& reason, bool final) override {
    if (options_.log) options_.log(final ? LogLevel::kError : LogLevel::kWarning, reason.message);
  }

 private:
  struct Sensor {
    std::string name;
    SensorCalibration calibration;
    bool moved = false;
  };

  void take_roster(const pb::Roster& roster) {
    KnownPoses given, found_before;
    bool somebody_is_lost = false;
    const auto before = std::exchange(sensors_, {});
    for (const pb::SensorEntry& entry : roster.sensors()) {
      auto calibration = calibration_from_message(entry.calibration());
      const auto pose = read_transform(entry.world_from_depth());
      if (!calibration || !pose) continue;
      sensors_[entry.id()] = {entry.name(), *std::move(calibration), entry.moved()};
      somebody_is_lost |=
          entry.online() && (entry.moved() || entry.placement() != pb::PLACEMENT_GIVEN);
      if (entry.moved()) {
        const auto then = before.find(entry.id());
        if (then != before.end() && !then->second.moved) worker_.forget(entry.name());
        continue;
      }
      if (entry.placement() == pb::PLACEMENT_GIVEN) given[entry.name()] = *pose;
      if (entry.placement() == pb::PLACEMENT_ALIGNED) found_before[entry.name()] = *pose;
    }
    worker_.set_known(std::move(given), std::move(found_before), somebody_is_lost);
  }

  void take_bundle(const pb::CalibrationBundle& message) {
    const auto sensor = sensors_.find(message.sensor_id());
    if (sensor == sensors_.end()) return;
    worker_.add(sensor->second.name, {sensor->second.calibration, message});
  }

  /// From the worker's thread.
  void tell(std::vector<Placement> placements) {
    boost::asio::post(network_.io(),
                      [this, placements = std::move(placements)] { send(placements); });
  }

  void send(const std::vector<Placement>& placements) {
    pb::Control message;
    for (const Placement& placement : placements) {
      log(placement);
      for (const auto& [id, sensor] : sensors_) {
        if (sensor.name != placement.sensor) continue;
        auto& found = *message.mutable_placements()->add_sensors();
        found.set_sensor_id(id);
        found.set_expected_error_mm(static_cast<float>(placement.expected_error_mm));
        found.set_bundle_number(placement.bundle_number);
        found.set_note(placement.note.substr(0, wire::kMaxNoteBytes));
        if (placement.world_from_depth) {
          write_transform(*placement.world_from_depth, *found.mutable_world_from_depth());
        }
      }
    }
    link_.send(message);
  }

  void log(const Placement& placement) const {
    if (!options_.log) return;
    options_.log(LogLevel::kInfo,
                 placement.world_from_depth
                     ? "sensor \"" + placement.sensor + "\" is placed"
                     : "sensor \"" + placement.sensor + "\" cannot be placed: " + placement.note);
  }

  const RoomAlignerOptions options_;
  std::map<std::uint32_t, Sensor> sensors_;  // by id; the network thread's own
  NetworkThread network_;
  HubLink link_;
  Worker worker_;  // last: ends first, and tells nobody after that
};

RoomAligner::RoomAligner(std::unique_ptr<Link> link) : link_(std::move(link)) {}
RoomAligner::~RoomAligner() = default;

Result<std::unique_ptr<RoomAligner>> RoomAligner::open(RoomAlignerOptions options) {
  auto hub = net::parse_hub_url(options.hub_url);
  if (!hub) return hub.error();
  return std::unique_ptr<RoomAligner>(
      new RoomAligner(std::make_unique<Link>(*std::move(hub), std::move(options))));
}

}  // namespace roomcast::aligner
