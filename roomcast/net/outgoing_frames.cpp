// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/outgoing_frames.h"

#include <algorithm>
#include <utility>

#include "roomcast/core/assert.h"

namespace roomcast::net {

void OutgoingFrames::push(FramedMessagePtr frame) {
  unwritten_bytes_ += frame->wire_bytes().size();
  frames_.push_back(std::move(frame));
}

OutgoingFrames::Buffers OutgoingFrames::gather() const {
  Buffers buffers;
  const std::size_t count = std::min(frames_.size(), kMaxGather);
  for (std::size_t i = 0; i < count; ++i) {
    const auto bytes = frames_[i]->wire_bytes().subspan(i == 0 ? front_written_ : 0);
    buffers.emplace_back(bytes.data(), bytes.size());
  }
  return buffers;
}

void OutgoingFrames::wrote(std::size_t bytes) {
  ROOMCAST_ASSERT(bytes <= unwritten_bytes_);
  unwritten_bytes_ -= bytes;
  front_written_ += bytes;
  auto front = frames_.begin();
  for (; front != frames_.end() && front_written_ >= (*front)->wire_bytes().size(); ++front) {
    front_written_ -= (*front)->wire_bytes().size();
  }
  frames_.erase(frames_.begin(), front);
}

void OutgoingFrames::clear() {
  frames_.clear();
  front_written_ = 0;
  unwritten_bytes_ = 0;
}

}  // namespace roomcast::net
