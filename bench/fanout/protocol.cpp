// SPDX-License-Identifier: Apache-2.0
#include "bench/fanout/protocol.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "bench/fanout/unit_counter.h"
#include "bench/sensor_fixture.h"
#include "roomcast/net/framed_message.h"
#include "roomcast/net/message_buffer.h"
#include "roomcast/wire/control.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::bench {

namespace {

constexpr net::MaskKey kMask = {0x1B, 0x2C, 0x3D, 0x4E};
constexpr std::string_view kTopic = "f";

std::string_view text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Returns the line before "\r\n", if there is one.
std::optional<std::string_view> line_of(std::string_view front) {
  const auto end = front.find("\r\n");
  if (end == std::string_view::npos) return std::nullopt;
  return front.substr(0, end);
}

std::size_t number_in(std::string_view digits) {
  std::size_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

// ---- raw: one letter for the client's role, then frames of one size

class RawCounter final : public UnitCounter {
 public:
  explicit RawCounter(std::size_t frame_bytes) : frame_bytes_(frame_bytes) {}

 private:
  std::optional<Unit> parse(std::string_view front) override {
    if (front.empty()) return std::nullopt;
    return Unit{0, frame_bytes_, true};
  }
  std::size_t frame_bytes_;
};

class RawProtocol final : public Protocol {
 public:
  explicit RawProtocol(std::size_t frame_bytes) : frame_bytes_(frame_bytes) {}
  std::string viewer_greeting() const override { return "V"; }
  bool answers_greetings() const override { return false; }
  std::string publisher_greeting(int) const override { return "P"; }
  std::unique_ptr<MessageCounter> make_counter() const override {
    return std::make_unique<RawCounter>(frame_bytes_);
  }
  void publish(std::span<const std::uint8_t> frame, std::string& out) const override {
    out += text(frame);
  }

 private:
  std::size_t frame_bytes_;
};

// ---- roomcast.v1: docs/spec/wire.md

class RoomcastCounter final : public UnitCounter {
  std::optional<Unit> parse(std::string_view front) override {
    return upgraded_ ? parse_frame(front) : parse_answer(front);
  }

  std::optional<Unit> parse_answer(std::string_view front) {
    const auto end = front.find("\r\n\r\n");
    if (end == std::string_view::npos) return std::nullopt;
    broken = !front.starts_with("HTTP/1.1 101");
    upgraded_ = true;
    return Unit{end + 4, 0, false};
  }

  std::optional<Unit> parse_frame(std::string_view front) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(front[i]); };
    if (front.size() < 2) return std::nullopt;
    const std::size_t length_bytes = byte(1) == 126 ? 2 : byte(1) == 127 ? 8 : 0;
    std::size_t header = 2 + length_bytes;
    if (front.size() < header) return std::nullopt;
    std::size_t length = length_bytes == 0 ? byte(1) : 0;
    for (std::size_t i = 2; i < header; ++i) length = length << 8 | byte(i);
    const auto opcode = static_cast<net::Opcode>(byte(0) & 0x0F);
    const bool last_piece = (byte(0) & 0x80) != 0;
    broken = opcode == net::Opcode::kClose;
    if (opcode == net::Opcode::kContinuation) {
      return Unit{header, length, is_frame_ && last_piece, false, kNumberAfterPreamble};
    }
    if (opcode != net::Opcode::kBinary || length < wire::kPreambleBytes) {
      return Unit{header, length, false};
    }
    header += wire::kPreambleBytes;
    if (front.size() < header) return std::nullopt;
    is_frame_ = byte(header - 1) == static_cast<std::uint8_t>(wire::MessageType::kFrame);
    return Unit{header, length - wire::kPreambleBytes, is_frame_ && last_piece, true,
                kNumberAfterPreamble};
  }

  static constexpr std::size_t kNumberAfterPreamble = kNumberOffset - wire::kPreambleBytes;
  bool upgraded_ = false;
  bool is_frame_ = false;  // the current message is a frame
};

std::string upgrade() {
  return "GET /ws HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
         "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
         "Sec-WebSocket-Protocol: roomcast.v1\r\n\r\n";
}

std::string sealed(const wire::pb::Control& control) {
  std::vector<std::uint8_t> message;
  wire::encode_control(control, message);
  return std::string(text(
      net::frame_message(net::MessageBuffer(message), net::Opcode::kBinary, kMask)->wire_bytes()));
}

