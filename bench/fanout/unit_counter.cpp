// SPDX-License-Identifier: Apache-2.0
#include "bench/fanout/unit_counter.h"

#include <algorithm>

namespace roomcast::bench {

bool UnitCounter::take(std::span<const std::uint8_t> bytes, std::vector<std::uint32_t>& numbers) {
  while (!broken) {
    if (in_body_) {
      take_body(bytes, numbers);
      if (in_body_) return true;
    }
    if (!take_header(bytes)) return !broken;
  }
  return false;
}

/// False: the header is not complete yet.
bool UnitCounter::take_header(std::span<const std::uint8_t>& bytes) {
  const std::size_t before = front_.size();
  const std::size_t size = std::min(bytes.size(), kLongestHeader - before);
  front_.append(reinterpret_cast<const char*>(bytes.data()), size);
  const auto unit = parse(front_);
  if (!unit) {
    bytes = bytes.subspan(size);
    broken = broken || front_.size() >= kLongestHeader;
    return false;
  }
  bytes = bytes.subspan(unit->header_bytes - before);
  front_.clear();
  unit_ = *unit;
  body_taken_ = 0;
  in_body_ = true;
  return true;
}

void UnitCounter::take_body(std::span<const std::uint8_t>& bytes,
                            std::vector<std::uint32_t>& numbers) {
  const std::size_t size = std::min(bytes.size(), unit_.body_bytes - body_taken_);
  for (std::size_t i = 0; unit_.is_first_piece && i < size && body_taken_ + i < body_front_.size();
       ++i) {
    body_front_[body_taken_ + i] = bytes[i];
  }
  body_taken_ += size;
  bytes = bytes.subspan(size);
  if (body_taken_ < unit_.body_bytes) return;
  in_body_ = false;
  if (!unit_.is_message) return;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number |= static_cast<std::uint32_t>(body_front_[unit_.number_offset + i]) << (8 * i);
  }
  numbers.push_back(number);
}

}  // namespace roomcast::bench
