// SPDX-License-Identifier: Apache-2.0
// OutgoingFrames: the frames being written to one socket, in order; the front one may be partly
// written. Pure book-keeping for gather writes; keeps references, never copies.
#pragma once

#include <cstddef>

#include <boost/asio/buffer.hpp>
#include <boost/container/small_vector.hpp>
#include <boost/container/static_vector.hpp>

#include "roomcast/net/framed_message.h"

namespace roomcast::net {

class OutgoingFrames {
 public:
  /// Frames per gather write. More gains nothing: the kernel is called rarely enough.
  static constexpr std::size_t kMaxGather = 16;

  void push(FramedMessagePtr frame);

  [[nodiscard]] bool empty() const { return frames_.empty(); }
  [[nodiscard]] std::size_t count() const { return frames_.size(); }
  [[nodiscard]] std::size_t unwritten_bytes() const { return unwritten_bytes_; }

  /// The next up to kMaxGather frames to write. Their bytes are valid until wrote().
  using Buffers = boost::container::static_vector<boost::asio::const_buffer, kMaxGather>;
  [[nodiscard]] Buffers gather() const;

  /// The socket accepted this many bytes of the front.
  void wrote(std::size_t bytes);

  void clear();

 private:
  boost::container::small_vector<FramedMessagePtr, 4> frames_;
  std::size_t front_written_ = 0;
  std::size_t unwritten_bytes_ = 0;
};

}  // namespace roomcast::net
