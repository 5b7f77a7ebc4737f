// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/recorder/recorder.h"

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <utility>
#include <variant>

#include "roomcast/client/hub_link.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/client/room/viewer_rights.h"
#include "roomcast/client/stop_notice.h"
#include "roomcast/net/timer.h"
#include "roomcast/recording/recorder/bundle_link.h"
#include "roomcast/recording/recorder/unix_clock.h"
#include "roomcast/recording/room/room_recording_writer.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::recording {
namespace {

namespace pb = wire::pb;

/// Buffer until room time is known, which takes one round trip.
constexpr std::size_t kMaxHeldMessages = 256;

pb::Join join_message(const RecorderOptions& options) {
  pb::Join join;
  join.set_room(options.room);
  join.set_name("recorder");
  show(options.credential, join);
  join.mutable_viewer()->set_records(true);
  join.mutable_viewer()->set_hears(options.voices);
  return join;
}

}  // namespace

class Recorder::Link final : public client::HubLinkEvents {
 public:
  Link(std::vector<net::HubUrl> hubs, RecorderOptions options)
      : options_(std::move(options)),
        chunk_timer_(network_.io()),
        link_(network_.io(), hubs, join_message(options_), *this) {
    if (options_.bundles) {
      bundles_.emplace(network_.io(), std::move(hubs), options_.room, options_.credential,
                       [this](const pb::CalibrationBundle& bundle) { take(bundle); });
    }
    link_.start();
    network_.start();
  }
  ~Link() override { (void)finish(); }

  /// Waits until the file has been created or opening has failed.
  Status wait_for_file() {
    {
      const client::StopNotice notice(options_.stop, mutex_, changed_);
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] {
        return has_file_ || down_ || failure_ || options_.stop.stop_requested();
      });
      if (!has_file_ && !down_ && !failure_) {
        // The network thread may be creating the file just now.
        lock.unlock();
        if (auto ended = finish(); !ended) return ended;
      }
    }
    std::lock_guard lock(mutex_);
    if (failure_) return *failure_;
    if (has_file_) return {};
    return down_ ? *down_ : client::stopped_waiting();
  }

  Status finish() {
    if (std::exchange(finished_, true)) return {};
    network_.finish([this] {
      chunk_timer_.stop();
      bundles_.reset();
      link_.stop();
    });
    if (failure_) return *failure_;
    if (!writer_) return {};
    Status finished = writer_->finish();  // the network thread has ended
    count();
    return finished;
  }

  std::optional<Error> failure() const {
    std::lock_guard lock(mutex_);
    return failure_;
  }
  RecorderStats stats() const {
    std::lock_guard lock(mutex_);
    return stats_;
  }
  std::string room() const {
    std::lock_guard lock(mutex_);
    return room_;
  }

  void on_welcome(const pb::Welcome& welcome) override {
    const client::ViewerRights rights{.may_record = welcome.may_record(),
                                      .may_export = welcome.may_export()};
    if (auto may = client::check_may_record(rights); !may) return fail(may.error());
    clock_is_known_ = false;
    held_.clear();
    {
      std::lock_guard lock(mutex_);
      down_.reset();
    }
    if (!writer_) make_file(welcome.room());
    if (writer_ && !rights.may_export) check(writer_->forbid_export());
  }
  void on_control(const pb::Control& message) override {
    if (message.has_roster() || message.has_viewer_poses() || message.has_marks())
      take(Held(message));
  }
  void on_frame(net::MessageBuffer message) override { take(Held(std::move(message))); }
  void on_audio(net::MessageBuffer message) override {
    if (options_.voices) take(Held(std::move(message)));
  }
  net::FramedMessagePtr next_frame() override { return nullptr; }
  void on_clock(const client::ClockEstimate& estimate) override;
  void on_down(const Error& reason, bool final) override;

 private:
  using Message = std::variant<pb::Control, net::MessageBuffer>;
  struct Held {
    explicit Held(Message what) : message(std::move(what)) {}
    Message message;
    HostTime came = SteadyClock().now();
  };

  void make_file(const std::string& room);
  void take(Held held);
  void take(const pb::CalibrationBundle& bundle);
  Status write(const Held& held);
  Status write(const pb::Control& message, nanoseconds log_time);
  void count();
  void look_after_chunk();
  /// Stops recording after an error.
  void check(const Status& status);
  void fail(const Error& reason);

  const RecorderOptions options_;
  const UnixClock unix_clock_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool has_file_ = false;
  std::string room_;
  std::optional<Error> down_, failure_;
  RecorderStats stats_;

  // Used by the network thread only.
  std::optional<recording::RoomRecordingWriter> writer_;
  bool clock_is_known_ = false;  // in this connection
  bool roster_is_known_ = false;
  std::deque<Held> held_;                                        // until the clock is known
  std::map<std::uint32_t, pb::CalibrationBundle> held_bundles_;  // until the roster is known
  bool finished_ = false;
  client::NetworkThread network_;
  net::Timer chunk_timer_;
  client::HubLink link_;
  std::optional<BundleLink> bundles_;
};

