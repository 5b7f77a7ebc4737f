// SPDX-License-Identifier: Apache-2.0
// Elements of EBML (RFC 8794), the syntax of Matroska files: an ID, a size and a content, which may
// be further elements. Nothing is read outside the given bytes. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/bytes/byte_source.h"

namespace roomcast::recording::matroska {

struct Element {
  std::uint32_t id = 0;       // with its length marker, as in RFC 9559: 0x1A45DFA3
  std::uint64_t content = 0;  // offset of the content in the file
  std::uint64_t size = 0;     // of the content; up to the parent's end if unknown
  bool has_size = true;       // false: the writer did not know it, for instance of a live stream

  [[nodiscard]] std::uint64_t end() const { return content + size; }
};

/// The element that begins at `offset`, within a parent that ends at `parent_end`. Nothing if its
/// head is damaged or does not fit; its content may reach beyond the parent.
[[nodiscard]] std::optional<Element> element_at(const ByteSource& source, std::uint64_t offset,
                                                std::uint64_t parent_end);

inline constexpr std::size_t kMaxStringBytes = 64U << 10U;

/// Contents. kMalformed if they are longer than the type allows, or cannot be read.
[[nodiscard]] Result<std::uint64_t> unsigned_of(const ByteSource& source, const Element& element);
[[nodiscard]] Result<std::int64_t> signed_of(const ByteSource& source, const Element& element);
/// Without the zero bytes that may end it.
[[nodiscard]] Result<std::string> text_of(const ByteSource& source, const Element& element);
[[nodiscard]] Result<std::vector<std::uint8_t>> bytes_of(const ByteSource& source,
                                                         const Element& element,
                                                         std::size_t limit_bytes);

/// A variable-length integer at the start of `bytes` and its length in bytes; nothing if it does
/// not fit. Its length marker is removed.
struct VariableInteger {
  std::uint64_t value = 0;
  std::size_t bytes = 0;
  bool is_unknown = false;  // all value bits are 1: an unknown size
};
[[nodiscard]] std::optional<VariableInteger> read_variable_integer(
    std::span<const std::uint8_t> bytes);

}  // namespace roomcast::recording::matroska
