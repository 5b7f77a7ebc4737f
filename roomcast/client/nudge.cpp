// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/nudge.h"

#include <algorithm>
#include <future>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "roomcast/client/hub_link.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::client {
namespace {

namespace pb = wire::pb;
using Answer = Result<NudgedSensor>;

pb::Join join_message(const NudgeOptions& options) {
  pb::Join join;
  join.set_room(options.room);
  show(options.credential, join);
  join.mutable_viewer();
  return join;
}

/// Sends one prior and waits for the answer: a change of the sensor's entry in the roster.
class NudgeRequest final : public HubLinkEvents {
 public:
  NudgeRequest(std::vector<net::HubUrl> hubs, const NudgeOptions& options)
      : options_(options), link_(network_.io(), std::move(hubs), join_message(options), *this) {
    link_.start();
    network_.start();
  }
  ~NudgeRequest() override {
    network_.finish([this] { link_.stop(); });
  }

  Answer wait() {
    auto answer = answer_.get_future();
    if (answer.wait_for(options_.patience) == std::future_status::ready) return answer.get();
    return Error{ErrorCode::kUnavailable,
                 "the hub's aligner has not answered; check that the hub runs without --no-align"};
  }

  void on_welcome(const pb::Welcome&) override { before_.reset(); }
  void on_control(const pb::Control& message) override {
    if (message.has_roster()) take(message.roster());
  }
  void on_frame(net::MessageBuffer) override {}
  net::FramedMessagePtr next_frame() override { return nullptr; }
  void on_clock(const ClockEstimate&) override {}
  void on_down(const Error& reason, bool) override { answer(reason); }

 private:
  void take(const pb::Roster& roster) {
    const auto entry = std::ranges::find(roster.sensors(), options_.sensor, &pb::SensorEntry::name);
    if (entry == roster.sensors().end()) {
      return answer(
          Error{ErrorCode::kNotFound, "the room has no sensor \"" + options_.sensor + "\""});
    }
    if (entry->placement() == pb::PLACEMENT_GIVEN && !entry->moved()) {
      return answer(Error{ErrorCode::kUnavailable,
                          "the sensor \"" + options_.sensor +
                              "\" has supplied its pose, which therefore holds; start the sensor "
                              "again with another one, or without one"});
    }
    const auto pose = wire::read_transform(entry->world_from_depth());
    if (!pose) return answer(pose.error());
    if (!before_) return ask(*entry, *pose);
    const bool moved = !std::ranges::equal(entry->world_from_depth(), before_->world_from_depth());
    if (moved) return answer(NudgedSensor{*pose, double(entry->expected_error_mm())});
    if (entry->placement_note() != before_->placement_note())
      answer(Error{ErrorCode::kUnavailable, entry->placement_note()});
  }

  void ask(const pb::SensorEntry& entry, const RigidTransform& pose) {
    before_ = entry;
    pb::Control message;
    message.mutable_nudge()->set_sensor_id(entry.id());
    wire::write_transform(nudged(pose, options_),
                          *message.mutable_nudge()->mutable_world_from_depth());
    link_.send(message);
  }

  /// Only the first answer counts.
  void answer(Answer found) {
    if (!std::exchange(answered_, true)) answer_.set_value(std::move(found));
  }

  const NudgeOptions& options_;
  std::promise<Answer> answer_;
  NetworkThread network_;
  std::optional<pb::SensorEntry> before_;  // this and the following: network thread only
  bool answered_ = false;
  HubLink link_;
};

}  // namespace

RigidTransform nudged(const RigidTransform& world_from_depth, const NudgeOptions& options) {
  const Eigen::AngleAxisd turn(options.turn_rad, Eigen::Vector3d::UnitY());  // world axis
  const Eigen::AngleAxisd tilt(options.tilt_rad, Eigen::Vector3d::UnitX());  // sensor axis
  return {turn * world_from_depth.rotation * tilt,
          world_from_depth.translation_m + options.shift_m};
}

Result<NudgedSensor> nudge_sensor(const NudgeOptions& options) {
  auto hubs = net::parse_hub_urls(options.hub_url);
  if (!hubs) return hubs.error();
  if (auto status = check_join(options.room, "viewer", {}, options.credential); !status)
    return status.error();
  return NudgeRequest(*std::move(hubs), options).wait();
}

}  // namespace roomcast::client
