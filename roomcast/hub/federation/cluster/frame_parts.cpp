// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/frame_parts.h"

#include <algorithm>
#include <utility>

#include "roomcast/core/little_endian.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub::federation {
namespace {

constexpr std::uint32_t kContinues = 1, kIsContinued = 2;
constexpr std::size_t kLengthBytes = 4;
/// Maximum bytes kept for one sequence of parts.
constexpr std::size_t kMaxPartialBytes = 2 * wire::kMaxFrameBytes;

}  // namespace

void FramePacker::add(std::span<const std::uint8_t> frame) {
  if (bytes_.empty()) bytes_.reserve(usual_bytes_);
  bytes_.resize(std::max(bytes_.size(), kPartHeaderBytes));
  bytes_.resize(bytes_.size() + kLengthBytes);
  write_u32(&bytes_[bytes_.size() - kLengthBytes], static_cast<std::uint32_t>(frame.size()));
  newest_at_ = bytes_.size();
  bytes_.insert(bytes_.end(), frame.begin(), frame.end());
  ++count_;
}

void FramePacker::close_set() {
  if (count_ > 0) wire::stamp_frame_set(std::span(bytes_).subspan(newest_at_), SetId{0}, true);
}

std::vector<FramePacker::Message> FramePacker::take() {
  std::vector<Message> messages;
  usual_bytes_ = bytes_.size();
  count_ = 0;
  Message all = std::exchange(bytes_, {});
  if (all.empty()) return messages;
  if (all.size() <= max_bytes_) {  // sent without copying: copying a whole set would cost more than
                                   // the rest of this function
    write_header(all, false, false);
    messages.push_back(std::move(all));
    return messages;
  }
  const auto frames = std::span(all).subspan(kPartHeaderBytes);
  const std::size_t room_for = max_bytes_ - kPartHeaderBytes;
  for (std::size_t from = 0; from < frames.size(); from += room_for) {
    const auto part = frames.subspan(from, std::min(room_for, frames.size() - from));
    Message& message = messages.emplace_back(kPartHeaderBytes);
    message.insert(message.end(), part.begin(), part.end());
    write_header(message, from > 0, from + part.size() < frames.size());
  }
  return messages;
}

void FramePacker::write_header(Message& message, bool continues, bool is_continued) {
  write_u32(&message[0], next_number_++);
  write_u32(&message[4], (continues ? kContinues : 0) | (is_continued ? kIsContinued : 0));
}

void FrameUnpacker::take(std::span<const std::uint8_t> message, const TakeFrame& take_frame) {
  if (message.size() < kPartHeaderBytes) return;
  const std::uint32_t number = read_u32(&message[0]), flags = read_u32(&message[4]);
  const auto bytes = message.subspan(kPartHeaderBytes);
  const bool continues = (flags & kContinues) != 0, is_continued = (flags & kIsContinued) != 0;
  const bool follows = continues && number == next_number_ && !partial_.empty();
  next_number_ = number + 1;
  if (!follows) partial_.clear();
  if (continues && !follows) return;
  if (!continues && !is_continued) return unpack(bytes, take_frame);
  if (partial_.size() + bytes.size() > kMaxPartialBytes) return partial_.clear();
  partial_.insert(partial_.end(), bytes.begin(), bytes.end());
  if (is_continued) return;
  unpack(partial_, take_frame);
  partial_.clear();
}

void FrameUnpacker::unpack(std::span<const std::uint8_t> bytes, const TakeFrame& take_frame) const {
  while (bytes.size() >= kLengthBytes) {
    const std::size_t length = read_u32(bytes.data());
    bytes = bytes.subspan(kLengthBytes);
    if (length > bytes.size()) return;
    take_frame(net::MessageBuffer(bytes.first(length)));
    bytes = bytes.subspan(length);
  }
}

}  // namespace roomcast::hub::federation
