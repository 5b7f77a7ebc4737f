// SPDX-License-Identifier: Apache-2.0
// Framing of frames between hubs. Several frames share a message, because a broker and a hub have
// costs per message that they do not have per byte; frames longer than a message are split into
// parts. Pure.
//
// Format of a message: number (u32, counts the messages of this stream), flags (u32, bit 0:
// continues the previous message, bit 1: continued in the next one), bytes. The bytes of one
// message, or of several joined, are frames, each preceded by its length (u32). All little-endian.
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

  /// Adds a frame accepted by wire::parse_frame.
  void add(std::span<const std::uint8_t> frame);
  /// Marks the newest frame as the last one of its set.
  void close_set();
  [[nodiscard]] std::size_t frame_count() const { return count_; }
  [[nodiscard]] std::size_t byte_count() const { return bytes_.size(); }  // approximate
  /// The messages with the added frames, in sending order.
  [[nodiscard]] std::vector<Message> take();

 private:
  void write_header(Message& message, bool continues, bool is_continued);

  const std::size_t max_bytes_;
  std::uint32_t next_number_ = 0;
  Message bytes_;                // space for a message's header, then frames
  std::size_t usual_bytes_ = 0;  // length of the previous one
  std::size_t count_ = 0;
  std::size_t newest_at_ = 0;  // in bytes_
};

class FrameUnpacker {
 public:
  using TakeFrame = std::function<void(net::MessageBuffer frame)>;

  /// Passes complete frames to `take_frame`. Ignores malformed messages and frames with a missing
  /// part.
  void take(std::span<const std::uint8_t> message, const TakeFrame& take_frame);
  /// Bytes of incomplete frames.
  [[nodiscard]] std::size_t partial_bytes() const { return partial_.size(); }

 private:
  void unpack(std::span<const std::uint8_t> bytes, const TakeFrame& take_frame) const;

  std::uint32_t next_number_ = 0;
  std::vector<std::uint8_t> partial_;  // of messages that are continued
};

}  // namespace roomcast::hub::federation
