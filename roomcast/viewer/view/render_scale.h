// SPDX-License-Identifier: Apache-2.0
// RenderScale: the resolution of drawing as a share of the window's, chosen from measured drawing
// times so that drawing keeps up. Counterpart of the page's quality ladder
// (web/src/view/quality_ladder.ts). Pure.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <vector>

#include "roomcast/core/clock.h"

namespace roomcast::viewer {

class RenderScale {
 public:
  static constexpr std::array kScales = {1.0, 0.75, 0.5, 0.375, 0.25};
  static constexpr std::chrono::milliseconds kTooSlow{50};
  static constexpr std::chrono::milliseconds kQuick{15};  // below it, tries a finer picture
  static constexpr std::size_t kDrawsToJudge = 5;
  static constexpr std::chrono::seconds kPatience{3}, kLongestPatience{60};

  [[nodiscard]] double scale() const { return kScales[rung_]; }

  /// Reports the drawing time of one picture.
  void judge(nanoseconds drawing, HostTime now);

 private:
  void fall(HostTime now);

  std::size_t rung_ = 0;
  std::vector<nanoseconds> draws_;
  HostTime may_rise_{};
  std::chrono::seconds patience_ = kPatience;
  bool rose_last_ = false;
};

}  // namespace roomcast::viewer
