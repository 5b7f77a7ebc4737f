// SPDX-License-Identifier: Apache-2.0
// MessageBuffer: the bytes of one message, with headroom in front so that a WebSocket header can be
// added without moving the payload. Filled by the reader or by an encoder; then read, changed in
// place, or framed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace roomcast::net {

class MessageBuffer {
 public:
  /// The longest WebSocket header: 2 bytes, 8 of length, 4 of mask.
  static constexpr std::size_t kHeadroom = 14;

  /// Empty; allocates nothing.
  MessageBuffer() = default;
  /// A copy of `payload`.
  explicit MessageBuffer(std::span<const std::uint8_t> payload) { append(payload); }

  [[nodiscard]] std::span<std::uint8_t> payload() {
    return std::span(storage_).subspan(storage_.empty() ? 0 : kHeadroom);
  }
  [[nodiscard]] std::span<const std::uint8_t> payload() const {
    return std::span(storage_).subspan(storage_.empty() ? 0 : kHeadroom);
  }
  [[nodiscard]] std::size_t size() const { return payload().size(); }
  [[nodiscard]] bool empty() const { return payload().empty(); }

  void append(std::span<const std::uint8_t> bytes) {
    if (storage_.empty()) reserve(bytes.size());
    storage_.insert(storage_.end(), bytes.begin(), bytes.end());
  }

  /// For encoders that append to a vector: kHeadroom bytes that must be kept, then the payload so
  /// far.
  [[nodiscard]] std::vector<std::uint8_t>& appendable() {
    if (storage_.empty()) storage_.resize(kHeadroom);
    return storage_;
  }

  /// Reserves memory for a payload of this size.
  void reserve(std::size_t payload_size) {
    storage_.reserve(kHeadroom + payload_size);
    if (storage_.empty()) storage_.resize(kHeadroom);
  }

  /// The memory including the headroom; empty if nothing was ever added. Leaves the buffer empty.
  [[nodiscard]] std::vector<std::uint8_t> release() && { return std::exchange(storage_, {}); }

 private:
  std::vector<std::uint8_t> storage_;  // kHeadroom bytes, then the payload; or empty
};

}  // namespace roomcast::net
