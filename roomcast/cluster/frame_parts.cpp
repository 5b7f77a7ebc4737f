// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cluster/frame_parts.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace roomcast::cluster {
namespace {

constexpr std::uint32_t kContinues = 1, kGoesOn = 2;
constexpr std::size_t kLengthBytes = 4;
/// Of messages that belong together.
constexpr std::size_t kMaxBegunBytes = 2 * wire::kMaxFrameBytes;

void store_u32(std::uint32_t number, std::span<std::uint8_t, 4> out) {
  for (std::size_t i = 0; i < 4; ++i) out[i] = static_cast<std::uint8_t>(number >> 8 * i);
}

void append_u32(std::uint32_t number, std::vector<std::uint8_t>& out) {
  out.resize(out.size() + 4);
  store_u32(number, std::span(out).last<4>());
}

std::uint32_t u32_at(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8 |
         static_cast<std::uint32_t>(bytes[2]) << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

}  // namespace

void FramePacker::add(std::span<const std::uint8_t> frame) {
  if (bytes_.empty()) bytes_.reserve(usual_bytes_);
  bytes_.resize(std::max(bytes_.size(), kPartHeaderBytes));
  append_u32(static_cast<std::uint32_t>(frame.size()), bytes_);
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
  if (all.size() <= max_bytes_) {  // as it is: a copy of a whole set costs more than all else here
    write_head(all, false, false);
    messages.push_back(std::move(all));
    return messages;
  }
  const auto frames = std::span(all).subspan(kPartHeaderBytes);
  const std::size_t room_for = max_bytes_ - kPartHeaderBytes;
  for (std::size_t from = 0; from < frames.size(); from += room_for) {
    const auto part = frames.subspan(from, std::min(room_for, frames.size() - from));
    Message& message = messages.emplace_back(kPartHeaderBytes);
    message.insert(message.end(), part.begin(), part.end());
    write_head(message, from > 0, from + part.size() < frames.size());
  }
  return messages;
}

void FramePacker::write_head(Message& message, bool continues, bool goes_on) {
  store_u32(next_number_++, std::span(message).first<4>());
  store_u32((continues ? kContinues : 0) | (goes_on ? kGoesOn : 0),
            std::span(message).subspan<4, 4>());
}

void FrameUnpacker::take(std::span<const std::uint8_t> message, const TakeFrame& take_frame) {
  if (message.size() < kPartHeaderBytes) return;
  const std::uint32_t number = u32_at(message), flags = u32_at(message.subspan(4));
  const auto bytes = message.subspan(kPartHeaderBytes);
  const bool continues = (flags & kContinues) != 0, goes_on = (flags & kGoesOn) != 0;
  const bool follows = continues && number == next_number_ && !begun_.empty();
  next_number_ = number + 1;
  if (!follows) begun_.clear();
  if (continues && !follows) return;
  if (!continues && !goes_on) return unpack(bytes, take_frame);
  if (begun_.size() + bytes.size() > kMaxBegunBytes) return begun_.clear();
  begun_.insert(begun_.end(), bytes.begin(), bytes.end());
  if (goes_on) return;
  unpack(begun_, take_frame);
  begun_.clear();
}

void FrameUnpacker::unpack(std::span<const std::uint8_t> bytes, const TakeFrame& take_frame) const {
  while (bytes.size() >= kLengthBytes) {
    const std::size_t length = u32_at(bytes);
    bytes = bytes.subspan(kLengthBytes);
    if (length > bytes.size()) return;
    take_frame(net::MessageBuffer(bytes.first(length)));
    bytes = bytes.subspan(length);
  }
}

}  // namespace roomcast::cluster
