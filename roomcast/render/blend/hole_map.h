// SPDX-License-Identifier: Apache-2.0
// HoleMap: where a picture shows no surface, so that what fills holes need not be drawn elsewhere.
// It is on the CPU, for software drivers: a graphics card draws everything sooner than its picture
// has come back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace roomcast::render {

class HoleMap {
 public:
  /// `depth`: rows of `width` pixels; 1 where nothing is seen.
  void find(std::span<const float> depth, int width);

  /// Whether there is a hole from pixel `first` to pixel `last`, both included and in the picture.
  [[nodiscard]] bool has_hole(const Eigen::Vector2i& first, const Eigen::Vector2i& last) const {
    return before(last.x() + 1, last.y() + 1) - before(first.x(), last.y() + 1) -
               before(last.x() + 1, first.y()) + before(first.x(), first.y()) >
           0;
  }

 private:
  [[nodiscard]] std::uint32_t before(int x, int y) const {
    return before_[static_cast<std::size_t>(y) * stride_ + static_cast<std::size_t>(x)];
  }

  /// Holes in the rows above y and the columns left of x, modulo 2^32.
  std::vector<std::uint32_t> before_;
  std::size_t stride_ = 0;
};

}  // namespace roomcast::render
