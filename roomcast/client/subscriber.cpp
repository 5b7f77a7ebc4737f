// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/subscriber.h"

#include <condition_variable>
#include <map>
#include <mutex>
#include <utility>

#include "roomcast/client/hub_link.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/client/room/room_state.h"
#include "roomcast/client/stop_notice.h"
#include "roomcast/client/voice_sender.h"
#include "roomcast/net/random_bytes.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::client {
namespace {

std::string new_author_key() {
  std::string key(32, '\0');
  net::fill_with_random_bytes(
      std::span(reinterpret_cast<std::uint8_t*>(key.data()), key.size()));  // NOLINT: bytes
  return key;
}

wire::pb::Join join_message(const SubscriberOptions& options) {
  wire::pb::Join join;
  join.set_room(options.room);
  show(options.credential, join);
  join.set_name(options.name);
  if (options.is_modeler) {
    join.mutable_modeler();
    return join;
  }
  join.mutable_viewer()->set_hears(options.hears);
  join.mutable_viewer()->set_author_key(options.author_key.empty() ? new_author_key()
                                                                   : options.author_key);
  return join;
}

wire::pb::Control key_request(SensorId sensor) {
  wire::pb::Control control;
  control.mutable_key_request()->set_sensor_id(sensor.value);
  return control;
}

}  // namespace

class Subscriber::Link final : public HubLinkEvents {
 public:
  Link(std::vector<net::HubUrl> hubs, SubscriberOptions options)
      : options_(std::move(options)),
        link_(network_.io(), std::move(hubs), join_message(options_), *this) {
    link_.start();
    network_.start();
  }
  ~Link() override {
    network_.finish([this] { link_.stop(); });
  }

  /// Waits until welcomed, or until the first attempt has failed.
  Status wait_for_welcome() {
    const StopNotice notice(options_.stop, mutex_, changed_);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return newest_->revision > 0 || options_.stop.stop_requested(); });
    if (newest_->connected) return {};
    return down_ ? *down_ : stopped_waiting();
  }

  std::shared_ptr<const RoomSnapshot> snapshot() const {
    std::lock_guard lock(mutex_);
    return newest_;
  }
  std::shared_ptr<const RoomSnapshot> wait_newer(std::uint64_t revision,
                                                 std::chrono::milliseconds timeout) const {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, timeout, [&] { return newest_->revision > revision || failure_; });
    return newest_;
  }
  std::optional<Error> failure() const {
    std::lock_guard lock(mutex_);
    return failure_;
  }

  void send(wire::pb::Control message) {
    boost::asio::post(network_.io(), [this, message = std::move(message)] { link_.send(message); });
  }

  void say(std::vector<std::uint8_t> opus, bool ends, HostTime first_sample) {
    boost::asio::post(network_.io(), [this, opus = std::move(opus), ends, first_sample] {
      voice_.say(opus, ends, first_sample);
      link_.wake();
    });
  }
  std::optional<HeardPacket> next_voice(std::chrono::milliseconds timeout) {
    return heard_.next(timeout);
  }

  void on_welcome(const wire::pb::Welcome& welcome) override {
    voice_.joined();
    state_.welcome(welcome);
    offer_snapshot();
  }
  void on_control(const wire::pb::Control& message) override;
  void on_frame(net::MessageBuffer message) override;
  void on_audio(net::MessageBuffer message) override;
  net::FramedMessagePtr next_frame() override { return voice_.next(); }
  void on_clock(const ClockEstimate& estimate) override {
    state_.clock_is(estimate);
    voice_.clock_is(estimate);
  }
  void on_down(const Error& reason, bool final) override;

 private:
  void offer_snapshot();
  void on_undecodable(std::span<const std::uint8_t> frame);
  void ask_for_key(SensorId sensor);
  void warn(const std::string& sentence) const {
    if (options_.log) options_.log(LogLevel::kWarning, sentence);
  }

  SubscriberOptions options_;
  HeardVoices heard_;

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::shared_ptr<const RoomSnapshot> newest_ = std::make_shared<const RoomSnapshot>();
  std::optional<Error> down_;
  std::optional<Error> failure_;

  // Used by the network thread only.
  SteadyClock clock_;
  RoomState state_{clock_};
  VoiceSender voice_;
  std::map<SensorId, HostTime> asked_for_key_;  // limited to the hub's rate of forwarding
  NetworkThread network_;
  HubLink link_;
};

void Subscriber::Link::on_control(const wire::pb::Control& message) {
  if (message.has_viewer_poses()) {
    state_.poses(message.viewer_poses());
    return offer_snapshot();
  }
  if (message.has_voices()) {
    state_.voices(message.voices());
    return offer_snapshot();
  }
  if (message.has_marks()) {
    state_.marks(message.marks());
    return offer_snapshot();
  }
  if (message.has_unseen_sensors()) {
    state_.unseen(message.unseen_sensors());
    return offer_snapshot();
  }
  if (message.has_set_end()) {
    if (state_.set_ended(SetId{message.set_end().set_id()})) offer_snapshot();
    return;
  }
  if (!message.has_roster()) return;
  if (auto status = state_.roster(message.roster()); !status) warn(status.error().message);
  offer_snapshot();
}

