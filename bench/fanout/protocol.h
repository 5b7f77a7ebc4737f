// SPDX-License-Identifier: Apache-2.0
// Client side of a protocol under test: the bytes to subscribe and to publish, and a parser that
// finds messages in the received bytes. Every message is one roomcast frame of the same size, in
// any protocol, so that its number can be read.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"

namespace roomcast::bench {

/// Finds messages in the bytes that one viewer receives. Keeps no payload.
class MessageCounter {
 public:
  virtual ~MessageCounter() = default;
  /// Appends the number of every completed message. False: the bytes violate the protocol, and the
  /// connection cannot be used any more.
  [[nodiscard]] virtual bool take(std::span<const std::uint8_t> bytes,
                                  std::vector<std::uint32_t>& numbers) = 0;
};

class Protocol {
 public:
  virtual ~Protocol() = default;
  [[nodiscard]] virtual std::string viewer_greeting() const = 0;
  /// True if the server answers a viewer before it sends a frame.
  [[nodiscard]] virtual bool answers_greetings() const { return true; }
  /// `index` distinguishes several publishers.
  [[nodiscard]] virtual std::string publisher_greeting(int index) const = 0;
  [[nodiscard]] virtual std::unique_ptr<MessageCounter> make_counter() const = 0;
  /// The pose message number `step` of viewer number `viewer`; with `tells_angle`, it contains the
  /// angle of view. Empty in protocols without heads.
  [[nodiscard]] virtual std::string head_of(int /*viewer*/, int /*step*/,
                                            bool /*tells_angle*/) const {
    return {};
  }
  /// Appends the bytes that publish `frame`.
  virtual void publish(std::span<const std::uint8_t> frame, std::string& out) const = 0;
};

/// `frame_bytes`: size of every message. `fps`: the rate announced by sensors.
[[nodiscard]] std::unique_ptr<Protocol> raw_protocol(std::size_t frame_bytes);
[[nodiscard]] std::unique_ptr<Protocol> roomcast_protocol(double fps);
[[nodiscard]] std::unique_ptr<Protocol> nats_protocol();
[[nodiscard]] std::unique_ptr<Protocol> redis_protocol();
[[nodiscard]] std::unique_ptr<Protocol> mqtt_protocol();

/// The first bytes of a viewer that presents this token.
[[nodiscard]] std::string roomcast_greeting(const std::string& token);

/// A roomcast key frame message. Publishers count from 0, like a hub's sensor ids.
[[nodiscard]] std::vector<std::uint8_t> make_frame(std::size_t bytes);
void set_number(std::span<std::uint8_t> frame, int sensor, std::uint32_t number,
                RoomTime capture_time);
inline constexpr std::size_t kNumberOffset = 12;  // of `seq` in the frame header

}  // namespace roomcast::bench
