// SPDX-License-Identifier: Apache-2.0
// UnitCounter: the common part of all protocols. A stream is a sequence of units: a short header,
// then a body, which is a message or other data.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "bench/fanout/protocol.h"

namespace roomcast::bench {

class UnitCounter : public MessageCounter {
 public:
  struct Unit {
    std::size_t header_bytes = 0;
    std::size_t body_bytes = 0;
    bool is_message = false;     // the body is a message or its last piece
    bool is_first_piece = true;  // the body contains the number
    std::size_t number_offset = kNumberOffset;
  };

  bool take(std::span<const std::uint8_t> bytes, std::vector<std::uint32_t>& numbers) final;

 protected:
  /// The unit that begins with these bytes; nothing when more bytes are needed. Sets `broken`.
  virtual std::optional<Unit> parse(std::string_view front) = 0;
  bool broken = false;

 private:
  static constexpr std::size_t kLongestHeader = 16 * 1024;

  bool take_header(std::span<const std::uint8_t>& bytes);
  void take_body(std::span<const std::uint8_t>& bytes, std::vector<std::uint32_t>& numbers);

  std::string front_;  // the unit whose header is not complete
  Unit unit_;
  bool in_body_ = false;
  std::size_t body_taken_ = 0;
  std::array<std::uint8_t, kNumberOffset + 4> body_front_{};
};

}  // namespace roomcast::bench