/// A wall 2 m in front of a sensor.
wire::pb::Control wall_ahead() {
  constexpr int kColumns = 12, kRows = 9, kWall_cm = 200;
  wire::pb::Control control;
  wire::pb::CoarseDepth& depth = *control.mutable_coarse_depth();
  depth.set_columns(kColumns);
  depth.set_rows(kRows);
  for (int i = 0; i < kColumns * kRows; ++i) {
    depth.add_near_cm(kWall_cm);
    depth.add_far_cm(kWall_cm);
  }
  return control;
}

class RoomcastProtocol final : public Protocol {
 public:
  explicit RoomcastProtocol(double fps) : fps_(fps) {}

  std::string viewer_greeting() const override {
    wire::pb::Control control;
    control.mutable_join()->mutable_viewer();
    return upgrade() + sealed(control);
  }

  std::string publisher_greeting(int index) const override {
    wire::pb::Control control;
    *control.mutable_join() = sensor_fixture(fmt::format("s{}", index), fps_);
    for (int i = 0; i < 16; ++i)
      control.mutable_join()->mutable_sensor()->add_world_from_depth(i % 5 == 0 ? 1 : 0);
    return upgrade() + sealed(control) + sealed(wall_ahead());
  }

  std::string head_of(int viewer, int step, bool tells_angle) const override {
    constexpr double kTurn_rad = 0.02, kHalfAngle_rad = 0.7;
    wire::pb::Control control;
    wire::pb::ViewerPose& pose = *control.mutable_viewer_pose();
    wire::pb::Pose& head = *pose.mutable_head();
    head.set_x(static_cast<float>(viewer % 10) * 0.1F);
    head.set_z(-3);  // looks along -z: the wall of the sensors is behind
    const double half_yaw_rad = 0.5 * kTurn_rad * (step % 20 - 10);
    head.set_qy(static_cast<float>(std::sin(half_yaw_rad)));
    head.set_qw(static_cast<float>(std::cos(half_yaw_rad)));
    if (tells_angle) pose.set_view_half_angle(static_cast<float>(kHalfAngle_rad));
    return sealed(control);
  }

  std::unique_ptr<MessageCounter> make_counter() const override {
    return std::make_unique<RoomcastCounter>();
  }

  void publish(std::span<const std::uint8_t> frame, std::string& out) const override {
    out += text(
        net::frame_message(net::MessageBuffer(frame), net::Opcode::kBinary, kMask)->wire_bytes());
  }

 private:
  double fps_;
};

// ---- NATS: https://docs.nats.io/reference/reference-protocols/nats-protocol

class NatsCounter final : public UnitCounter {
  std::optional<Unit> parse(std::string_view front) override {
    const auto line = line_of(front);
    if (!line) return std::nullopt;
    broken = line->starts_with("-ERR");
    if (!line->starts_with("MSG ")) return Unit{line->size() + 2, 0, false};
    return Unit{line->size() + 2, number_in(line->substr(line->rfind(' ') + 1)) + 2, true};
  }
};

class NatsProtocol final : public Protocol {
 public:
  std::string viewer_greeting() const override { return greeting() + "SUB f 1\r\n"; }
  std::string publisher_greeting(int) const override { return greeting(); }
  std::unique_ptr<MessageCounter> make_counter() const override {
    return std::make_unique<NatsCounter>();
  }
  void publish(std::span<const std::uint8_t> frame, std::string& out) const override {
    out += fmt::format("PUB {} {}\r\n{}\r\n", kTopic, frame.size(), text(frame));
  }

 private:
  static std::string greeting() {
    return "CONNECT {\"verbose\":false,\"pedantic\":false,\"echo\":false}\r\n";
  }
};

// ---- Redis: https://redis.io/docs/latest/develop/reference/protocol-spec/

class RedisCounter final : public UnitCounter {
  std::optional<Unit> parse(std::string_view front) override {
    const auto line = line_of(front);
    if (!line) return std::nullopt;
    broken = line->starts_with("-");
    if (!line->starts_with("$")) return Unit{line->size() + 2, 0, false};
    const std::size_t length = number_in(line->substr(1));
    constexpr std::size_t kLongestName = 16;  // "subscribe", "message" and the topic
    return Unit{line->size() + 2, length + 2, length > kLongestName};
  }
};

