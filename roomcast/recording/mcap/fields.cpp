// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mcap/fields.h"

namespace roomcast::recording::mcap {

std::uint64_t FieldReader::integer(std::size_t bytes) {
  const auto field = this->bytes(bytes);
  std::uint64_t value = 0;
  for (std::size_t i = field.size(); i-- > 0;) value = value << 8 | field[i];
  return value;
}

std::span<const std::uint8_t> FieldReader::bytes(std::uint64_t count) {
  if (!ok_ || count > rest_.size()) {
    ok_ = false;
    rest_ = {};
    return {};
  }
  const auto field = rest_.first(static_cast<std::size_t>(count));
  rest_ = rest_.subspan(field.size());
  return field;
}

std::string FieldReader::string() {
  const auto text = bytes(u32());
  return {text.begin(), text.end()};
}

StringMap FieldReader::string_map() {
  FieldReader entries(bytes(u32()));
  StringMap map;
  while (entries.ok() && !entries.rest().empty()) {
    std::string key = entries.string();
    map[std::move(key)] = entries.string();
  }
  ok_ = ok_ && entries.ok();
  return map;
}

std::map<ChannelId, std::uint64_t> FieldReader::channel_map() {
  FieldReader entries(bytes(u32()));
  std::map<ChannelId, std::uint64_t> map;
  while (entries.ok() && !entries.rest().empty()) {
    const ChannelId channel{entries.u16()};
    map[channel] = entries.u64();
  }
  ok_ = ok_ && entries.ok();
  return map;
}

void FieldWriter::string(std::string_view text) {
  u32(static_cast<std::uint32_t>(text.size()));
  out_.insert(out_.end(), text.begin(), text.end());
}

void FieldWriter::string_map(const StringMap& map) {
  std::uint32_t length = 0;
  for (const auto& [key, value] : map)
    length += static_cast<std::uint32_t>(8 + key.size() + value.size());
  u32(length);
  for (const auto& [key, value] : map) {
    string(key);
    string(value);
  }
}

void FieldWriter::channel_map(const std::map<ChannelId, std::uint64_t>& map) {
  u32(static_cast<std::uint32_t>(10 * map.size()));
  for (const auto& [channel, value] : map) {
    u16(channel.value);
    u64(value);
  }
}

}  // namespace roomcast::recording::mcap
