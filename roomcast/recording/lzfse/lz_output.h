// SPDX-License-Identifier: Apache-2.0
// LzOutput: decoded bytes up to a limit, with copies of earlier ones. Single-threaded.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace roomcast::recording {

class LzOutput {
 public:
  /// `bytes` gets at most `limit` bytes.
  LzOutput(std::vector<std::uint8_t>& bytes, std::size_t limit) : bytes_(bytes), limit_(limit) {
    bytes_.clear();
    bytes_.reserve(limit);
  }

  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] std::size_t left() const { return limit_ - bytes_.size(); }

  /// False, and nothing is done, if the limit would be exceeded.
  [[nodiscard]] bool append(std::span<const std::uint8_t> bytes) {
    if (bytes.size() > left()) return false;
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return true;
  }
  /// Copies `count` bytes from `distance` before the end; they may overlap what they become.
  [[nodiscard]] bool repeat(std::size_t distance, std::size_t count) {
    if (count > left() || distance == 0 || distance > bytes_.size()) return false;
    for (std::size_t i = 0; i < count; ++i) bytes_.push_back(bytes_[bytes_.size() - distance]);
    return true;
  }

 private:
  std::vector<std::uint8_t>& bytes_;
  const std::size_t limit_;
};

}  // namespace roomcast::recording
