// SPDX-License-Identifier: Apache-2.0
// LongBody: the body of an HTTP answer that is read piece by piece while it is sent, because it may
// be larger than memory: a file. Threading: called on the server's door thread, which waits for
// each piece.
#pragma once

#include <cstdint>
#include <span>

#include "roomcast/core/result.h"

namespace roomcast::net {

class LongBody {
 public:
  virtual ~LongBody() = default;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// Fills `out` from `offset` on. An error ends the connection: the answer has begun.
  [[nodiscard]] virtual Status read(std::uint64_t offset, std::span<std::uint8_t> out) const = 0;
};

}  // namespace roomcast::net
