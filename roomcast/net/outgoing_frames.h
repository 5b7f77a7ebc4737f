// SPDX-License-Identifier: Apache-2.0
// OutgoingFrames: the frames that are being written to one socket, in order, the first perhaps
// partly. Pure book-keeping for gather writes; holds references, never copies.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include <boost/asio/buffer.hpp>

#include "roomcast/net/sealed_message.h"

namespace roomcast::net {

class OutgoingFrames {
 public:
  /// Frames of one gather write. More gains nothing: the kernel is called rarely enough.
  static constexpr std::size_t kMaxGather = 16;

  void push(SealedMessagePtr frame);

  [[nodiscard]] bool empty() const { return frames_.empty(); }
  [[nodiscard]] std::size_t count() const { return frames_.size(); }
  [[nodiscard]] std::size_t unwritten_bytes() const { return unwritten_bytes_; }

  /// What to write next: up to kMaxGather frames. Valid until push() or wrote().
  [[nodiscard]] const std::vector<boost::asio::const_buffer>& gather();

  /// The socket took this many bytes off the front.
  void wrote(std::size_t bytes);

  void clear();

 private:
  std::deque<SealedMessagePtr> frames_;
  std::size_t front_written_ = 0;
  std::size_t unwritten_bytes_ = 0;
  std::vector<boost::asio::const_buffer> buffers_;
};

}  // namespace roomcast::net
