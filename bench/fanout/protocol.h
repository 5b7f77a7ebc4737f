// SPDX-License-Identifier: Apache-2.0
// What a server under test speaks, seen from its clients: the bytes that subscribe and publish, and
// where in the bytes that come back a message is. Every message is one roomcast frame of the same
// size, whatever carries it, so that its number can be read.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"

namespace roomcast::bench {

/// Finds messages in what one viewer receives. Keeps no payload.
class MessageCounter {
 public:
  virtual ~MessageCounter() = default;
  /// Appends the number of every message that has come to its end. False: these bytes are not what
  /// was expected, the connection is of no use.
  [[nodiscard]] virtual bool take(std::span<const std::uint8_t> bytes,
                                  std::vector<std::uint32_t>& numbers) = 0;
};

class Protocol {
 public:
  virtual ~Protocol() = default;
  [[nodiscard]] virtual std::string viewer_greeting() const = 0;
  /// Whether a server says something to a viewer before it has a frame.
  [[nodiscard]] virtual bool answers_greetings() const { return true; }
  /// `index` tells several publishers apart.
  [[nodiscard]] virtual std::string publisher_greeting(int index) const = 0;
  [[nodiscard]] virtual std::unique_ptr<MessageCounter> make_counter() const = 0;
  /// Appends what a publisher says to send `frame`.
  virtual void publish(std::span<const std::uint8_t> frame, std::string& out) const = 0;
};

/// `frame_bytes`: of every message. `fps`: the rate that sensors announce.
[[nodiscard]] std::unique_ptr<Protocol> raw_protocol(std::size_t frame_bytes);
[[nodiscard]] std::unique_ptr<Protocol> roomcast_protocol(double fps);
[[nodiscard]] std::unique_ptr<Protocol> nats_protocol();
[[nodiscard]] std::unique_ptr<Protocol> redis_protocol();
[[nodiscard]] std::unique_ptr<Protocol> mqtt_protocol();

/// What a viewer says who shows this token.
[[nodiscard]] std::string roomcast_greeting(const std::string& token);

/// A roomcast frame message, a key frame. Publishers count from 0; so do a hub's sensor ids.
[[nodiscard]] std::vector<std::uint8_t> make_frame(std::size_t bytes);
void set_number(std::span<std::uint8_t> frame, int sensor, std::uint32_t number,
                RoomTime capture_time);
inline constexpr std::size_t kNumberOffset = 12;  // of `seq` in the frame header

}  // namespace roomcast::bench
