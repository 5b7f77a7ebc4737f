// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/recorder/room_player.h"

#include <chrono>
#include <optional>
#include <utility>

#include "roomcast/client/room/calibration_message.h"
#include "roomcast/core/interruptible_wait.h"
#include "roomcast/recording/room/recording_cursor.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/parse_message.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::recording {
namespace {

using namespace std::chrono_literals;
using recording::MessageKind;
using recording::RecordedMessage;
using recording::RecordingCursor;

constexpr auto kLookForTurn = 2ms;
constexpr auto kGiveUpTurn = 2s;  // while the hub is unreachable, messages due are skipped

Result<client::PublisherOptions> publisher_options(const wire::pb::SensorEntry& entry,
                                                   const RoomPlayerOptions& options) {
  auto calibration = client::calibration_from_message(entry.calibration());
  if (!calibration) return calibration.error();
  client::PublisherOptions publisher;
  publisher.hub_url = options.hub_url;
  publisher.room = options.room;
  publisher.credential = options.credential;
  publisher.name = entry.name();
  publisher.calibration = *calibration;
  publisher.fps = entry.fps() * options.speed;
  publisher.log = options.log;
  if (entry.placement() != wire::pb::PLACEMENT_UNPLACED) {
    auto pose = wire::read_transform(entry.world_from_depth());
    if (!pose) return pose.error();
    publisher.world_from_depth = *pose;
  }
  return publisher;
}

nanoseconds scaled(nanoseconds time, double by) {
  return nanoseconds(static_cast<std::int64_t>(static_cast<double>(time.count()) * by));
}

}  // namespace

Status RoomPlayerOptions::check() const {
  if (!(from_s >= 0 && from_s < 1e9))
    return Error{ErrorCode::kInvalidArgument, "the start must be 0 s or later"};
  if (!(speed >= 0.1 && speed <= 10))
    return Error{ErrorCode::kInvalidArgument, "the speed must be 0.1 to 10"};
  return {};
}

Result<std::unique_ptr<RoomPlayer>> RoomPlayer::open(const recording::RoomRecording& recording,
                                                     RoomPlayerOptions options) {
  if (auto status = options.check(); !status) return status.error();
  std::unique_ptr<RoomPlayer> player(new RoomPlayer(recording, std::move(options)));
  if (auto status = player->join(); !status) return status.error();
  player->send_bundles();
  return player;
}

Status RoomPlayer::join() {
  for (const auto& sensor : recording_.sensors()) {
    auto options = publisher_options(sensor.entry, options_);
    if (!options) return options.error();
    auto publisher = client::Publisher::open(std::move(*options));
    if (!publisher) return publisher.error();
    sensors_[sensor.frames_channel].publisher = std::move(*publisher);
  }
  return {};
}

/// Sends each sensor's recorded calibration bundle (its view while nothing moved), if there is one.
void RoomPlayer::send_bundles() {
  RecordingCursor cursor(recording_);
  RecordedMessage recorded;
  std::map<std::uint32_t, wire::pb::CalibrationBundle> bundles;
  for (auto more = cursor.next(recorded); !more || *more; more = cursor.next(recorded)) {
    if (!more || recorded.kind != MessageKind::kBundle) continue;
    wire::pb::CalibrationBundle bundle;
    const auto& data = recorded.message.data;
    if (wire::parse_message(data, bundle)) bundles[bundle.sensor_id()] = std::move(bundle);
  }
  for (const auto& sensor : recording_.sensors()) {
    const auto bundle = bundles.find(sensor.entry.id());
    if (bundle != bundles.end())
      sensors_[sensor.frames_channel].publisher->send_bundle(bundle->second);
  }
}

Status RoomPlayer::run(std::stop_token stop) {
  nanoseconds from = recording_.origin() + scaled(1s, options_.from_s);
  do {
    const auto ended = play_from(from, stop);
    if (!ended) return ended.error();
    if (!*ended) break;
    from = recording_.origin();
  } while (options_.loop);
  wait_until_sent(stop);
  return {};
}

Result<bool> RoomPlayer::play_from(nanoseconds from, const std::stop_token& stop) {
  RecordingCursor cursor(recording_, recording_.chunk_to_decode_from(from, recording_.sensors()));
  for (auto& [channel, sensor] : sensors_) sensor.chain.broke();
  std::optional<nanoseconds> first;
  const HostTime begin = SteadyClock().now();
  RecordedMessage recorded;
  for (;;) {
    const auto more = cursor.next(recorded);
    if (!more) {
      if (options_.log) options_.log(LogLevel::kWarning, more.error().message);
      continue;
    }
    if (!*more) return true;
    if (recorded.kind != MessageKind::kFrame) continue;
    const auto sensor = sensors_.find(recorded.message.channel);
    if (sensor == sensors_.end()) continue;
    const nanoseconds taken = recorded.message.publish_time;
    if (!first) first = taken;
    const HostTime due = begin + scaled(taken - *first, 1 / options_.speed);
    if (!wait_until(due, stop)) return false;
    position_s_ = std::chrono::duration<double>(taken - recording_.origin()).count();
    if (auto status = send(sensor->second, recorded.message, due, stop); !status)
      return status.error();
  }
}

Status RoomPlayer::send(Sensor& sensor, const recording::mcap::Message& message,
                        HostTime capture_time, const std::stop_token& stop) {
  const auto header = wire::parse_frame(message.data);
  if (!header || !sensor.chain.may_decode(*header)) return {};
  auto turn = sensor.publisher->next_turn();
  for (nanoseconds waited{}; !turn && waited < kGiveUpTurn; waited += kLookForTurn) {
    if (auto failure = sensor.publisher->failure()) return *failure;
    if (!wait_for(kLookForTurn, stop)) return {};
    turn = sensor.publisher->next_turn();
  }
  const bool starts_anew = turn && turn->session != sensor.session && !header->key;
  if (!turn || starts_anew) {
    sensor.chain.broke();
    return {};
  }
  sensor.session = turn->session;
  auto copy = client::Publisher::begin_frame();
  copy.append(message.data.subspan(header->header_length));
  if (!sensor.publisher->publish(*turn, {header->key, header->layer}, capture_time,
                                 std::move(copy))) {
    sensor.chain.broke();
    return {};
  }
  sensor.chain.decoded(*header);
  ++published_;
  return {};
}

/// Lets the last published messages go out before the sensors leave.
void RoomPlayer::wait_until_sent(const std::stop_token& stop) const {
  const auto sent = [this] {
    std::uint64_t frames = 0;
    for (const auto& [channel, sensor] : sensors_) frames += sensor.publisher->stats().frames_sent;
    return frames;
  };
  for (nanoseconds waited{}; sent() < published_ && waited < kGiveUpTurn; waited += kLookForTurn) {
    if (!wait_for(kLookForTurn, stop)) return;
  }
}

PlayProgress RoomPlayer::progress() const {
  return {position_s_, published_};
}

}  // namespace roomcast::recording
