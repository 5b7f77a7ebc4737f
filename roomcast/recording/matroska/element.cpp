// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/matroska/element.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <span>

namespace roomcast::recording::matroska {
namespace {

constexpr std::size_t kMaxIdBytes = 4, kMaxSizeBytes = 8;
constexpr std::size_t kMaxNumberBytes = 8;

Error damaged_element() {
  return malformed("an element of it is damaged");
}

/// Big-endian bytes of an integer element.
Result<std::uint64_t> number_of(const ByteSource& source, const Element& element) {
  if (element.size > kMaxNumberBytes) return damaged_element();
  std::array<std::uint8_t, kMaxNumberBytes> bytes{};
  const std::span<std::uint8_t> used(bytes.data(), static_cast<std::size_t>(element.size));
  if (Status status = source.read(element.content, used); !status) return status.error();
  std::uint64_t value = 0;
  for (const std::uint8_t byte : used) value = value << 8U | byte;
  return value;
}

}  // namespace

std::optional<VariableInteger> read_variable_integer(std::span<const std::uint8_t> bytes) {
  if (bytes.empty() || bytes[0] == 0) return std::nullopt;
  const auto length = static_cast<std::size_t>(std::countl_zero(bytes[0])) + 1;
  if (length > bytes.size()) return std::nullopt;
  std::uint64_t value = bytes[0];
  for (std::size_t i = 1; i < length; ++i) value = value << 8U | bytes[i];
  const std::uint64_t mask = (std::uint64_t{1} << (7 * length)) - 1;
  return VariableInteger{value & mask, length, (value & mask) == mask};
}

std::optional<Element> element_at(const ByteSource& source, std::uint64_t offset,
                                  std::uint64_t parent_end) {
  parent_end = std::min(parent_end, source.size());
  if (offset >= parent_end) return std::nullopt;
  std::array<std::uint8_t, kMaxIdBytes + kMaxSizeBytes> bytes{};
  const std::size_t available =
      static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), parent_end - offset));
  const std::span<std::uint8_t> head(bytes.data(), available);
  if (!source.read(offset, head)) return std::nullopt;
  const auto id = read_variable_integer(head);
  if (!id || id->bytes > kMaxIdBytes) return std::nullopt;
  const auto size = read_variable_integer(head.subspan(id->bytes));
  if (!size) return std::nullopt;
  Element element;
  element.id = static_cast<std::uint32_t>(id->value | std::uint64_t{1} << (7 * id->bytes));
  element.content = offset + id->bytes + size->bytes;
  element.has_size = !size->is_unknown;
  element.size = size->is_unknown ? parent_end - element.content : size->value;
  return element;
}

Result<std::uint64_t> unsigned_of(const ByteSource& source, const Element& element) {
  return number_of(source, element);
}

Result<std::int64_t> signed_of(const ByteSource& source, const Element& element) {
  const auto value = number_of(source, element);
  if (!value) return value.error();
  if (element.size == 0) return std::int64_t{0};
  const auto unused = static_cast<unsigned>(64 - 8 * element.size);
  return static_cast<std::int64_t>(*value << unused) >> unused;
}

Result<std::vector<std::uint8_t>> bytes_of(const ByteSource& source, const Element& element,
                                           std::size_t limit_bytes) {
  if (element.size > limit_bytes)
    return Error{ErrorCode::kTooLarge, "an element of it is too large"};
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(element.size));
  if (Status status = source.read(element.content, bytes); !status) return status.error();
  return bytes;
}

Result<std::string> text_of(const ByteSource& source, const Element& element) {
  const auto bytes = bytes_of(source, element, kMaxStringBytes);
  if (!bytes) return bytes.error();
  return std::string(bytes->begin(), std::find(bytes->begin(), bytes->end(), 0));
}

}  // namespace roomcast::recording::matroska