void Subscriber::Link::on_frame(net::MessageBuffer message) {
  const auto outcome = state_.frame(message.payload());
  if (!outcome) return warn(outcome.error().message);
  if (*outcome == RoomState::FrameOutcome::kNeedsKey) return on_undecodable(message.payload());
  if (*outcome == RoomState::FrameOutcome::kSetComplete) offer_snapshot();
}

void Subscriber::Link::on_audio(net::MessageBuffer message) {
  const auto header = wire::parse_audio(message.payload());
  if (!header || header->codec != wire::kAudioCodecOpus) return;  // of a later version
  const auto opus =
      std::as_const(message).payload().subspan(header->header_length, header->payload_length);
  heard_.push({header->speaker,
               header->seq,
               header->ends,
               header->capture_time,
               {opus.begin(), opus.end()}});
}

void Subscriber::Link::on_undecodable(std::span<const std::uint8_t> frame) {
  const auto header = wire::parse_frame(frame);
  if (!header) return;
  ask_for_key(header->sensor);
  // The set ends here all the same: the frames of the other sensors are to be seen.
  if (header->last) offer_snapshot();
}

void Subscriber::Link::ask_for_key(SensorId sensor) {
  const HostTime now = clock_.now();
  const auto asked = asked_for_key_.find(sensor);
  if (asked != asked_for_key_.end() && now - asked->second < wire::kKeyRequestInterval) return;
  asked_for_key_[sensor] = now;
  link_.send(key_request(sensor));
}

void Subscriber::Link::on_down(const Error& reason, bool final) {
  const bool is_news = snapshot()->connected;
  voice_.lost();
  if (final) heard_.end();
  state_.disconnected(reason.message);
  {
    std::lock_guard lock(mutex_);
    down_ = reason;
    if (final) failure_ = reason;
  }
  if (is_news && !final) warn(reason.message + "; trying again");
  offer_snapshot();
}

void Subscriber::Link::offer_snapshot() {
  auto snapshot = state_.snapshot();
  {
    std::lock_guard lock(mutex_);
    newest_ = std::move(snapshot);
  }
  changed_.notify_all();
}

Subscriber::Subscriber(std::unique_ptr<Link> link) : link_(std::move(link)) {}
Subscriber::~Subscriber() = default;

Result<std::unique_ptr<Subscriber>> Subscriber::open(SubscriberOptions options) {
  auto hubs = net::parse_hub_urls(options.hub_url);
  if (!hubs) return hubs.error();
  if (auto status = check_join(options.room, "viewer", options.name, options.credential); !status)
    return status.error();
  if (options.author_key.size() > wire::kMaxAuthorKeyBytes)
    return invalid_argument("the author's key is longer than " +
                            std::to_string(wire::kMaxAuthorKeyBytes) + " bytes");
  auto link = std::make_unique<Link>(std::move(*hubs), std::move(options));
  if (auto status = link->wait_for_welcome(); !status) return status.error();
  return std::unique_ptr<Subscriber>(new Subscriber(std::move(link)));
}

std::shared_ptr<const RoomSnapshot> Subscriber::snapshot() const {
  return link_->snapshot();
}

std::shared_ptr<const RoomSnapshot> Subscriber::wait_newer(
    std::uint64_t revision, std::chrono::milliseconds timeout) const {
  return link_->wait_newer(revision, timeout);
}

void Subscriber::send_pose(const PersonPose& pose) {
  wire::pb::Control control;
  *control.mutable_viewer_pose() = message_from_pose(pose);
  link_->send(std::move(control));
}

void Subscriber::send_mark(const wire::pb::Mark& mark) {
  wire::pb::Control control;
  *control.mutable_mark() = mark;
  link_->send(std::move(control));
}

void Subscriber::send_removal(std::span<const std::uint32_t> marks) {
  wire::pb::Control control;
  control.mutable_remove_marks()->mutable_ids()->Assign(marks.begin(), marks.end());
  link_->send(std::move(control));
}

void Subscriber::send_prior(SensorId sensor, const RigidTransform& world_from_depth) {
  wire::pb::Control control;
  control.mutable_nudge()->set_sensor_id(sensor.value);
  wire::write_transform(world_from_depth, *control.mutable_nudge()->mutable_world_from_depth());
  link_->send(std::move(control));
}

void Subscriber::ask_for_key(SensorId sensor) {
  link_->send(key_request(sensor));
}

void Subscriber::say(std::vector<std::uint8_t> opus, bool ends, HostTime first_sample) {
  link_->say(std::move(opus), ends, first_sample);
}

std::optional<HeardPacket> Subscriber::next_voice(std::chrono::milliseconds timeout) {
  return link_->next_voice(timeout);
}

void Subscriber::send_stats(const ShownStats& stats) {
  wire::pb::Control control;
  control.mutable_viewer_stats()->set_last_set_id(stats.newest_set.value);
  control.mutable_viewer_stats()->set_shown_fps(static_cast<float>(stats.fps));
  control.mutable_viewer_stats()->set_latency_ms(static_cast<float>(stats.latency_ms));
  link_->send(std::move(control));
}

std::optional<Error> Subscriber::failure() const {
  return link_->failure();
}

}  // namespace roomcast::client