void Recorder::Link::make_file(const std::string& room) {
  auto writer = recording::RoomRecordingWriter::create(options_.path, room, options_.by);
  if (!writer) return fail(writer.error());
  writer_.emplace(std::move(*writer));
  look_after_chunk();
  {
    std::lock_guard lock(mutex_);
    has_file_ = true;
    room_ = room;
  }
  changed_.notify_all();
}

void Recorder::Link::on_clock(const client::ClockEstimate& estimate) {
  if (clock_is_known_ || !writer_) return;
  clock_is_known_ = true;
  const HostTime now = SteadyClock().now();
  const recording::RoomClock clock{
      .unix_minus_room = unix_clock_.at(now) - estimate.room_time(now).time_since_epoch(),
      .error = estimate.error};
  check(writer_->add_clock(clock, unix_clock_.at(held_.empty() ? now : held_.front().came)));
  while (!held_.empty()) {
    check(write(held_.front()));
    held_.pop_front();
  }
}

void Recorder::Link::take(Held held) {
  if (clock_is_known_) return check(write(held));
  if (held_.size() < kMaxHeldMessages) held_.push_back(std::move(held));
}

void Recorder::Link::take(const pb::CalibrationBundle& bundle) {
  if (!roster_is_known_) {
    held_bundles_[bundle.sensor_id()] = bundle;
  } else if (writer_) {
    check(writer_->add_bundle(bundle, unix_clock_.now()));
  }
}

Status Recorder::Link::write(const Held& held) {
  if (!writer_) return {};
  const nanoseconds log_time = unix_clock_.at(held.came);
  if (const auto* control = std::get_if<pb::Control>(&held.message))
    return write(*control, log_time);
  const auto message = std::get<net::MessageBuffer>(held.message).payload();
  const bool is_voice = *wire::message_type(message) == wire::MessageType::kAudio;
  const Status status =
      is_voice ? writer_->add_voice(message, log_time) : writer_->add_frame(message, log_time);
  count();
  return status;
}

void Recorder::Link::count() {
  std::lock_guard lock(mutex_);
  stats_ = {writer_->frames(), writer_->frame_bytes(), writer_->bytes(), writer_->voice_packets()};
}

Status Recorder::Link::write(const pb::Control& message, nanoseconds log_time) {
  if (message.has_viewer_poses()) return writer_->add_poses(message.viewer_poses(), log_time);
  if (message.has_marks()) return writer_->add_marks(message.marks(), log_time);
  auto status = writer_->add_roster(message.roster(), log_time);
  roster_is_known_ = true;
  for (const auto& [sensor, bundle] : std::exchange(held_bundles_, {})) {
    if (status) status = writer_->add_bundle(bundle, log_time);
  }
  return status;
}

void Recorder::Link::look_after_chunk() {
  chunk_timer_.repeat(options_.look_after_chunk,
                      [this] { check(writer_->close_old_chunk(unix_clock_.now())); });
}

void Recorder::Link::check(const Status& status) {
  if (!status) fail(status.error());
}

void Recorder::Link::fail(const Error& reason) {
  if (writer_) {
    (void)writer_->finish();  // as far as the disk has space
    count();
  }
  writer_.reset();
  chunk_timer_.stop();
  {
    std::lock_guard lock(mutex_);
    if (!failure_) failure_ = reason;
  }
  changed_.notify_all();
  link_.stop();
}

void Recorder::Link::on_down(const Error& reason, bool final) {
  bool is_news = false;
  {
    std::lock_guard lock(mutex_);
    is_news = has_file_ && !down_;  // before that, open() reports the error
    down_ = reason;
    if (final && !failure_) failure_ = reason;
  }
  changed_.notify_all();
  if (is_news && !final && options_.log)
    options_.log(LogLevel::kWarning, reason.message + "; trying again");
}

Recorder::Recorder(std::unique_ptr<Link> link) : link_(std::move(link)) {}
Recorder::~Recorder() = default;

Result<std::unique_ptr<Recorder>> Recorder::open(RecorderOptions options) {
  auto hubs = net::parse_hub_urls(options.hub_url);
  if (!hubs) return hubs.error();
  if (auto status = client::check_join(options.room, "recorder", {}, options.credential); !status)
    return status.error();
  auto link = std::make_unique<Link>(std::move(*hubs), std::move(options));
  if (auto status = link->wait_for_file(); !status) return status.error();
  return std::unique_ptr<Recorder>(new Recorder(std::move(link)));
}

Status Recorder::finish() {
  return link_->finish();
}
std::optional<Error> Recorder::failure() const {
  return link_->failure();
}
RecorderStats Recorder::stats() const {
  return link_->stats();
}
std::string Recorder::room() const {
  return link_->room();
}

}  // namespace roomcast::recording
