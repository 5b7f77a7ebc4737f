// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/room_aligner.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <boost/asio/post.hpp>
#include <google/protobuf/util/message_differencer.h>

#include "roomcast/alignment/service/alignment_worker.h"
#include "roomcast/client/hub_link.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/client/room/calibration_message.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::alignment {

namespace {

namespace pb = wire::pb;

pb::Join join_message(const RoomAlignerOptions& options) {
  pb::Join join;
  join.set_room(options.room);
  join.set_name("aligner");
  join.set_token(options.token);
  join.mutable_aligner();
  return join;
}

}  // namespace

class RoomAligner::Link final : public client::HubLinkEvents {
 public:
  Link(std::vector<net::HubUrl> hubs, RoomAlignerOptions options)
      : options_(std::move(options)),
        link_(network_.io(), std::move(hubs), join_message(options_), *this),
        alignment_worker_([this](AlignmentUpdate update) { publish(std::move(update)); }) {
    link_.start();
    network_.start();
  }
  ~Link() override {
    network_.finish([this] { link_.stop(); });
  }

  void on_welcome(const pb::Welcome&) override { asked_for_.Clear(); }
  void on_control(const pb::Control& message) override {
    if (message.has_roster()) take_roster(message.roster());
    if (message.has_calibration_bundle()) take_bundle(message.calibration_bundle());
    if (message.has_sightings()) take_sightings(message.sightings());
    if (message.has_depth_instant()) take_instant(message.depth_instant());
    if (message.has_nudge()) take_nudge(message.nudge());
  }
  void on_frame(net::MessageBuffer) override {}  // a hub sends no frames to an aligner
  net::FramedMessagePtr next_frame() override { return nullptr; }
  void on_clock(const client::ClockEstimate&) override {}
  void on_down(const Error& reason, bool final) override {
    sensors_.clear();  // a restarted hub has an empty roster; that does not invalidate bundles
    if (options_.log) options_.log(final ? LogLevel::kError : LogLevel::kWarning, reason.message);
  }

 private:
  struct Sensor {
    std::string name;
    SensorCalibration calibration;
    bool moved = false;
  };

  void take_roster(const pb::Roster& roster) {
    KnownRoom known;
    bool has_unplaced = false;
    const auto before = std::exchange(sensors_, {});
    for (const pb::SensorEntry& entry : roster.sensors()) {
      auto calibration = client::calibration_from_message(entry.calibration());
      auto pose = wire::read_pose(entry);
      if (!calibration || !pose) continue;
      sensors_[entry.id()] = {entry.name(), *std::move(calibration), pose->is_moved()};
      has_unplaced |= entry.online() && (pose->is_moved() || pose->source != PoseSource::kGiven);
      if (pose->is_moved()) {
        const auto then = before.find(entry.id());
        if (then != before.end() && !then->second.moved) alignment_worker_.forget(entry.name());
        continue;
      }
      known[entry.name()] = {*std::move(pose), entry.online()};
    }
    for (const auto& [id, sensor] : before) {
      const auto same_name = [&](const auto& entry) { return entry.second.name == sensor.name; };
      if (std::ranges::none_of(sensors_, same_name)) alignment_worker_.forget(sensor.name);
    }
    alignment_worker_.set_known(std::move(known), has_unplaced);
  }

  void take_bundle(const pb::CalibrationBundle& message) {
    const auto sensor = sensors_.find(message.sensor_id());
    if (sensor == sensors_.end()) return;
    alignment_worker_.add(sensor->second.name, sensor->second.calibration, message);
  }

  void take_sightings(const pb::Sightings& sightings) {
    const auto sensor = sensors_.find(sightings.sensor_id());
    if (sensor != sensors_.end()) alignment_worker_.see(sensor->second.name, sightings);
  }

  void take_instant(const pb::DepthInstant& instant) {
    const auto sensor = sensors_.find(instant.sensor_id());
    if (sensor != sensors_.end())
      alignment_worker_.see(sensor->second.name, sensor->second.calibration, instant);
  }

  void take_nudge(const pb::Nudge& nudge) {
    const auto sensor = sensors_.find(nudge.sensor_id());
    const auto pose = wire::read_transform(nudge.world_from_depth());
    if (sensor != sensors_.end() && pose) alignment_worker_.nudge(sensor->second.name, *pose);
  }

  /// Called on the worker's thread.
  void publish(AlignmentUpdate update) {
    boost::asio::post(network_.io(), [this, update = std::move(update)] {
      send(update.placements);
      ask_for_sightings(update.wanted);
    });
  }

  void ask_for_sightings(const pb::SightingRequest& wanted) {
    if (google::protobuf::util::MessageDifferencer::Equals(wanted, asked_for_)) return;
    asked_for_ = wanted;
    pb::Control message;
    *message.mutable_sighting_request() = wanted;
    link_.send(message);
  }

  void send(const std::vector<Placement>& placements) {
    pb::Control message;
    for (const Placement& placement : placements) {
      log(placement);
      for (const auto& [id, sensor] : sensors_) {
        if (sensor.name != placement.sensor) continue;
        auto& found = *message.mutable_placements()->add_sensors();
        found.set_sensor_id(id);
        wire::write_pose(placement.pose, found);
        found.set_bundle_number(placement.bundle_number);
        found.set_withdrawn(placement.withdrawn);
      }
    }
    link_.send(message);
  }

  /// Logs a placement unless it repeats the last sentence about the sensor.
  void log(const Placement& placement) {
    const std::string sentence =
        placement.pose.is_placed()
            ? "sensor \"" + placement.sensor + "\" is placed"
            : "sensor \"" + placement.sensor + "\" cannot be placed: " + placement.pose.note;
    std::string& last = logged_[placement.sensor];
    if (last == sentence) return;
    last = sentence;
    if (options_.log) options_.log(LogLevel::kInfo, sentence);
  }

  const RoomAlignerOptions options_;
  std::map<std::uint32_t, Sensor> sensors_;    // by id; this and the following: network thread only
  std::map<std::string, std::string> logged_;  // the last sentence by sensor
  pb::SightingRequest asked_for_;
  client::NetworkThread network_;
  client::HubLink link_;
  AlignmentWorker alignment_worker_;  // declared last: destroyed before the rest
};

RoomAligner::RoomAligner(std::unique_ptr<Link> link) : link_(std::move(link)) {}
RoomAligner::~RoomAligner() = default;

Result<std::unique_ptr<RoomAligner>> RoomAligner::open(RoomAlignerOptions options) {
  auto hubs = net::parse_hub_urls(options.hub_url);
  if (!hubs) return hubs.error();
  return std::unique_ptr<RoomAligner>(
      new RoomAligner(std::make_unique<Link>(*std::move(hubs), std::move(options))));
}

}  // namespace roomcast::alignment
