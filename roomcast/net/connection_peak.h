// SPDX-License-Identifier: Apache-2.0
// ConnectionPeak: notices that most of very many connections have ended. The C library keeps the
// memory that they took for later ones (50 KB each under TLS), so a flood would leave a server
// several times its size for ever. Single-threaded.
#pragma once

#include <algorithm>
#include <cstddef>

namespace roomcast::net {

class ConnectionPeak {
 public:
  static constexpr std::size_t kMany = 256;  // fewer leave nothing worth to give back

  /// `open`: the connections now.
  void note(std::size_t open) { peak_ = std::max(peak_, open); }

  /// True if at least kMany and half of the peak have ended since the last true; the peak counts
  /// from here then.
  [[nodiscard]] bool has_fallen(std::size_t open) {
    note(open);
    if (peak_ - open < kMany || open > peak_ / 2) return false;
    peak_ = open;
    return true;
  }

  /// Whether has_fallen() can become true.
  [[nodiscard]] bool is_high() const { return peak_ >= kMany; }

 private:
  std::size_t peak_ = 0;
};

}  // namespace roomcast::net
