// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/rosbag/record.h"

#include <algorithm>

#include "roomcast/core/little_endian.h"

namespace roomcast::recording::rosbag {
namespace {

constexpr std::size_t kMaxFields = 64;

/// Removes bytes that are preceded by their length.
std::optional<ByteView> take_sized(ByteView& bytes) {
  if (bytes.size() < 4) return std::nullopt;
  const std::uint32_t size = read_u32(bytes.data());
  if (size > bytes.size() - 4) return std::nullopt;
  const ByteView taken = bytes.subspan(4, size);
  bytes = bytes.subspan(4 + std::size_t{size});
  return taken;
}

}  // namespace

std::optional<Fields> Fields::read(ByteView header) {
  Fields fields;
  while (!header.empty()) {
    const auto field = take_sized(header);
    if (!field || fields.values_.size() == kMaxFields) return std::nullopt;
    const auto equals = std::ranges::find(*field, std::uint8_t{'='});
    if (equals == field->end() || equals == field->begin()) return std::nullopt;
    const auto name_bytes = static_cast<std::size_t>(equals - field->begin());
    const std::string_view name(reinterpret_cast<const char*>(field->data()), name_bytes);
    fields.values_.emplace(name, field->subspan(name_bytes + 1));
  }
  return fields;
}

std::optional<std::uint8_t> Fields::u8(std::string_view name) const {
  const auto found = values_.find(name);
  if (found == values_.end() || found->second.size() != 1) return std::nullopt;
  return found->second[0];
}

std::optional<std::uint32_t> Fields::u32(std::string_view name) const {
  const auto found = values_.find(name);
  if (found == values_.end() || found->second.size() != 4) return std::nullopt;
  return read_u32(found->second.data());
}

std::string Fields::text(std::string_view name) const {
  const auto found = values_.find(name);
  if (found == values_.end()) return {};
  return {found->second.begin(), found->second.end()};
}

std::optional<Record> take_record(ByteView& bytes) {
  ByteView rest = bytes;
  const auto header = take_sized(rest);
  const auto data = header ? take_sized(rest) : std::nullopt;
  if (!data) return std::nullopt;
  auto fields = Fields::read(*header);
  if (!fields) return std::nullopt;
  bytes = rest;
  return Record{*std::move(fields), *data};
}

nanoseconds ros_time(const std::uint8_t* bytes) {
  return std::chrono::seconds(read_u32(bytes)) + nanoseconds(read_u32(bytes + 4));
}

}  // namespace roomcast::recording::rosbag
