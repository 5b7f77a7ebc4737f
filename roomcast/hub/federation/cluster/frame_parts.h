// SPDX-License-Identifier: Apache-2.0
// Frames on their way between hubs: several share a message, since a broker and a hub do per
// message what they do not per byte, and one that is longer than a message may be goes in parts.
// Pure.
//
// A message is a number (u32, of this stream; grows by one), flags (u32, bit 0: it goes on where
// the last one ended, bit 1: it goes on in the next one), and bytes. These bytes, of one or more
// messages, are frames, each behind its length (u32). All little-endian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "roomcast/net/message_buffer.h"

namespace roomcast::hub::federation {

inline constexpr std::size_t kPartHeaderBytes = 8;

class FramePacker {
 public:
  using Message = std::vector<std::uint8_t>;

  /// No message is longer than `max_message_bytes`.
  explicit FramePacker(std::size_t max_message_bytes) : max_bytes_(max_message_bytes) {}

  /// A frame that wire::parse_frame has accepted.
  void add(std::span<const std::uint8_t> frame);
  /// The newest frame is the last one of its set: marks it as that.
  void close_set();
  [[nodiscard]] std::size_t frame_count() const { return count_; }
  [[nodiscard]] std::size_t byte_count() const { return bytes_.size(); }  // about
  /// What was added, in the order in which it is to be sent.
  [[nodiscard]] std::vector<Message> take();

 private:
  void write_head(Message& message, bool continues, bool goes_on);

  const std::size_t max_bytes_;
  std::uint32_t next_number_ = 0;
  Message bytes_;                // room for a message's head, then frames
  std::size_t usual_bytes_ = 0;  // as long as the last one was
  std::size_t count_ = 0;
  std::size_t newest_at_ = 0;  // in bytes_
};

class FrameUnpacker {
 public:
  using TakeFrame = std::function<void(net::MessageBuffer frame)>;

  /// What is no such message is left out, and so is a frame of which a part is missing.
  void take(std::span<const std::uint8_t> message, const TakeFrame& take_frame);
  /// Of messages that wait for what belongs to them.
  [[nodiscard]] std::size_t begun_bytes() const { return begun_.size(); }

 private:
  void unpack(std::span<const std::uint8_t> bytes, const TakeFrame& take_frame) const;

  std::uint32_t next_number_ = 0;
  std::vector<std::uint8_t> begun_;  // of messages that go on
};

}  // namespace roomcast::hub::federation
