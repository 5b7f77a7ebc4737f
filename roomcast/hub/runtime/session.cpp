// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/session.h"

#include <utility>

#include "roomcast/hub/room/framed_control.h"
#include "roomcast/wire/control.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

pb::ErrorCode wire_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::kTooLarge:
      return pb::ERROR_TOO_LARGE;
    case ErrorCode::kUnsupported:
      return pb::ERROR_UNSUPPORTED;
    default:
      return pb::ERROR_MALFORMED;
  }
}

std::uint16_t close_code_of(pb::ErrorCode code) {
  switch (code) {
    case pb::ERROR_TOO_LARGE:
      return net::close_code::kTooLarge;
    case pb::ERROR_ROOM_FULL:
    case pb::ERROR_TOO_SLOW:
    case pb::ERROR_BUSY:
      return net::close_code::kTryAgainLater;
    case pb::ERROR_SHUTTING_DOWN:
      return net::close_code::kGoingAway;
    default:
      return net::close_code::kPolicy;
  }
}

/// Who records or relays gets the full renditions, for others who have better lines.
bool takes_small(const pb::Join& join) {
  return join.has_viewer() && !join.viewer().records() && !join.viewer().relays();
}

}  // namespace

const wire::SendingLimits& SessionLimits::of(Role role) const {
  switch (role) {
    case Role::kSensor:
      return sensor;
    case Role::kHub:
      return hub;
    case Role::kAligner:
      return aligner;
    case Role::kViewer:
    case Role::kPlayer:
    case Role::kModeler:
      break;
  }
  return viewer;
}

Session::Session(ConnectionPtr in_room, net::WebSocketConnection& connection, SessionEvents& hub,
                 const Clock& clock, const SessionLimits& limits)
    : in_room_(std::move(in_room)),
      connection_(connection),
      hub_(hub),
      clock_(clock),
      limits_(limits),
      audio_packets_(limits.speaker.messages_per_s, limits.speaker.messages_at_once),
      audio_bytes_(limits.speaker.bytes_per_s, limits.speaker.bytes_at_once) {
  limit(limits_.viewer);
}

void Session::limit(const wire::SendingLimits& limits) {
  messages_ = RateLimit(limits.messages_per_s, limits.messages_at_once);
  bytes_ = RateLimit(limits.bytes_per_s, limits.bytes_at_once);
}

void Session::on_message(net::MessageBuffer message) {
  const HostTime now = clock_.now();
  if (!messages_.take(1, now) || !bytes_.take(static_cast<double>(message.size()), now)) {
    return disconnect(pb::ERROR_TOO_FAST, "this connection exceeds the sending limits of its role");
  }
  const auto type = wire::message_type(message.payload());
  if (!type) return refuse(type.error());
  if (*type == wire::MessageType::kFrame) return take_frame(std::move(message));
  if (*type == wire::MessageType::kAudio) return take_audio(std::move(message));
  take_control(message.payload());
}

void Session::take_frame(net::MessageBuffer message) {
  if (!is_sensor_ || !is_accepted_) {
    return disconnect(pb::ERROR_UNEXPECTED, "only a sensor that has joined may send frames");
  }
  const auto header = wire::parse_frame(message.payload());
  if (!header) return refuse(header.error());
  hub_.on_frame(id(), *header, std::move(message));
}

void Session::take_audio(net::MessageBuffer message) {
  if (!is_accepted_) {
    return disconnect(pb::ERROR_UNEXPECTED, "only who has joined may send audio");
  }
  const auto header = wire::parse_audio(message.payload());
  if (!header) return refuse(header.error());
  const HostTime now = clock_.now();
  if (!audio_packets_.take(1, now) || !audio_bytes_.take(static_cast<double>(message.size()), now))
    return disconnect(pb::ERROR_TOO_FAST, "this is more audio than one microphone gives");
  hub_.on_audio(id(), *header, std::move(message));
}

void Session::take_control(std::span<const std::uint8_t> message) {
  const auto control =
      wire::decode_control(message, is_sensor_ ? wire::Sender::kSensor : wire::Sender::kClient);
  if (!control) return refuse(control.error());
  if (control->has_join() == has_joined_) {
    return disconnect(pb::ERROR_UNEXPECTED, has_joined_
                                                ? "this connection has joined already"
                                                : "the first message of a connection is Join");
  }
  if (control->has_clock_ping()) return answer_clock_ping(control->clock_ping());
  if (!control->has_join()) return hub_.on_control(id(), *control);
  has_joined_ = true;
  is_sensor_ = control->join().has_sensor();
  if (takes_small(control->join())) send_queue_.allow_small();
  hub_.on_join({in_room_, connection_.peer_address(), connection_.peer()}, control->join());
}

// Answers at once, on the shard's thread, because any delay of the answer makes the client's clock
// less certain.
void Session::answer_clock_ping(const wire::pb::ClockPing& ping) {
  pb::Control pong;
  pong.mutable_clock_pong()->set_client_ns(ping.client_ns());
  pong.mutable_clock_pong()->set_hub_ns(
      static_cast<std::uint64_t>(clock_.now().time_since_epoch().count()));
  if (!send_control(framed_control(pong))) {
    disconnect(pb::ERROR_TOO_SLOW, "too many control messages are unread");
  }
}

net::FramedMessagePtr Session::next_message() {
  auto message = send_queue_.next();
  if (auto sensors = send_queue_.take_key_needs(); !sensors.empty())
    hub_.on_key_needs(id(), sensors);
  if (const auto needs = send_queue_.take_small_needs()) hub_.on_small_needs(id(), *needs);
  return message;
}

void Session::on_closed(const net::CloseReason& reason) {
  hub_.on_left(id(), reason);
}

void Session::accept(Role role) {
  is_accepted_ = true;
  limit(limits_.of(role));
  connection_.settle();
  if (role == Role::kSensor) connection_.set_max_message_bytes(wire::kMaxFrameBytes);
}

bool Session::send_control(net::FramedMessagePtr message) {
  if (!send_queue_.push_control(std::move(message))) return false;
  connection_.wake();
  return true;
}

void Session::send_set(FrameSetPtr set) {
  send_queue_.push_set(std::move(set));
  connection_.wake();
}

void Session::send_audio(ViewerId speaker, net::FramedMessagePtr packet) {
  send_queue_.push_audio(speaker, std::move(packet));
  connection_.wake();
}

void Session::disconnect(pb::ErrorCode code, const std::string& sentence) {
  pb::Control control;
  control.mutable_error()->set_code(code);
  control.mutable_error()->set_sentence(sentence);
  connection_.close_after(framed_control(control), close_code_of(code), sentence);
}

void Session::refuse(const Error& error) {
  disconnect(wire_code(error.code), error.message);
}

}  // namespace roomcast::hub
