// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/ros/message_reader.h"

#include <bit>

namespace roomcast::recording::ros {
namespace {

constexpr std::size_t kCdrHeadBytes = 4;
constexpr std::uint8_t kCdrBig = 0, kCdrLittle = 1;

}  // namespace

MessageReader::MessageReader(std::span<const std::uint8_t> message, Serialisation serialisation)
    : all_(message), serialisation_(serialisation) {
  if (serialisation == Serialisation::kRos1) return;
  ok_ = message.size() >= kCdrHeadBytes && message[0] == 0 &&
        (message[1] == kCdrBig || message[1] == kCdrLittle);
  if (!ok_) return;
  big_endian_ = message[1] == kCdrBig;
  at_ = origin_ = kCdrHeadBytes;
}

bool MessageReader::need(std::uint64_t size) {
  ok_ = ok_ && size <= all_.size() - at_;
  return ok_;
}

void MessageReader::align(std::size_t size) {
  if (serialisation_ == Serialisation::kRos1 || !ok_) return;
  const std::size_t past = (at_ - origin_) % size;
  if (past != 0 && need(size - past)) at_ += size - past;
}

std::uint64_t MessageReader::integer(std::size_t size) {
  align(size);
  if (!need(size)) return 0;
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t shift = 8 * (big_endian_ ? size - 1 - i : i);
    value |= std::uint64_t{all_[at_ + i]} << shift;
  }
  at_ += size;
  return value;
}

double MessageReader::f64() {
  return std::bit_cast<double>(integer(8));
}

std::span<const std::uint8_t> MessageReader::bytes() {
  const std::uint32_t size = u32();
  if (!need(size)) return {};
  const auto taken = all_.subspan(at_, size);
  at_ += size;
  return taken;
}

std::string MessageReader::text() {
  const auto taken = bytes();
  std::string text(taken.begin(), taken.end());
  if (serialisation_ == Serialisation::kRos2 && !text.empty() && text.back() == '\0')
    text.pop_back();
  return text;
}

std::uint32_t MessageReader::count(std::size_t least_bytes) {
  const std::uint32_t count = u32();
  return need(std::uint64_t{count} * least_bytes) ? count : 0;
}

MessageReader::Header MessageReader::header() {
  if (serialisation_ == Serialisation::kRos1) (void)u32();  // sequence number
  Header header;
  const auto seconds = static_cast<std::int32_t>(u32());
  const std::uint32_t rest = u32();
  header.stamp = std::chrono::seconds(seconds) + nanoseconds(rest);
  header.frame_id = text();
  return header;
}

}  // namespace roomcast::recording::ros
