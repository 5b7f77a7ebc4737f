// SPDX-License-Identifier: Apache-2.0
// UnitCounter: what all the protocols have in common. A stream is a row of units: a short header,
// then a body, which is a message or something else.
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
    bool is_message = false;     // the body is one, or the last piece of one
    bool is_first_piece = true;  // the number is in here
    std::size_t number_offset = kNumberOffset;
  };

  bool take(std::span<const std::uint8_t> bytes, std::vector<std::uint32_t>& numbers) final;

 protected:
  /// What begins with these bytes; nothing when more of them are needed. Sets `broken`.
  virtual std::optional<Unit> parse(std::string_view front) = 0;
  bool broken = false;

 private:
  static constexpr std::size_t kLongestHeader = 16 * 1024;

  bool take_header(std::span<const std::uint8_t>& bytes);
  void take_body(std::span<const std::uint8_t>& bytes, std::vector<std::uint32_t>& numbers);

  std::string front_;  // of a unit whose header is not complete
  Unit unit_;
  bool in_body_ = false;
  std::size_t body_taken_ = 0;
  std::array<std::uint8_t, kNumberOffset + 4> body_front_{};
};

}  // namespace roomcast::bench
