// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/outgoing_frames.h"

#include <algorithm>
#include <utility>

#include "roomcast/core/assert.h"

namespace roomcast::net {

void OutgoingFrames::push(SealedMessagePtr frame) {
  unwritten_bytes_ += frame->wire_bytes().size();
  frames_.push_back(std::move(frame));
}

const std::vector<boost::asio::const_buffer>& OutgoingFrames::gather() {
  buffers_.clear();
  const std::size_t count = std::min(frames_.size(), kMaxGather);
  for (std::size_t i = 0; i < count; ++i) {
    const auto bytes = frames_[i]->wire_bytes().subspan(i == 0 ? front_written_ : 0);
    buffers_.emplace_back(bytes.data(), bytes.size());
  }
  return buffers_;
}

void OutgoingFrames::wrote(std::size_t bytes) {
  ROOMCAST_ASSERT(bytes <= unwritten_bytes_);
  unwritten_bytes_ -= bytes;
  front_written_ += bytes;
  while (!frames_.empty() && front_written_ >= frames_.front()->wire_bytes().size()) {
    front_written_ -= frames_.front()->wire_bytes().size();
    frames_.pop_front();
  }
}

void OutgoingFrames::clear() {
  frames_.clear();
  front_written_ = 0;
  unwritten_bytes_ = 0;
}

}  // namespace roomcast::net