class RedisProtocol final : public Protocol {
 public:
  std::string viewer_greeting() const override { return "SUBSCRIBE f\r\n"; }
  std::string publisher_greeting(int) const override { return "PING\r\n"; }
  std::unique_ptr<MessageCounter> make_counter() const override {
    return std::make_unique<RedisCounter>();
  }
  void publish(std::span<const std::uint8_t> frame, std::string& out) const override {
    out += fmt::format("*3\r\n$7\r\nPUBLISH\r\n$1\r\n{}\r\n${}\r\n{}\r\n", kTopic, frame.size(),
                       text(frame));
  }
};

// ---- MQTT 3.1.1, QoS 0: OASIS standard, 2014

class MqttCounter final : public UnitCounter {
  std::optional<Unit> parse(std::string_view front) override {
    std::size_t remaining = 0, at = 1;
    for (int shift = 0;; shift += 7, ++at) {
      if (at >= front.size()) return std::nullopt;
      remaining |= static_cast<std::size_t>(front[at] & 0x7F) << shift;
      if ((front[at] & 0x80) == 0) break;
    }
    ++at;
    constexpr int kPublish = 3;
    if ((static_cast<std::uint8_t>(front[0]) >> 4) != kPublish) return Unit{at, remaining, false};
    constexpr std::size_t kTopicBytes = 2 + kTopic.size();
    if (front.size() < at + kTopicBytes) return std::nullopt;
    return Unit{at + kTopicBytes, remaining - kTopicBytes, true};
  }
};

class MqttProtocol final : public Protocol {
 public:
  std::string viewer_greeting() const override {
    using namespace std::string_literals;
    return connect() + "\x82\x06\x00\x01\x00\x01"s + std::string(kTopic) + "\x00"s;
  }
  std::string publisher_greeting(int) const override { return connect(); }
  std::unique_ptr<MessageCounter> make_counter() const override {
    return std::make_unique<MqttCounter>();
  }
  void publish(std::span<const std::uint8_t> frame, std::string& out) const override {
    out += '\x30';
    std::size_t remaining = 2 + kTopic.size() + frame.size();
    for (; remaining >= 128; remaining >>= 7) out += static_cast<char>(remaining % 128 | 128);
    out += static_cast<char>(remaining);
    out += std::string_view("\x00\x01", 2);
    out += kTopic;
    out += text(frame);
  }

 private:
  /// Clean session and an empty client id, which the broker replaces. No keep-alive.
  static std::string connect() {
    using namespace std::string_literals;
    return "\x10\x0C\x00\x04MQTT\x04\x02\x00\x00\x00\x00"s;
  }
};

}  // namespace

std::unique_ptr<Protocol> raw_protocol(std::size_t frame_bytes) {
  return std::make_unique<RawProtocol>(frame_bytes);
}
std::unique_ptr<Protocol> roomcast_protocol(double fps) {
  return std::make_unique<RoomcastProtocol>(fps);
}
std::unique_ptr<Protocol> nats_protocol() {
  return std::make_unique<NatsProtocol>();
}
std::unique_ptr<Protocol> redis_protocol() {
  return std::make_unique<RedisProtocol>();
}
std::unique_ptr<Protocol> mqtt_protocol() {
  return std::make_unique<MqttProtocol>();
}

std::string roomcast_greeting(const std::string& token) {
  wire::pb::Control control;
  control.mutable_join()->mutable_viewer();
  control.mutable_join()->set_token(token);
  return upgrade() + sealed(control);
}

std::vector<std::uint8_t> make_frame(std::size_t bytes) {
  std::vector<std::uint8_t> frame(bytes);
  for (std::size_t i = 0; i < bytes; ++i) frame[i] = static_cast<std::uint8_t>(i * 131 >> 3);
  set_number(frame, 0, 0, RoomTime());
  return frame;
}

void set_number(std::span<std::uint8_t> frame, int sensor, std::uint32_t number,
                RoomTime capture_time) {
  wire::FrameHeader header;
  header.key = true;
  header.sensor = SensorId{static_cast<std::uint16_t>(sensor)};
  header.seq = number;
  header.base_seq = number;
  header.capture_time = capture_time;
  header.payload_length = static_cast<std::uint32_t>(frame.size() - wire::kFrameHeaderBytes);
  wire::write_frame_header(header, frame.first<wire::kFrameHeaderBytes>());
}

}  // namespace roomcast::bench
